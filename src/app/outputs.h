// Where results go: their places are judged before the work, and all of them are written together
// after it. What can't go on is said on standard error, and comes back as an exit status.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace artisketch {

enum Exit { kDone = 0, kBadInput = 1, kBadCommandLine = 2, kNotWritten = 3, kStopped = 130 };

int fail(const Error& error);
int bad_command_line(const std::string& words);
void print_warnings(const std::vector<std::string>& warnings);

enum class Kind { model, document, picture, report, archive };

// A path to write to, and what it will hold; the path may be empty.
struct Target {
  const char* option;
  std::string path;
  Kind kind;
};

// Say what is wrong with where results are to go; kDone where nothing is. An ending may belong to
// another kind of file, a place not be there or closed, and what is read (`inputs`) or written to
// it, too.
int judge_endings(const std::vector<Target>& targets);
int judge_places(const std::vector<Target>& targets);
int judge_overwriting(const std::vector<Target>& targets, const std::vector<std::string>& inputs);

// What will be written, all of it made before anything is.
struct Output {
  std::string path, bytes;
};
int write_all(const std::vector<Output>& outputs);

}  // namespace artisketch

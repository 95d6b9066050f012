// The command line in the tests' own process, or the program in one of its own, with a folder that
// goes afterwards.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/cli.h"
#include "files/bytes.h"

namespace artisketch {

namespace fs = std::filesystem;

inline const std::string kCircles =
    ARTISKETCH_SOURCE_DIR "/assets/examples/circles/circles.artisketch";
inline const std::string kHero = ARTISKETCH_SOURCE_DIR "/assets/examples/hero/hero.artisketch";

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("artisketch-cli-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  // Runs the command; its exit status, and what it said in `out` and `err`.
  int run(const std::vector<std::string>& arguments) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status = run_cli(arguments);
    out = testing::internal::GetCapturedStdout();
    err = testing::internal::GetCapturedStderr();
    return status;
  }

  fs::path folder_;
  std::string out, err;
};

// The program in a process of its own, with less of something than it needs; its exit status.
class Limited : public CommandLine {
 protected:
  int run_with(int resource, rlim_t limit, const std::vector<std::string>& arguments) {
    const std::string said = path("said");
    const pid_t child = fork();
    if (child == 0) {
      const rlimit limits{limit, limit};
      if (!freopen(said.c_str(), "w", stderr) || !freopen("/dev/null", "w", stdout)) _exit(126);
      setrlimit(__rlimit_resource(resource), &limits);
      std::vector<char*> argv{const_cast<char*>("artisketch")};
      for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
      argv.push_back(nullptr);
      execv(ARTISKETCH_CLI, argv.data());
      _exit(127);
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    most_memory = 1024.0 * double(used.ru_maxrss);
    err = *read_file(said);
    fs::remove(said);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  double most_memory = 0;  // bytes that the last one took
};

}  // namespace artisketch

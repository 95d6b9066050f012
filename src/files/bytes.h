// Whole files in, whole files out; base64.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace artisketch {

// Fails (io) where the file cannot be opened or read, is a folder, or is larger than 1 GB; and on a
// pipe that nobody writes to.
Result<std::string> read_file(const std::string& path);

// Complete or absent: writes a temporary file beside `path`, syncs it, renames it, syncs the
// folder. The old file stays where anything fails, and the temporary one goes. A link keeps
// pointing where it does; what is no regular file (a pipe, /dev/null) is written to as it is.
Result<Done> write_file(const std::string& path, std::string_view bytes);

// The same for several, all or none: every one is written beside its place before the first takes
// it. What a process that was killed left in the folder goes after an hour.
struct NewFile {
  std::string path;
  std::string_view bytes;
};
Result<Done> write_files(std::span<const NewFile> files);

// What is alike for two paths to the same file, through links too, and for no others; of a file
// that isn't there its place counts. Pipes and devices are nobody's file: empty.
std::string file_identity(const std::string& path);

// Whether two paths name the same file.
bool same_file(const std::string& a, const std::string& b);

// RFC 4648, section 4, with padding. Decoding is strict: it fails on a foreign character, wrong
// padding or stray bits.
std::string base64(std::string_view bytes);
Result<std::string> from_base64(std::string_view text);

}  // namespace artisketch

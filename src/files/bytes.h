// Whole files in, whole files out; base64.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace artisketch {

// Fails (io) where the file cannot be opened or read, or is larger than 1 GB.
Result<std::string> read_file(const std::string& path);

// Complete or absent: writes a temporary file beside `path`, syncs it, renames it, syncs the
// folder. The old file stays where anything fails, and the temporary one goes. A link keeps
// pointing where it does; what is no regular file (a pipe, /dev/null) is written to as it is.
Result<Done> write_file(const std::string& path, std::string_view bytes);

// RFC 4648, section 4, with padding. Decoding is strict: it fails on a foreign character, wrong
// padding or stray bits.
std::string base64(std::string_view bytes);
Result<std::string> from_base64(std::string_view text);

}  // namespace artisketch

// Whole files in, whole files out.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace artisketch {

Result<std::string> read_file(const std::string& path);

// Complete or absent: writes a temporary file beside `path`, syncs it, renames it. The old file
// stays where anything fails.
Result<Done> write_file(const std::string& path, std::string_view bytes);

std::string base64(std::string_view bytes);
Result<std::string> from_base64(std::string_view text);

}  // namespace artisketch

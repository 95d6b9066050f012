// Several files as one.
#pragma once

#include <string>
#include <vector>

namespace artisketch {

struct FileInside {
  std::string name;  // UTF-8
  std::string bytes;
};

// A ZIP archive of the files as they are, uncompressed (APPNOTE.TXT 6.3, method 0), dated 1980: the
// same files give the same bytes. Together they must be less than 4 GB.
std::string zip_bytes(const std::vector<FileInside>& files);

}  // namespace artisketch

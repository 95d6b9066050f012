#include "seen_files.h"

#include <filesystem>

#include "files/bytes.h"

namespace artisketch {
namespace {

std::string without_links(const std::string& path) {
  std::error_code ignored;
  const auto whole = std::filesystem::weakly_canonical(path, ignored);
  return ignored ? path : whole.string();
}

}  // namespace

void SeenFiles::saw(const std::string& path, const std::string& bytes) {
  seen_[without_links(path)] = std::hash<std::string>()(bytes);
}

bool SeenFiles::changed(const std::string& path) const {
  const auto seen = seen_.find(without_links(path));
  if (seen == seen_.end()) return false;
  const Result<std::string> now = read_file(path);
  return now && std::hash<std::string>()(*now) != seen->second;
}

void SeenFiles::forget(const std::string& path) {
  seen_.erase(without_links(path));
}

}  // namespace artisketch

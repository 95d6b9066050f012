#include "app/version.h"

#include <string_view>

#include <artisketch_commit.h>  // made at build time, cmake/Commit.cmake

namespace artisketch {

std::string version_words() {
  constexpr std::string_view kCommit = ARTISKETCH_COMMIT;
  std::string words = "ArtiSketch " ARTISKETCH_VERSION;
  if (!kCommit.empty()) words += " (commit " + std::string(kCommit) + ")";
  return words;
}

}  // namespace artisketch

#include "app/command_words.h"

#include <algorithm>
#include <filesystem>

namespace artisketch {
namespace {

// Letters put in, left out, exchanged or swapped with the next (Damerau 1964).
int slips(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = int(i + j);
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string meant(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t kLongest = 40;
  if (word.size() > kLongest) return "";
  std::string best;
  int least = 1 + std::min(2, int(word.size()) / 3);
  for (const std::string& one : known) {
    const int away = word.size() > 1 && one.starts_with(word) ? 0 : slips(word, one);
    if (away < least) least = away, best = one;
  }
  return best;
}

std::string verb_fault(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with('-')) return "";
  const std::string& word = arguments[0];
  std::vector<std::string> verbs(std::begin(kVerbs), std::end(kVerbs));
  if (std::find(verbs.begin(), verbs.end(), word) != verbs.end()) return "";
  std::error_code ignored;
  if (word.ends_with(".artisketch") || std::filesystem::exists(word, ignored))
    return "artisketch " + word +
           ": what is to be done with it? To make a model: artisketch "
           "reconstruct " +
           word + " -o MODEL.glb";
  for (const char* option : {"help", "version"})
    if (word == option) return "artisketch " + word + ": did you mean artisketch --" + word + "?";
  const std::string near = meant(word, verbs);
  return "artisketch " + word + ": there is no such verb" +
         (near.empty() ? "" : "; did you mean " + near + "?") + (near.empty() ? ";" : "") +
         " The verbs are reconstruct, calibrate, check, render, sprites and skeleton";
}

}  // namespace artisketch

// Words: numbers and their nouns as people read them, and letters of either case.
#pragma once

#include <string>
#include <string_view>

namespace artisketch {

inline std::string plural(long long n, const std::string& one) {
  return n == 1 ? one : one + "s";
}

// "1 part", "3 parts".
inline std::string counted(long long n, const std::string& one) {
  return std::to_string(n) + " " + plural(n, one);
}

// A to Z as a to z, whatever the locale: for what files and commands name in either case.
inline std::string lower_case(std::string_view words) {
  std::string lower(words);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return lower;
}

}  // namespace artisketch

// Numbers and their nouns, in the words that people read.
#pragma once

#include <string>

namespace artisketch {

inline std::string plural(long long n, const std::string& one) {
  return n == 1 ? one : one + "s";
}

// "1 part", "3 parts".
inline std::string counted(long long n, const std::string& one) {
  return std::to_string(n) + " " + plural(n, one);
}

}  // namespace artisketch

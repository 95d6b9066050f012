// Damage to bytes: the same on every machine and in every run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace artisketch {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : state_(seed) {}

  // One to four changes: a bit, a byte, a stretch cut out or doubled, a number or word put in the
  // place of another.
  std::string damaged(std::string bytes) {
    for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) {
      const std::size_t at = below(bytes.size());
      const std::size_t length = 1 + below(std::min<std::size_t>(bytes.size() - at, 40));
      switch (below(6)) {
        case 0:
          bytes[at] = char(bytes[at] ^ 1 << below(8));
          break;
        case 1:
          bytes[at] = char(below(256));
          break;
        case 2:
          bytes.erase(at, length);
          break;
        case 3:
          bytes.insert(below(bytes.size()), bytes.substr(at, length));
          break;
        default:
          replace_token(bytes, at);
      }
    }
    return bytes;
  }

  // Changes that keep the length, so that a binary's headers still fit: digits, bits, bytes.
  std::string scratched(std::string bytes) {
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      const std::size_t at = below(bytes.size());
      const std::size_t digit = bytes.find_first_of("0123456789", at);
      if (below(2) && digit != bytes.npos)
        bytes[digit] = char('0' + below(10));
      else if (below(2))
        bytes[at] = char(bytes[at] ^ 1 << below(8));
      else
        bytes[at] = char(below(256));
    }
    return bytes;
  }

 private:
  // SplitMix64 (Steele, Lea and Flood 2014).
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  std::size_t below(std::size_t n) { return std::size_t(next() % n); }

  void replace_token(std::string& bytes, std::size_t at) {
    static const std::vector<std::string_view> kTokens = {"null",
                                                          "true",
                                                          "-1",
                                                          "0",
                                                          "-0.0",
                                                          "1e308",
                                                          "-1e999",
                                                          "5e-324",
                                                          "18446744073709551616",
                                                          "NaN",
                                                          "\"\"",
                                                          "[]",
                                                          "{}",
                                                          "[[1,2],[3]]",
                                                          "\"\\ud800\"",
                                                          "\"\\u0000\"",
                                                          "2147483648",
                                                          "\"body\"",
                                                          "\xff",
                                                          "{\"a\":1,\"a\":2}"};
    const char* const kInToken = "0123456789+-.eEnulltruefalse";
    const std::size_t start = bytes.find_first_of("0123456789-\"[{", at);
    if (start == bytes.npos) return;
    std::size_t end = start + 1;
    if (bytes[start] == '"')
      end = std::min(bytes.find('"', end), bytes.size() - 1) + 1;
    else
      end = std::min(bytes.find_first_not_of(kInToken, end), bytes.size());
    bytes.replace(start, end - start, kTokens[below(kTokens.size())]);
  }

  std::uint64_t state_;
};

}  // namespace artisketch

// What libFuzzer's FuzzedDataProvider gives, from a seed: the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace artisketch::fuzz {

class RandomBytes {
 public:
  explicit RandomBytes(std::uint64_t seed) : engine_(seed) {}

  bool ConsumeBool() { return engine_() & 1; }
  template <class T>
  T ConsumeIntegralInRange(T low, T high) {
    return T(low + T(engine_() % (std::uint64_t(high) - std::uint64_t(low) + 1)));
  }
  double ConsumeFloatingPointInRange(double low, double high) {
    return low + (high - low) * (double(engine_() >> 11) * 0x1p-53);
  }
  std::string ConsumeRandomLengthString(std::size_t most) {
    std::string text(ConsumeIntegralInRange<std::size_t>(0, most), ' ');
    for (char& c : text) c = char(ConsumeIntegralInRange(0, 255));
    return text;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace artisketch::fuzz

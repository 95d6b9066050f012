// Random numbers that are the same on every machine: the standard fixes the engine's raw output
// but not its distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "base/types.h"

namespace artisketch::figures {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform() { return double(engine_() >> 11) * 0x1p-53; }  // [0, 1)
  double between(double low, double high) { return low + (high - low) * uniform(); }
  double around(double mean, double spread) { return between(mean - spread, mean + spread); }
  bool chance(double probability) { return uniform() < probability; }
  double gaussian() {  // Box–Muller
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * kPi * uniform());
  }
  Vec3 direction() {  // uniform on the sphere
    const double z = between(-1, 1), turn = between(0, 2 * kPi), r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace artisketch::figures

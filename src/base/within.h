// Numbers that become indices.
#pragma once

#include <algorithm>

namespace artisketch {

// The number from `low` to `high` nearest to x; low where x is NaN, which std::clamp would let
// through: cast to an index it would be none.
inline double within(double x, double low, double high) {
  return std::min(std::max(low, x), high);  // of two that don't compare each returns its first
}

}  // namespace artisketch

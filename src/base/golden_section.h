// The least of a function along a line, without its derivative.
#pragma once

namespace artisketch {

struct Minimum {
  double at = 0, value = 0;  // the best of the places that were looked at
  double low = 0, high = 0;  // what is left of the range; the least lies between
};

// Golden-section search (Kiefer 1953): `steps` times it keeps 0.618 of low … high, about the least
// of a function that falls and then rises there. Where it is level, the lower part is kept.
template <class Function>
Minimum golden_section(double low, double high, int steps, const Function& f) {
  constexpr double kShare = 0.61803398874989485;  // (√5 − 1) / 2
  double a = high - kShare * (high - low), b = low + kShare * (high - low);
  double at_a = f(a), at_b = f(b);
  for (int i = 0; i < steps; ++i)
    if (at_a <= at_b) {
      high = b;
      b = a, at_b = at_a;
      a = high - kShare * (high - low), at_a = f(a);
    } else {
      low = a;
      a = b, at_a = at_b;
      b = low + kShare * (high - low), at_b = f(b);
    }
  return at_a <= at_b ? Minimum{a, at_a, low, high} : Minimum{b, at_b, low, high};
}

}  // namespace artisketch

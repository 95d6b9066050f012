// Sine and cosine that are the same to the last bit on every machine: each system's library rounds
// in its own way, and a search that follows a last bit ends elsewhere. Within 2 units in the last
// place of the truth for |x| < 1000.
#pragma once

#include <cmath>

namespace artisketch {
namespace detail {

// Taylor series on |x| ≤ π/4: the first term left out is below a quarter of the last place.
inline double sine_near_zero(double x) {
  const double q = x * x;
  double sum = -1.0 / 1307674368000.0;  // 15!
  sum = sum * q + 1.0 / 6227020800.0;
  sum = sum * q - 1.0 / 39916800.0;
  sum = sum * q + 1.0 / 362880.0;
  sum = sum * q - 1.0 / 5040.0;
  sum = sum * q + 1.0 / 120.0;
  sum = sum * q - 1.0 / 6.0;
  return x + x * (q * sum);
}

inline double cosine_near_zero(double x) {
  const double q = x * x;
  double sum = 1.0 / 20922789888000.0;  // 16!
  sum = sum * q - 1.0 / 87178291200.0;
  sum = sum * q + 1.0 / 479001600.0;
  sum = sum * q - 1.0 / 3628800.0;
  sum = sum * q + 1.0 / 40320.0;
  sum = sum * q - 1.0 / 720.0;
  sum = sum * q + 1.0 / 24.0;
  return 1 - (q / 2 - q * (q * sum));
}

// sin(x + quarters · π/2), π/2 in three parts that lose nothing (Cody and Waite 1980).
inline double sine_of(double x, int quarters) {
  const double turns = std::nearbyint(x * 0.63661977236758134308);
  const double rest =
      ((x - turns * 1.57079632673412561417e+00) - turns * 6.07710050630396597660e-11) -
      turns * 2.02226624879595063154e-21;
  const int quadrant = int((static_cast<long long>(turns) + quarters) & 3);
  const double value = quadrant % 2 ? cosine_near_zero(rest) : sine_near_zero(rest);
  return quadrant < 2 ? value : -value;
}

}  // namespace detail

inline double sine(double x) {
  return detail::sine_of(x, 0);
}
inline double cosine(double x) {
  return detail::sine_of(x, 1);
}

// The angle of (x, y), −π … π, within 4 units in the last place: one of Newton's steps from an
// angle rounded so far that all systems round it alike.
inline double arctangent(double y, double x) {
  const double near = static_cast<float>(std::atan2(y, x));
  const double s = sine(near), c = cosine(near);
  const double along = x * c + y * s;
  return along > 0 ? near + (y * c - x * s) / along : near;
}

}  // namespace artisketch

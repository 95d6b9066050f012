#include "base/trigonometry.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/types.h"

namespace artisketch {
namespace {

constexpr double kLastPlace = 0x1p-52;

TEST(Trigonometry, WithinTwoUnitsInTheLastPlace) {
  for (double x = -1000; x < 1000; x += 0.0173) {
    ASSERT_NEAR(sine(x), std::sin(x), 2 * kLastPlace * std::max(std::abs(std::sin(x)), 1e-3)) << x;
    ASSERT_NEAR(cosine(x), std::cos(x), 2 * kLastPlace * std::max(std::abs(std::cos(x)), 1e-3))
        << x;
  }
}

TEST(Trigonometry, ExactWhereTheTruthIs) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(sine(1e-300), 1e-300);
  EXPECT_EQ(sine(-0.5), -sine(0.5));
  EXPECT_EQ(cosine(-2.5), cosine(2.5));
  EXPECT_EQ(sine(kPi / 2), 1);
  EXPECT_EQ(cosine(kPi), -1);
}

TEST(Trigonometry, TheSameBitsEverywhere) {
  // Noted down once; every compiler and machine must agree.
  EXPECT_EQ(sine(0.7), 0x1.49d6e694619b8p-1);
  EXPECT_EQ(cosine(0.7), 0x1.87996529f9d93p-1);
  EXPECT_EQ(sine(123.456), -0x1.9b9dadc41aeb6p-1);
}

TEST(Trigonometry, ArctangentIsTheSystemsWithinItsLastPlaces) {
  for (int i = 0; i < 4000; ++i) {
    const double angle = (i - 2000) * 0.0015707, length = std::exp((i % 41) - 20.0);
    const double x = length * std::cos(angle), y = length * std::sin(angle);
    EXPECT_NEAR(arctangent(y, x), std::atan2(y, x), 4e-16 * (1 + std::abs(angle))) << angle;
  }
  EXPECT_EQ(arctangent(0, 0), 0);
}

}  // namespace
}  // namespace artisketch

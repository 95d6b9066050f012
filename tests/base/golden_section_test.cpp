#include "base/golden_section.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(GoldenSection, ComesAsNearAsItsStepsAllow) {
  for (const double least : {-0.9, 0.0, 0.31, 0.99}) {
    const auto f = [&](double x) { return std::abs(x - least); };
    double within = 2 * 0.62;
    for (const int steps : {0, 1, 5, 20}) {
      const Minimum found = golden_section(-1, 1, steps, f);
      within = 2 * std::pow(0.6181, steps + 1);
      EXPECT_LE(std::abs(found.at - least), within) << least << " in " << steps;
      EXPECT_EQ(found.value, f(found.at));
    }
  }
}

TEST(GoldenSection, LooksOnceAtEachPlace) {
  int calls = 0;
  golden_section(0, 1, 10, [&](double x) { return ++calls, x * x; });
  EXPECT_EQ(calls, 12);
}

}  // namespace
}  // namespace artisketch

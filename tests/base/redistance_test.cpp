#include "base/redistance.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

template <class Distance>
Grid3<float> sampled(const Distance& distance) {
  Grid3<float> g(Vec3(-1.3, -1.3, -1.3), 0.05, Index3(53, 53, 53));
  for (int k = 0; k < 53; ++k)
    for (int j = 0; j < 53; ++j)
      for (int i = 0; i < 53; ++i) g(i, j, k) = float(distance(g.position(i, j, k)));
  return g;
}

TEST(Redistance, FindsTheDistanceToABallFromAFieldThatIsNone) {
  Grid3<float> g = sampled([](const Vec3& p) { return 5 * (p.squaredNorm() - 1); });
  redistance(3, g);
  double sum = 0;
  for (int k = 0; k < 53; ++k)
    for (int j = 0; j < 53; ++j)
      for (int i = 0; i < 53; ++i) {
        const double truth = g.position(i, j, k).norm() - 1;
        const double within = std::clamp(truth, -3 * g.cell, 3 * g.cell);
        const double error = std::abs(g(i, j, k) - within) / g.cell;
        EXPECT_LT(error, 0.3);
        sum += error;
      }
  EXPECT_LT(sum / double(g.values.size()), 0.01);
}

TEST(Redistance, KeepsEverySign) {
  const auto wavy = [](const Vec3& p) {
    return std::sin(4 * p.x()) + std::sin(5 * p.y()) * std::cos(3 * p.z());
  };
  const Grid3<float> before = sampled(wavy);
  Grid3<float> after = before;
  redistance(2, after);
  for (std::size_t i = 0; i < before.values.size(); ++i) {
    EXPECT_EQ(std::signbit(before.values[i]), std::signbit(after.values[i]));
    EXPECT_LE(std::abs(after.values[i]), float(2 * after.cell));
  }
}

// Around a corner the nearest points are shared: the distance to a box outside is a ball's there.
TEST(Redistance, GoesAroundCorners) {
  const auto box = [](const Vec3& p) { return p.cwiseAbs().maxCoeff() - 0.63; };
  Grid3<float> g = sampled(box);
  redistance(3, g);
  for (int n = 0; n < 53; ++n) {
    const Vec3 p = g.position(n, n, n);
    const double truth = (p.cwiseAbs() - Vec3::Constant(0.63)).norm();
    if (!(box(p) > 0 && truth < 2.5 * g.cell)) continue;
    EXPECT_NEAR(g(n, n, n), truth, 0.5 * g.cell);
  }
}

TEST(Redistance, WithoutAZeroSetAllIsFar) {
  Grid3<float> g = sampled([](const Vec3&) { return 0.01; });
  redistance(3, g);
  for (const float v : g.values) EXPECT_FLOAT_EQ(v, float(3 * g.cell));
}

}  // namespace
}  // namespace artisketch

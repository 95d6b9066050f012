#include "base/narrow_band.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

constexpr int kSize = 41;
constexpr double kMiddle = 20;

Grid3<float> ball(double radius) {
  Grid3<float> phi({0, 0, 0}, 1, Index3::Constant(kSize));
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i)
        phi(i, j, k) = float((Vec3(i, j, k) - Vec3::Constant(kMiddle)).norm() - radius);
  return phi;
}

double radius_at(int index) {
  const Vec3 p(index % kSize, index / kSize % kSize, index / kSize / kSize);
  return (p - Vec3::Constant(kMiddle)).norm();
}

TEST(NarrowBand, LaysDistancesFromSignsThatAreRight) {
  Grid3<float> phi = ball(12.3);
  for (float& v : phi.values) v *= 0.5f;  // the zero set stays, the distances are wrong
  NarrowBand band(phi, 3);
  band.lay();
  for (const NarrowBand::Cell& cell : band.cells()) {
    const double distance = radius_at(cell.index) - 12.3;
    EXPECT_NEAR(band.phi().values[cell.index], distance, std::abs(distance) < 1.2 ? 0.3 : 0.46);
  }
  int in_band = 0;
  for (std::size_t i = 0; i < phi.values.size(); ++i) {
    const double distance = radius_at(int(i)) - 12.3;
    EXPECT_EQ(band.phi().values[i] < 0, distance < 0);
    in_band += std::abs(distance) < 2.7;
  }
  EXPECT_GE(int(band.cells().size()), in_band);
}

TEST(NarrowBand, CurvatureOfABallIsTwoOverItsRadius) {
  const NarrowBand band(ball(10), 3);
  double sum = 0;
  for (const NarrowBand::Front& f : band.front()) sum += band.curvature(f);
  EXPECT_NEAR(sum / double(band.front().size()), 0.2, 0.02);
}

TEST(NarrowBand, NormalsPointOutward) {
  const NarrowBand band(ball(10), 3);
  for (const NarrowBand::Front& f : band.front())
    EXPECT_GT(f.normal.dot((f.at.cast<double>() - Vec3::Constant(kMiddle)).normalized()), 0.99);
}

// Where a camera sees nothing a hull is infinitely far outside, right beside the surface.
TEST(NarrowBand, BesideWhatIsInfinitelyFarAllStaysANumber) {
  Grid3<float> phi = ball(8);
  for (float& v : phi.values)
    if (v > 0.9f) v = std::numeric_limits<float>::infinity();
  NarrowBand band(phi, 3);
  for (int i = 0; i < 20; ++i) {
    const std::vector<float> way(band.front().size(), 0.1f);
    band.move(way, [&](int index) { return phi.values[index] - 0.5f; });
    for (const NarrowBand::Front& f : band.front()) ASSERT_TRUE(f.normal.allFinite());
    for (const float v : band.phi().values) ASSERT_TRUE(std::isfinite(v));
  }
  EXPECT_FALSE(band.front().empty());
}

// Growing by a tenth of a cell fifty times is growing by five cells, through many new bands.
TEST(NarrowBand, MovesAsFarAsToldAndNoFartherThanAllowed) {
  NarrowBand band(ball(8), 3);
  const float outmost = 11.5f;
  for (int step = 0; step < 50; ++step) {
    const std::vector<float> way(band.front().size(), 0.1f);
    band.move(way, [&](int index) { return float(radius_at(index)) - outmost; });
    if (step == 29) {
      band.lay();
      for (const NarrowBand::Front& f : band.front())
        EXPECT_NEAR(radius_at(f.index) - band.phi().values[f.index], 11, 0.3);
    }
  }
  band.lay();
  for (const NarrowBand::Front& f : band.front())
    EXPECT_NEAR(radius_at(f.index) - band.phi().values[f.index], outmost, 0.1);
}

TEST(NarrowBand, ValuesAtTheSurfaceAreInterpolatedAcrossIt) {
  const NarrowBand band(ball(10.25), 3);
  std::vector<float> radii;
  for (const NarrowBand::Front& f : band.front()) radii.push_back(float(radius_at(f.index)));
  for (int f = 0; f < int(radii.size()); ++f) EXPECT_NEAR(band.at_surface(f, radii), 10.25, 0.06);
}

TEST(NarrowBand, OfNothingIsEmpty) {
  NarrowBand band(Grid3<float>({0, 0, 0}, 1, {5, 5, 5}, 9.f), 3);
  EXPECT_TRUE(band.front().empty());
  EXPECT_TRUE(band.cells().empty());
}

// A ball cut off by the grid's border, which does not reach into the grid.
TEST(NarrowBand, HoldsAtTheBorder) {
  NarrowBand band(ball(22), 3);
  for (int step = 0; step < 20; ++step) {
    const std::vector<float> way(band.front().size(), -0.1f);
    band.move(way, [](int) { return -1e9f; });
  }
  band.lay();
  EXPECT_FALSE(band.front().empty());
  for (const NarrowBand::Front& f : band.front())
    if (f.at.minCoeff() >= 3 && f.at.maxCoeff() < kSize - 3) {
      EXPECT_NEAR(radius_at(f.index) - band.phi().values[f.index], 20, 0.25);
    }
}

}  // namespace
}  // namespace artisketch

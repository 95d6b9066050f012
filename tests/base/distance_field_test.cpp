#include "base/distance_field.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/grid.h"

namespace artisketch {
namespace {

std::vector<Vec2> circle(const Vec2& centre, double radius, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back(centre + radius * Vec2(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n)));
  return points;
}

double brute_force(const std::vector<std::vector<Vec2>>& polygons, const Vec2& p) {
  double best = 1e300;
  bool inside = false;
  for (const auto& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()], d = b - a;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (p - a - t * d).norm());
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        inside = !inside;
    }
  return inside ? -best : best;
}

TEST(PolygonDistance, MatchesBruteForceOnARingAndASpike) {
  const std::vector<std::vector<Vec2>> polygons = {
      circle({50, 50}, 40, 90), circle({50, 50}, 15, 30), {{100, 10}, {300, 12}, {101, 14}}};
  const PolygonDistance field(polygons);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(-100, 400), y(-100, 200);
  for (int i = 0; i < 5000; ++i) {
    const Vec2 p(x(random), y(random));
    ASSERT_NEAR(field.distance(p), brute_force(polygons, p), 1e-9) << p.transpose();
  }
}

TEST(PolygonDistance, GradientIsTheUnitVectorOutward) {
  const PolygonDistance field(std::vector<std::vector<Vec2>>{circle({0, 0}, 10, 720)});
  for (const double r : {2.0, 9.0, 11.0, 30.0}) {
    Vec2 g;
    field.distance(Vec2(0.6, 0.8) * r, g);
    EXPECT_NEAR(g.dot(Vec2(0.6, 0.8)), 1, 1e-3);
    EXPECT_NEAR(g.norm(), 1, 1e-9);
  }
}

TEST(PolygonDistance, WithoutPolygonsEverythingIsFarOutside) {
  EXPECT_GT(PolygonDistance().distance({0, 0}), 1e300);
  EXPECT_TRUE(PolygonDistance().empty());
}

TEST(PolygonDistance, WhatIsNoNumberIsNoLineAndNowhere) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const std::vector<Vec2> good = circle({0, 0}, 10, 16);
  const PolygonDistance alone(std::vector<std::vector<Vec2>>{good});
  for (const double wrong : {nan, infinite, -infinite, 1e300}) {
    const PolygonDistance beside(
        std::vector<std::vector<Vec2>>{good, {{0, 0}, {wrong, 1}, {2, 2}}});
    for (const Vec2& p : {Vec2(1, 2), Vec2(30, -4)})
      EXPECT_EQ(beside.distance(p), alone.distance(p)) << wrong;
    for (const Vec2& p : {Vec2(wrong, 0), Vec2(0, wrong), Vec2(wrong, wrong)}) {
      Vec2 gradient;
      EXPECT_FALSE(alone.inside(p));
      EXPECT_GE(alone.distance(p, gradient), 1e299);
      EXPECT_TRUE(gradient.allFinite());
    }
  }
  EXPECT_TRUE(PolygonDistance(std::vector<std::vector<Vec2>>{{{nan, 0}, {1, 1}, {2, 0}}}).empty());
}

TEST(Grid3, IsSampledWithinItselfWhateverIsAsked) {
  Grid3<float> grid(Vec3::Zero(), 1, Index3(3, 3, 3));
  for (int i = 0; i < 27; ++i) grid.values[std::size_t(i)] = float(i % 3);  // x
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sample(grid, Vec3(1.5, 1, 1)), 1.5);
  EXPECT_EQ(sample(grid, Vec3(infinite, nan, -infinite)), 2);
  EXPECT_EQ(sample(grid, Vec3(nan, nan, nan)), 0);
  EXPECT_EQ(sample(grid, Vec3(1e300, 1, 1)), 2);
}

TEST(SampledDistance, StaysWithinATenthOfAPixel) {
  const PolygonDistance exact(std::vector<std::vector<Vec2>>{circle({60, 40}, 25, 100)});
  const SampledDistance sampled(exact, 1, 20);
  for (double y = -4; y < 84; y += 3.7)
    for (double x = 16; x < 104; x += 3.3) {
      if (std::hypot(x - 60, y - 40) < 3) continue;  // at the centre the distance has a corner
      EXPECT_NEAR(sampled.distance({x, y}), exact.distance({x, y}), 0.1);
    }
  EXPECT_NEAR(sampled.distance({400, 40}), exact.distance({400, 40}),
              3);  // beyond the raster: roughly
}

TEST(SampledDistance, AgreesWithTheExactOneAtItsSamplesWhateverTheOutline) {
  // A ring, a spike, a sliver thinner than a sample, a piece outside the others.
  const std::vector<std::vector<Vec2>> polygons = {
      circle({50.3, 50.1}, 40, 90),
      circle({50, 50}, 15, 30),
      {{100, 10}, {300, 12}, {101, 14}},
      {{120, 60}, {120.4, 60}, {200.4, 140}, {200, 140}}};
  const PolygonDistance exact(polygons);
  for (const double per_pixel : {0.5, 1.0, 2.0}) {
    const SampledDistance sampled(exact, per_pixel, 20);
    const Vec2 origin = exact.box().min() - Vec2::Constant(20);
    for (int y = 0; y < 160 * per_pixel; y += 3)
      for (int x = 0; x < 320 * per_pixel; x += 3) {
        const Vec2 p = origin + Vec2(x, y) / per_pixel;
        ASSERT_NEAR(sampled.distance(p), exact.distance(p), 0.1 / per_pixel) << p.transpose();
      }
  }
}

}  // namespace
}  // namespace artisketch

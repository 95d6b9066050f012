#include "model/surface/held_back.h"

#include <gtest/gtest.h>

#include "model/surface/hermite_surface.h"

namespace artisketch {
namespace {

Grid3<float> ball_distance(double radius) {
  Grid3<float> field(Vec3::Constant(-1.5), 0.05, Index3::Constant(61));
  for (int k = 0; k < field.size.z(); ++k)
    for (int j = 0; j < field.size.y(); ++j)
      for (int i = 0; i < field.size.x(); ++i)
        field(i, j, k) = float(field.position(i, j, k).norm() - radius);
  return field;
}

TEST(HeldBack, WhatBulgesOutOfTheHullIsHeldOnItsSurface) {
  const Grid3<float> hull = ball_distance(1);
  const std::vector<Vec3> points = held_back(ball_distance(1.1), hull, 1);
  ASSERT_GT(points.size(), 50u);
  Box3 box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].norm(), 1, 0.01);
    box.extend(points[i]);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE((points[i] - points[j]).norm(), 0.1);
  }
  EXPECT_GT(box.sizes().minCoeff(), 1.8) << "all round";
}

TEST(HeldBack, WhatLiesInsideIsLeftAlone) {
  EXPECT_TRUE(held_back(ball_distance(0.9), ball_distance(1), 1).empty());
  EXPECT_TRUE(held_back(ball_distance(1.02), ball_distance(1), 1).empty());
}

// Six points of a ball with their slopes; one more without, nearer to its middle.
TEST(HeldBack, ALoosePointDrawsTheSurfaceToItself) {
  std::vector<SurfacePoint> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) {
      const Vec3 normal = side * Vec3::Unit(axis);
      points.push_back({normal, normal, Vec3::Unit((axis + 1) % 3), 1});
    }
  HermiteOptions options;
  options.length = 1;
  const Vec3 held = 0.8 * Vec3::Ones().normalized();
  const HermiteSurface free(points, options), drawn(points, options, std::span(&held, 1));
  EXPECT_LT(free.value(held), -0.04);
  EXPECT_NEAR(drawn.value(held), 0, 0.02);
  for (const SurfacePoint& point : points) EXPECT_NEAR(drawn.value(point.position), 0, 0.02);
  EXPECT_NEAR(drawn.value(-held), free.value(-held), 0.03) << "on the other side as before";
}

}  // namespace
}  // namespace artisketch

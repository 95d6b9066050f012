#include "base/vector_flow.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

std::vector<VectorFlow::Segment> circle(const Vec2& centre, double radius) {
  std::vector<VectorFlow::Segment> segments;
  const auto at = [&](int i) {
    return Vec2(centre + radius * Vec2(std::cos(i * kPi / 60), std::sin(i * kPi / 60)));
  };
  for (int i = 0; i < 120; ++i) segments.emplace_back(at(i), at(i + 1));
  return segments;
}

TEST(VectorFlow, PointsToTheLineFromBothSides) {
  const VectorFlow flow(circle({100, 80}, 60), 3);
  const Vec2 direction(0.6, 0.8);
  for (const double r : {45.0, 51.0, 56.0}) {
    EXPECT_GT(flow.at(Vec2(100, 80) + r * direction).flow.dot(direction), 0) << r;
    EXPECT_LT(flow.at(Vec2(100, 80) + (120 - r) * direction).flow.dot(direction), 0) << r;
  }
}

// Beyond where the edge map itself is felt.
TEST(VectorFlow, ReachesFartherThanTheEdgeMap) {
  const VectorFlow flow(circle({100, 80}, 60), 3);
  const Vec2 p(100 + 60 - 18, 80);
  EXPECT_LT(flow.at(p).edge, 1e-3);
  EXPECT_GT(flow.at(p).flow.x(), 0.01);
}

TEST(VectorFlow, VanishesOnTheLineWhereTheEdgeIs) {
  const VectorFlow flow(circle({100, 80}, 60), 1);
  const VectorFlow::Value on = flow.at({160, 80});
  EXPECT_GT(on.edge, 0.9);
  EXPECT_LT(on.flow.norm(), 0.05);
}

TEST(VectorFlow, IsNothingFarAwayAndWithoutLines) {
  const VectorFlow flow(circle({100, 80}, 60), 3);
  EXPECT_EQ(flow.at({1000, 80}).flow.norm(), 0);
  EXPECT_EQ(VectorFlow({}, 3).at({0, 0}).edge, 0);
  EXPECT_EQ(VectorFlow().at({std::nan(""), 0}).edge, 0);
}

}  // namespace
}  // namespace artisketch

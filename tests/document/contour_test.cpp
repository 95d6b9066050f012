#include "document/contour.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

Polyline box(double x, double y, double w, double h) {
  return {{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true};
}

TEST(Contour, SelfCrossingIsFoundWhereItIs) {
  EXPECT_FALSE(self_crossing(box(0, 0, 10, 5)));
  const Polyline bow{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, true};
  ASSERT_TRUE(self_crossing(bow));
  EXPECT_NEAR((*self_crossing(bow) - Vec2(5, 5)).norm(), 0, 1e-9);
  const Polyline open{{{0, 0}, {10, 0}, {10, 10}}, false};
  EXPECT_FALSE(self_crossing(open));
}

TEST(Contour, AFoldBackOnItselfIsACrossing) {
  EXPECT_TRUE(self_crossing({{{0, 0}, {10, 0}, {5, 0}, {5, 8}}, true}));
}

TEST(Contour, ResamplingKeepsLengthAndEnds) {
  const Polyline line{{{0, 0}, {10, 0}, {10, 5}}, false};
  const Polyline fine = resampled(line, 0.7);
  EXPECT_EQ(fine.points.front(), line.points.front());
  EXPECT_EQ(fine.points.back(), line.points.back());
  EXPECT_NEAR(length(fine), 15, 0.5);
  for (std::size_t i = 0; i + 1 < fine.points.size(); ++i)
    EXPECT_LE((fine.points[i + 1] - fine.points[i]).norm(), 0.7 + 1e-9);
}

TEST(Contour, CentroidCountsHolesOut) {
  const std::vector<Polyline> lines = {box(0, 0, 10, 10), box(5, 0.5, 4, 9)};
  const Vec2 expected = (Vec2(5, 5) * 100 - Vec2(7, 5) * 36) / 64;
  EXPECT_NEAR((centroid(lines) - expected).norm(), 0, 1e-9);
  EXPECT_NEAR(signed_area(lines[0]), 100, 1e-12);
}

}  // namespace
}  // namespace artisketch

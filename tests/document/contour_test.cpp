#include "document/contour.h"

#include <cmath>
#include <random>

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

TEST(Contour, ATouchIsNoCrossing) {
  // Two squares that meet in the vertex (10, 10): run through as one line they touch or cross
  // there, by the order of the corners.
  const Polyline touch{{{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}, {0, 10}},
                       true};
  EXPECT_FALSE(self_crossing(touch));
  const Polyline through{
      {{0, 0}, {10, 0}, {10, 10}, {10, 20}, {20, 20}, {20, 10}, {10, 10}, {0, 10}}, true};
  ASSERT_TRUE(self_crossing(through));
  EXPECT_EQ(*self_crossing(through), Vec2(10, 10));
  // A tip that touches a side from within, and one that pokes through it.
  const auto tip = [](double x) {
    return Polyline{{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 8}, {x, 5}, {0, 2}}, true};
  };
  EXPECT_FALSE(self_crossing(tip(9)));
  EXPECT_FALSE(self_crossing(tip(10)));
  EXPECT_TRUE(self_crossing(tip(10.5)));
  // An open stroke that ends on itself.
  EXPECT_FALSE(self_crossing({{{0, 0}, {10, 0}, {10, 10}, {5, 0}}, false}));
  EXPECT_TRUE(self_crossing({{{0, 0}, {10, 0}, {10, 10}, {5, -1}}, false}));
}

TEST(Contour, ADoubledStretchIsACrossing) {
  // A bridge to a hole, run through both ways; and a spike.
  EXPECT_TRUE(self_crossing(
      {{{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, 7}, {4, 6}, {6, 6}, {5, 7}, {5, 10}, {0, 10}},
       true}));
  EXPECT_TRUE(self_crossing({{{0, 0}, {10, 0}, {10, 10}, {10, 20}, {10, 10}, {0, 10}}, true}));
}

TEST(Contour, RepeatedPointsAreNoCrossing) {
  const Polyline repeated{{{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}, {10, 10}, {0, 0}}, true};
  EXPECT_FALSE(self_crossing(repeated));
  EXPECT_FALSE(self_crossing({{{3, 3}, {3, 3}, {3, 3}}, true}));
  EXPECT_FALSE(self_crossing({{}, true}));
}

TEST(Contour, CrossingsAreFoundAsByComparingAllPairs) {
  std::mt19937 random(5);
  const auto number = [&] { return double(random() % 1000) / 10; };
  int crossing = 0;
  for (int round = 0; round < 3000; ++round) {
    Polyline line;
    line.closed = round % 2;
    const int n = 3 + int(random() % 6);
    // Mostly general position; every third on a coarse lattice, where lines touch and overlap.
    for (int i = 0; i < n; ++i)
      line.points.push_back(round % 3 ? Vec2(number(), number())
                                      : Vec2(double(random() % 5), double(random() % 5)));
    bool expected = false;
    for (std::size_t i = 0; i < line.segments(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) {
          return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
        };
        const Vec2 &a = line.points[i], &b = line.end_of(i), &c = line.points[j],
                   &d = line.end_of(j);
        expected |= side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
      }
    if (expected || round % 3) {
      EXPECT_EQ(bool(self_crossing(line)), expected) << round;
    }
    crossing += expected;
  }
  EXPECT_GT(crossing, 500);
  EXPECT_LT(crossing, 2500);
}

TEST(Contour, NoShapeMakesTheSearchSlow) {
  // Long strokes side by side, and a crowd with one point far away: both defeat grids and boxes.
  Polyline hatch, crowd;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    hatch.points.emplace_back(i % 2 ? i : i + 25000, i % 2 ? 0 : 25000);
    const double angle = 2 * kPi * i / n;
    crowd.points.emplace_back(1e-3 * std::cos(angle), 1e-3 * std::sin(angle));
  }
  hatch.closed = false;
  crowd.points[0] = {1e6, 0};
  EXPECT_FALSE(self_crossing(hatch));
  EXPECT_FALSE(self_crossing(crowd));
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

TEST(Contour, AHoleIsOutsideAndAnOpenLineBoundsNothing) {
  std::vector<Polyline> lines = {box(0, 0, 10, 10), box(5, 0.5, 4, 9)};
  EXPECT_TRUE(contains(lines, {2, 5}));
  EXPECT_FALSE(contains(lines, {7, 5}));
  EXPECT_FALSE(contains(lines, {12, 5}));
  EXPECT_EQ(closed_polygons(lines).size(), 2u);
  lines[1].closed = false;
  EXPECT_TRUE(contains(lines, {7, 5}));
  EXPECT_EQ(closed_polygons(lines).size(), 1u);
}

TEST(Contour, CentroidCountsHolesOut) {
  const std::vector<Polyline> lines = {box(0, 0, 10, 10), box(5, 0.5, 4, 9)};
  const Vec2 expected = (Vec2(5, 5) * 100 - Vec2(7, 5) * 36) / 64;
  EXPECT_NEAR((centroid(lines) - expected).norm(), 0, 1e-9);
  EXPECT_NEAR(signed_area(lines[0]), 100, 1e-12);
}

}  // namespace
}  // namespace artisketch

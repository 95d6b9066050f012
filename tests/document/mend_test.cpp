#include "document/mend.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

Polyline square(double x, double y, double side) {
  return {{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, true};
}

TEST(Mend, LeavesWhatIsWholeAsItIs) {
  const Polyline line = square(10, 10, 30);
  EXPECT_EQ(mended(line).points, line.points);
}

TEST(Mend, AFigureOfEightBecomesItsTwoLobesAsOne) {
  const Polyline eight{{{0, 0}, {100, 100}, {100, 0}, {0, 100}}, true};
  const Polyline whole = mended(eight);
  EXPECT_FALSE(self_crossing(whole));
  EXPECT_NEAR(std::abs(signed_area(whole)), 5000, 100);
}

TEST(Mend, ALittleLoopAtACornerGoes) {
  Polyline line = square(0, 0, 100);
  line.points.insert(line.points.begin() + 2, {Vec2(100, 106), Vec2(106, 100)});
  line.points[4] = {100, 100};
  ASSERT_TRUE(self_crossing(line));
  const Polyline whole = mended(line);
  EXPECT_FALSE(self_crossing(whole));
  EXPECT_NEAR(std::abs(signed_area(whole)), 10000, 600);
}

TEST(Mend, AnOpenStrokeLosesItsLoop) {
  const Polyline stroke{{{0, 0}, {60, 0}, {60, 40}, {40, 40}, {40, -40}}, false};
  const Polyline whole = mended(stroke);
  EXPECT_FALSE(whole.closed);
  EXPECT_FALSE(self_crossing(whole));
  EXPECT_EQ(whole.points.front(), Vec2(0, 0));
  EXPECT_EQ(whole.points.back(), Vec2(40, -40));
}

TEST(Mend, NoScribbleCrossesItselfAfterwards) {
  std::mt19937 random(7);
  const auto next = [&] { return double(random() % 2000) / 10; };
  for (int n : {4, 5, 6, 9, 14, 40})
    for (int trial = 0; trial < 20; ++trial)
      for (bool closed : {true, false}) {
        Polyline line{{}, closed};
        for (int i = 0; i < n; ++i) line.points.push_back({next(), next()});
        EXPECT_FALSE(self_crossing(mended(line))) << n << " " << trial;
      }
  const Polyline fold{{{0, 0}, {50, 0}, {20, 0}, {50, 0}, {50, 50}, {0, 50}}, true};
  const Polyline whole = mended(fold);
  EXPECT_FALSE(self_crossing(whole));
  EXPECT_NEAR(std::abs(signed_area(whole)), 2500, 60);
}

// A line that goes there and back has no inside: it gets a small one.
TEST(Mend, WhatLiesOnItselfGetsAnInside) {
  for (const Vec2& along : {Vec2(10, 0), Vec2(0, 10), Vec2(0, 0), Vec2(1e-7, 0)}) {
    const Vec2 a(20, 30);
    const Polyline there_and_back{{a, a + along, a + along / 2, a + along / 4}, true};
    const Polyline whole = mended(there_and_back);
    if (!self_crossing(there_and_back)) continue;
    EXPECT_TRUE(whole.closed);
    EXPECT_FALSE(self_crossing(whole)) << along.transpose();
    EXPECT_GE(whole.points.size(), 3u);
  }
}

TEST(Join, OverlappingOutlinesBecomeTheOneAroundBoth) {
  const auto both = joined(square(0, 0, 40), square(30, 30, 40), 12);
  ASSERT_TRUE(both);
  EXPECT_NEAR(std::abs(signed_area(*both)), 1600 + 1600 - 100, 20);
  EXPECT_FALSE(self_crossing(*both));
  const auto inner = joined(square(0, 0, 40), square(10, 10, 10), 12);
  ASSERT_TRUE(inner);
  EXPECT_NEAR(std::abs(signed_area(*inner)), 1600, 20);
  EXPECT_FALSE(joined(square(0, 0, 40), square(50, 0, 40), 12));
}

TEST(Join, StrokesMeetAtTheirNearestEnds) {
  const Polyline a{{{0, 0}, {50, 0}}, false}, b{{{55, 40}, {52, 2}}, false};
  const auto one = joined(a, b, 12);
  ASSERT_TRUE(one);
  EXPECT_FALSE(one->closed);
  EXPECT_EQ(one->points, (std::vector<Vec2>{{0, 0}, {50, 0}, {52, 2}, {55, 40}}));
  const Polyline c{{{49, 1}, {25, 30}, {1, 1}}, false};
  const auto ring = joined(a, c, 12);
  ASSERT_TRUE(ring);
  EXPECT_TRUE(ring->closed);
  EXPECT_FALSE(joined(a, square(0, 0, 10), 12));
}

TEST(Curve, PassesThroughItsPointsAndIsRound) {
  // Four points of a circle with the handles that make Bézier arcs of it.
  constexpr double k = 0.5522847498 * 50;
  const std::vector<Vec2> points = {{50, 0}, {0, 50}, {-50, 0}, {0, -50}},
                          handles = {{0, k}, {-k, 0}, {0, -k}, {k, 0}};
  const Polyline ring = curve_through(points, handles, true);
  EXPECT_GT(ring.points.size(), 16u);
  for (const Vec2& p : ring.points) EXPECT_NEAR(p.norm(), 50, 0.02);
  for (std::size_t i = 0; i < ring.segments(); ++i)
    EXPECT_NEAR(((ring.points[i] + ring.end_of(i)) / 2).norm(), 50, 0.15);
  const std::vector<Vec2> none(4, Vec2::Zero());
  EXPECT_EQ(curve_through(points, none, false).points, points);
}

}  // namespace
}  // namespace artisketch

#include "document/region_outline.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

struct Rgba {
  double r, g, b, a;
};
constexpr Rgba kClear{0, 0, 0, 0}, kWhite{255, 255, 255, 255}, kInk{20, 20, 24, 255},
    kRed{200, 60, 50, 255}, kBlue{50, 80, 190, 255};

// Each pixel the mean of 8 × 8 samples: antialiased as a painter would be.
Image painted(int width, int height, const std::function<Rgba(Vec2)>& paint) {
  Image made(width, height);
  constexpr int kSamples = 8;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Rgba sum{0, 0, 0, 0};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const Rgba c =
            paint({x + (k % kSamples + 0.5) / kSamples, y + (k / kSamples + 0.5) / kSamples});
        sum = {sum.r + c.r * c.a, sum.g + c.g * c.a, sum.b + c.b * c.a, sum.a + c.a};
      }
      std::uint8_t* pixel = made.at(x, y);
      for (double v : {sum.r, sum.g, sum.b})
        *pixel++ = std::uint8_t(sum.a > 0 ? std::lround(v / sum.a) : 0);
      *pixel = std::uint8_t(std::lround(sum.a / (kSamples * kSamples)));
    }
  return made;
}

std::optional<RegionOutline> trace(const Image& made, Vec2 at, double tolerance = kUsualTolerance) {
  const SegmentedImage image = segmented(made);
  return region_outline(image, flood_levels(image, at), tolerance);
}

// How far the line's points and the middles of its edges are from a circle, at most.
double off_circle(const Polyline& line, Vec2 centre, double radius) {
  double worst = 0;
  for (std::size_t i = 0; i < line.segments(); ++i)
    for (const Vec2& p : {line.points[i], Vec2((line.points[i] + line.end_of(i)) / 2)})
      worst = std::max(worst, std::abs((p - centre).norm() - radius));
  return worst;
}

constexpr double kWithin = 0.35;  // pixels

TEST(RegionOutline, FollowsAnAntialiasedDiscToAThirdOfAPixel) {
  const Vec2 centre(61.3, 58.8);
  for (const Rgba& ground : {kClear, kWhite}) {
    const Image disc =
        painted(120, 120, [&](Vec2 p) { return (p - centre).norm() < 40.2 ? kRed : ground; });
    const auto found = trace(disc, {50, 60});
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->outline.closed);
    EXPECT_TRUE(found->holes.empty());
    EXPECT_LT(off_circle(found->outline, centre, 40.2), kWithin);
    EXPECT_LT(found->outline.points.size(), 60u);
  }
}

TEST(RegionOutline, GivesTheLargeHoleOfARingAndNotASmallOne) {
  const Vec2 centre(80, 80);
  const auto ring = [&](double hole) {
    return painted(160, 160, [&, hole](Vec2 p) {
      const double d = (p - centre).norm();
      return d < 60 && d > hole ? kBlue : kClear;
    });
  };
  const auto large = trace(ring(30), {80, 35});
  ASSERT_TRUE(large);
  EXPECT_LT(off_circle(large->outline, centre, 60), kWithin);
  ASSERT_EQ(large->holes.size(), 1u);
  EXPECT_LT(off_circle(large->holes[0], centre, 30), kWithin);
  const auto small = trace(ring(6), {80, 35});
  ASSERT_TRUE(small);
  EXPECT_TRUE(small->holes.empty());
}

TEST(RegionOutline, StopsInTheMiddleOfInk) {
  const Vec2 centre(100, 100);
  for (const Rgba& fill : {kWhite, kRed})
    for (const Rgba& ground : {kWhite, kClear}) {
      const Image shape = painted(200, 200, [&](Vec2 p) {
        const double d = (p - centre).norm();
        return d < 68 ? fill : d < 72 ? kInk : ground;
      });
      const auto found = trace(shape, {100, 110});
      ASSERT_TRUE(found);
      EXPECT_LT(off_circle(found->outline, centre, 70), 0.6);
    }
}

TEST(RegionOutline, ClosesASmallGapInInk) {
  const Vec2 centre(100, 100);
  const Image shape = painted(200, 200, [&](Vec2 p) {
    const double d = (p - centre).norm();
    const bool gap = p.x() > 100 && std::abs(p.y() - 100) < 1;
    return d > 68 && d < 72 && !gap ? kInk : kWhite;
  });
  const auto found = trace(shape, {100, 110});
  ASSERT_TRUE(found);
  EXPECT_NEAR(signed_area(found->outline), kPi * 70 * 70, 200);
}

// A head of one colour on a body of another, both with ink about them.
Image sprite() {
  return painted(160, 240, [](Vec2 p) {
    const double head = (p - Vec2(80, 60)).norm() - 40,
                 body = std::max(std::abs(p.x() - 80) - 30, std::abs(p.y() - 160) - 65);
    if (head < -2) return kRed;
    if (head < 2) return kInk;
    if (body < -2) return kBlue;
    return body < 2 ? kInk : kClear;
  });
}

TEST(RegionOutline, TakesOneColourOrWithAllToleranceTheWholeFigure) {
  const auto body = trace(sprite(), {80, 160});
  ASSERT_TRUE(body);
  const Box2 box = bounds(std::span(&body->outline, 1));
  EXPECT_NEAR(box.min().x(), 50, 0.7);
  EXPECT_NEAR(box.max().y(), 225, 0.7);
  EXPECT_GT(box.min().y(), 94);
  const auto whole = trace(sprite(), {80, 160}, 1);
  ASSERT_TRUE(whole);
  const Box2 all = bounds(std::span(&whole->outline, 1));
  EXPECT_NEAR(all.min().y(), 20, 0.7);
  EXPECT_NEAR(all.max().y(), 225, 0.7);
  EXPECT_FALSE(self_crossing(whole->outline));
}

TEST(RegionOutline, LeavesPaperAlone) {
  const Image made = sprite();
  const SegmentedImage image = segmented(made);
  EXPECT_TRUE(is_paper(image, {5, 5}));
  EXPECT_TRUE(is_paper(image, {-5, 5}));
  EXPECT_FALSE(is_paper(image, {80, 160}));
  EXPECT_FALSE(region_outline(image, flood_levels(image, {5, 5}), 1));
  const Box2 figure = figure_box(image);
  EXPECT_LT((figure.min() - Vec2(38, 18)).norm(), 1.5);
  EXPECT_LT((figure.max() - Vec2(122, 227)).norm(), 1.5);
}

TEST(RegionOutline, TakesASinglePixelAndAWholeImage) {
  Image dot = painted(9, 7, [](Vec2 p) {
    return p.x() > 4 && p.x() < 5 && p.y() > 3 && p.y() < 4 ? kRed : kClear;
  });
  const auto found = trace(dot, {4.5, 3.5});
  ASSERT_TRUE(found);
  const Box2 box = bounds(std::span(&found->outline, 1));
  EXPECT_TRUE(box.contains(Vec2(4.5, 3.5)));
  EXPECT_LT(box.sizes().maxCoeff(), 1.5);

  const Image full = painted(40, 30, [](Vec2 p) { return p.x() < 20 ? kRed : kBlue; });
  const auto whole = trace(full, {5, 5}, 1);
  ASSERT_TRUE(whole);
  EXPECT_NEAR(signed_area(whole->outline), 1200, 0.15 * 140);
  const auto left = trace(full, {5, 5});
  ASSERT_TRUE(left);
  EXPECT_NEAR(signed_area(left->outline), 600, 0.15 * 100);
}

TEST(RegionOutline, TakesLargeImagesAndNone) {
  Image large(2400, 1800, 0);
  for (int y = 400; y < 1200; ++y)
    for (int x = 600; x < 1800; ++x)
      for (int c : {0, 3}) large.rgba[4 * (std::size_t(y) * 2400 + x) + c] = 255;
  const auto found = trace(large, {1000, 700});
  ASSERT_TRUE(found);
  EXPECT_NEAR(signed_area(found->outline), 1200 * 800, 0.002 * 1200 * 800);
  const SegmentedImage none = segmented(Image());
  EXPECT_TRUE(is_paper(none, {0, 0}));
  EXPECT_FALSE(region_outline(none, flood_levels(none, {0, 0}), 1));
}

}  // namespace
}  // namespace artisketch

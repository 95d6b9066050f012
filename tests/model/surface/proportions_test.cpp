#include "model/surface/proportions.h"

#include <cmath>

#include <gtest/gtest.h>

#include "model/surface/mirror.h"

namespace artisketch {
namespace {

constexpr double kRadius = 0.3, kPixelsPerUnit = 100;

// Two balls at x = ±1, each other's mirror image, drawn from the front and from a side; in each
// drawing so many times as tall: left ball, right ball.
Part left_ball(const Vec2& front, const Vec2& side) {
  Document d;
  d.camera = {Camera::Type::orthographic, kPixelsPerUnit, 0, 0};
  d.skeleton.joints = {{"body", -1, Vec3::Zero(), -1, ""},
                       {"ball.L", 0, Vec3(1, 0, 0), 2, ""},
                       {"ball.R", 0, Vec3(-1, 0, 0), 1, ""}};
  for (int f = 0; f < 2; ++f) {
    Frame frame;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(d.skeleton);
    frame.pose.rotations[0] = Eigen::AngleAxisd(f * kPi / 2, Vec3::UnitY());
    d.frames.push_back(frame);
    const auto posed = posed_joints(d.skeleton, frame.pose);
    for (int ball : {1, 2}) {
      const Vec2 at = frame_camera(d, f).project(posed[ball].translation());
      const double tall = (f == 0 ? front : side)[ball - 1];
      Polyline line;
      for (int i = 0; i < 90; ++i) {
        const double angle = 2 * kPi * i / 90;
        line.points.push_back(at + kPixelsPerUnit * kRadius *
                                       Vec2(std::cos(angle), tall * std::sin(angle)));
      }
      d.frames[f].contours.push_back({ball, line, ""});
    }
  }
  std::vector<Part> parts = parts_of(d);
  add_mirrored_views(d, parts);
  return parts[0];
}

// Heights of a part's outlines, in the ball's.
Vec2 heights(const Part& part) {
  Vec2 all;
  for (int v = 0; v < 2; ++v)
    all[v] = part.views[v].outline.box().sizes().y() / (2 * kPixelsPerUnit * kRadius);
  return all;
}

TEST(Proportions, OutlinesThatAgreeStay) {
  const Part part = left_ball({1, 1}, {1, 1});
  const Part after = in_proportion(part).part;
  for (int v = 0; v < 2; ++v)
    for (std::size_t i = 0; i < 90; ++i)
      EXPECT_EQ(after.views[v].contours[0].points[i], part.views[v].contours[0].points[i]);
}

TEST(Proportions, OutlinesThatDifferMeetBetween) {
  Part part = left_ball({1, 1}, {1.3, 1.3});
  part.mirrors.clear();
  const Vec2 after = heights(in_proportion(part).part);
  EXPECT_GT(after[0], 1.08);
  EXPECT_LT(after[1], 1.22);
  EXPECT_LT(after[1] - after[0], 0.1);
  EXPECT_GT(after.mean(), 1.1);
  EXPECT_LT(after.mean(), 1.2);
}

TEST(Proportions, AMirrorImageThatAgreesTipsTheBalance) {
  const Part part = left_ball({1, 1}, {1.3, 1});
  Part alone = part;
  alone.mirrors.clear();
  EXPECT_LT(heights(in_proportion(part).part).mean(),
            heights(in_proportion(alone).part).mean() - 0.02);
}

TEST(Proportions, TellByHowMuchOutlinesDiffered) {
  Part part = left_ball({1, 1}, {1.3, 1.3});
  part.mirrors.clear();
  const double size = kRadius * std::sqrt(1.3 * kPi);
  EXPECT_NEAR(in_proportion(part).contradiction, 0.3 * kRadius / size, 0.01);
}

TEST(Proportions, AnotherSidesSizeHasNoSay) {
  const Part part = left_ball({1, 1.5}, {1, 1.5});
  EXPECT_EQ(heights(in_proportion(part).part), heights(part));
}

}  // namespace
}  // namespace artisketch

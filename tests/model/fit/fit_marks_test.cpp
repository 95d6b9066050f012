#include "model/fit/fit_marks.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

constexpr double kLimit = 3.5;

// A ball of 50 pixels about the middle of a drawing of 300, outlined by a circle.
struct Ball {
  Mesh mesh = icosphere(Vec3::Zero(), 0.5, 4);
  FrameCamera camera{{}, {150, 150}, 1};
  Frame frame;

  explicit Ball(Vec2 centre, double radius) {
    frame.width = frame.height = 300;
    Contour contour;
    for (int i = 0; i < 96; ++i) {
      const double a = 2 * kPi * i / 96;
      contour.line.points.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
    }
    frame.contours.push_back(contour);
  }
  FitMarks marks() const {
    return fit_marks(mesh, Transform::Identity(), camera, frame, 0, kLimit);
  }
};

TEST(FitMarks, AModelOnItsOutlineHasNone) {
  const FitMarks marks = Ball({150, 150}, 50).marks();
  ASSERT_EQ(marks.edge.size(), 1u);
  EXPECT_NEAR(double(marks.edge[0].size()), kPi * 100 / 2, 8);
  EXPECT_LT(marks.off, 0.8);
  EXPECT_EQ(marks.stretch, 0);
}

TEST(FitMarks, TheDistanceIsTheEdgesWayToTheOutline) {
  const FitMarks marks = Ball({150, 150}, 62).marks();
  EXPECT_NEAR(marks.off, 12, 0.7);
  EXPECT_NEAR(marks.stretch, 2 * kPi * 50, 15);
  for (const EdgePoint& p : marks.edge[0]) EXPECT_NEAR((p.at - Vec2(150, 150)).norm(), 50, 1);
}

TEST(FitMarks, TheLongestStretchLiesWhereTheyPart) {
  // The outline is larger, and touches the ball on its left.
  const FitMarks marks = Ball({170, 150}, 70).marks();
  EXPECT_GT(marks.stretch, 100);
  EXPECT_LT((marks.middle.at - Vec2(200, 150)).norm(), 12);
  EXPECT_GT(marks.outward.dot(Vec2(1, 0)), 0.9);
  EXPECT_GT(marks.middle.off(), 35);
}

TEST(FitMarks, WithoutAnOutlineThereIsNothingToCompare) {
  Ball ball({150, 150}, 50);
  ball.frame.contours[0].joint = 1;
  EXPECT_TRUE(ball.marks().edge.empty());
  ball.frame.contours[0].joint = 0;
  ball.camera.camera.type = Camera::Type::perspective;
  ball.camera.camera.distance = 0.2;  // the camera stands in the ball
  EXPECT_TRUE(ball.marks().edge.empty());
}

}  // namespace
}  // namespace artisketch

#include "model/mirror.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

// Two hands, each other's mirror image at x = ±1: balls of radius `left` and `right`, drawn from
// the front and from the side.
Document two_hands(double left, double right, bool from_the_side = true) {
  Document d;
  d.camera = {Camera::Type::orthographic, 100, 0, 0};
  d.skeleton.joints = {{"body", -1, Vec3::Zero(), -1, ""},
                       {"hand.L", 0, Vec3(1, 0, 0), 2, ""},
                       {"hand.R", 0, Vec3(-1, 0, 0), 1, ""}};
  for (int f = 0; f < (from_the_side ? 2 : 1); ++f) {
    Frame frame;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(d.skeleton);
    if (f) frame.pose.rotations[0] = Eigen::AngleAxisd(kPi / 2, Vec3::UnitY());
    d.frames.push_back(frame);
    const auto posed = posed_joints(d.skeleton, frame.pose);
    for (int hand : {1, 2}) {
      const Vec2 at = frame_camera(d, f).project(posed[hand].translation());
      Polyline circle;
      for (int i = 0; i < 90; ++i)
        circle.points.push_back(at +
                                100 * (hand == 1 ? left : right) *
                                    Vec2(std::cos(2 * kPi * i / 90), std::sin(2 * kPi * i / 90)));
      d.frames[f].contours.push_back({hand, circle, ""});
    }
  }
  return d;
}

std::vector<Part> parts_with_mirrors(const Document& document) {
  std::vector<Part> parts = parts_of(document);
  add_mirrored_views(document, parts);
  return parts;
}

TEST(Mirror, ViewsSeeTheOtherSideReflected) {
  const auto parts = parts_with_mirrors(two_hands(0.3, 0.3));
  ASSERT_EQ(parts.size(), 2u);
  ASSERT_EQ(parts[0].mirrors.size(), 2u);
  const Vec3 p(0.8, 0.1, 0.2), image(-0.8, 0.1, 0.2);
  for (int v = 0; v < 2; ++v) {
    EXPECT_TRUE(parts[0].mirrors[v].mirrored);
    EXPECT_LT((parts[0].mirrors[v].project(p) - parts[1].views[v].project(image)).norm(), 1e-9);
  }
}

// How many mirrored views the part's surface would be made with.
int mirrored_views(const Part& part) {
  const Result<Carving> carving = carving_with_mirrors(part, 64);
  if (!carving) return -1;
  return int(std::count_if(carving->views.begin(), carving->views.end(),
                           [](const Silhouette& view) { return view.view->mirrored; }));
}

TEST(Mirror, TrueImagesAreUsed) {
  for (const Part& part : parts_with_mirrors(two_hands(0.3, 0.3)))
    EXPECT_EQ(mirrored_views(part), 2);
}

TEST(Mirror, AnAsymmetricCharacterLosesNothing) {
  for (const Part& part : parts_with_mirrors(two_hands(0.3, 0.4)))
    EXPECT_EQ(mirrored_views(part), 0);
}

TEST(Mirror, OneDirectionDeniesNothingAndSoProvesNothing) {
  for (const Part& part : parts_with_mirrors(two_hands(0.3, 0.3, false)))
    EXPECT_EQ(mirrored_views(part), 0);
}

}  // namespace
}  // namespace artisketch

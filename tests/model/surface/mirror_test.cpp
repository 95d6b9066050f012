#include "model/surface/mirror.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "model/surface/agreement.h"

namespace artisketch {
namespace {

// Two hands, each other's mirror image at x = ±1: balls of radius `left` and `right`, drawn from
// two sides, a quarter apart, the first `turn` from the front.
struct Hands {
  double left = 0.3, right = 0.3;
  double thumb = 0;  // of the left one, that long, up and outward in the first drawing
  double turn = 0;   // radians
  int frames = 2;
};
Document drawn(const Hands& hands) {
  Document d;
  d.camera = {Camera::Type::orthographic, 100, 0, 0};
  d.skeleton.joints = {{"body", -1, Vec3::Zero(), -1, ""},
                       {"hand.L", 0, Vec3(1, 0, 0), 2, ""},
                       {"hand.R", 0, Vec3(-1, 0, 0), 1, ""}};
  for (int f = 0; f < hands.frames; ++f) {
    Frame frame;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(d.skeleton);
    frame.pose.rotations[0] = Eigen::AngleAxisd(hands.turn + f * kPi / 2, Vec3::UnitY());
    d.frames.push_back(frame);
    const auto posed = posed_joints(d.skeleton, frame.pose);
    for (int hand : {1, 2}) {
      const Vec2 at = frame_camera(d, f).project(posed[hand].translation());
      Polyline circle;
      for (int i = 0; i < 90; ++i) {
        const double angle = 2 * kPi * i / 90;
        double radius = hand == 1 ? hands.left : hands.right;
        if (f == 0 && hand == 1)
          radius += hands.thumb * std::max(0.0, 1 - std::abs(angle - 7 * kPi / 4) / 0.4);
        circle.points.push_back(at + 100 * radius * Vec2(std::cos(angle), std::sin(angle)));
      }
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
  const auto parts = parts_with_mirrors(drawn({}));
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
  for (const Part& part : parts_with_mirrors(drawn({}))) EXPECT_EQ(mirrored_views(part), 2);
}

TEST(Mirror, AnAsymmetricCharacterLosesNothing) {
  for (const Part& part : parts_with_mirrors(drawn({.right = 0.4})))
    EXPECT_EQ(mirrored_views(part), 0);
}

double hull_volume(const Carving& carving) {
  Run run;
  const Result<Grid3<float>> hull = carve(carving, 64, run);
  EXPECT_TRUE(hull);
  return double(std::count_if(hull->values.begin(), hull->values.end(),
                              [](float v) { return v < 0; })) *
         hull->cell * hull->cell * hull->cell;
}

TEST(Mirror, WhatIsAlikeBoundsThePartAndLeavesWhatIsDrawn) {
  for (const Part& part : parts_with_mirrors(drawn({.thumb = 0.08, .turn = kPi / 5}))) {
    const Result<Carving> own = carving_of(part, 64), all = carving_with_mirrors(part, 64);
    ASSERT_TRUE(own && all);
    std::vector<const Silhouette*> views;
    for (const Silhouette& view : all->views) {
      EXPECT_EQ(view.bounds_only, view.view->mirrored);
      views.push_back(&view);
    }
    ASSERT_EQ(views.size(), 4u);
    for (int v = 0; v < 2; ++v)
      EXPECT_GE(coverage(*views[v], views, all->room, 1.5), 0.99) << part.name << " " << v;
    EXPECT_LT(hull_volume(*all), 0.97 * hull_volume(*own)) << part.name;
  }
}

TEST(Mirror, OneDirectionDeniesNothingAndSoProvesNothing) {
  for (const Part& part : parts_with_mirrors(drawn({.frames = 1})))
    EXPECT_EQ(mirrored_views(part), 0);
}

}  // namespace
}  // namespace artisketch

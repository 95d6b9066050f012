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

// How much the mirrored outlines are trusted, at least and at most.
std::pair<double, double> trust_of(const Part& part) {
  const Result<Carving> carving = carving_with_mirrors(part, 0, 64);
  std::pair<double, double> trust(2, -1);
  EXPECT_TRUE(carving);
  if (carving)
    for (const Silhouette& view : carving->views)
      if (view.view->mirrored)
        trust = {std::min(trust.first, view.trust), std::max(trust.second, view.trust)};
  return trust;
}

TEST(Mirror, TrueImagesAreTrusted) {
  for (const Part& part : parts_with_mirrors(drawn({}))) EXPECT_GT(trust_of(part).first, 0.99);
}

// The share of their own rays that the part's own views leave one another.
void expect_own_are_kept(const Carving& carving) {
  std::vector<const Silhouette*> views;
  for (const Silhouette& view : carving.views) views.push_back(&view);
  for (const Silhouette* view : views)
    if (!view->view->mirrored) {
      EXPECT_GE(coverage(*view, views, carving.room, 1.6), 0.99) << carving.name;
    }
}

TEST(Mirror, AnAsymmetricCharacterLosesNothing) {
  for (const double right : {0.2, 0.4, 0.6})
    for (const Part& part : parts_with_mirrors(drawn({.right = right}))) {
      EXPECT_LT(trust_of(part).second, 0.01) << part.name << " " << right;
      const Result<Carving> carving = carving_with_mirrors(part, 0, 64);
      ASSERT_TRUE(carving);
      expect_own_are_kept(*carving);
    }
}

TEST(Mirror, TrustFadesWithoutASwitch) {
  double before = 1;
  for (double thumb = 0; thumb < 0.2; thumb += 0.002) {
    const double now =
        trust_of(parts_with_mirrors(drawn({.thumb = thumb, .turn = kPi / 5}))[0]).first;
    EXPECT_LT(std::abs(now - before), 0.25) << thumb;
    before = now;
  }
  EXPECT_LT(before, 0.01);
}

TEST(Mirror, HandsThatContradictThemselvesMayDiffer) {
  const Part part = parts_with_mirrors(drawn({.thumb = 0.08, .turn = kPi / 5}))[0];
  const auto trust = [&](double contradiction) {
    return carving_with_mirrors(part, contradiction, 64)->views.back().trust;
  };
  EXPECT_LT(trust(0), 0.5);
  EXPECT_NEAR(trust(0.003), trust(0), 0.1);
  EXPECT_GT(trust(0.1), 0.9);
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
    const Result<Carving> own = carving_of(part, 64), all = carving_with_mirrors(part, 0, 64);
    ASSERT_TRUE(own && all);
    ASSERT_EQ(all->views.size(), 4u);
    expect_own_are_kept(*all);
    EXPECT_LT(hull_volume(*all), 0.97 * hull_volume(*own)) << part.name;
  }
}

TEST(Mirror, APartDrawnFromOneSideHasItsDepthFromItsImage) {
  Document d = drawn({.thumb = 0.1});
  const auto leave_out = [&](int frame, int joint) {
    std::erase_if(d.frames[frame].contours, [&](const Contour& c) { return c.joint == joint; });
  };
  leave_out(1, 1);
  leave_out(0, 2);
  for (const Part& part : parts_with_mirrors(d)) {
    ASSERT_EQ(part.views.size(), 1u);
    const Result<Carving> own = carving_of(part, 64), all = carving_with_mirrors(part, 0, 64);
    ASSERT_TRUE(own && all);
    EXPECT_TRUE(own->one_direction());
    EXPECT_FALSE(all->one_direction());
    expect_own_are_kept(*all);
  }
}

}  // namespace
}  // namespace artisketch

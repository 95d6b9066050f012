#include "model/part_inputs.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "model/surface/mirror.h"

namespace artisketch {
namespace {

// A body and two arms that mirror each other, from the front and from the side.
Document figure() {
  Document d;
  d.camera = {Camera::Type::orthographic, 100, 0, 0};
  d.skeleton.joints = {{"body", -1, Vec3::Zero(), -1, ""},
                       {"arm.L", 0, Vec3(1, 0, 0), 2, ""},
                       {"arm.R", 0, Vec3(-1, 0, 0), 1, ""}};
  for (int f = 0; f < 2; ++f) {
    Frame frame;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(d.skeleton);
    if (f) frame.pose.rotations[0] = Eigen::AngleAxisd(kPi / 2, Vec3::UnitY());
    d.frames.push_back(frame);
    const auto posed = posed_joints(d.skeleton, frame.pose);
    for (int joint = 0; joint < 3; ++joint) {
      const Vec2 at = frame_camera(d, f).project(posed[joint].translation());
      Polyline circle;
      for (int i = 0; i < 60; ++i)
        circle.points.push_back(at +
                                40 * Vec2(std::cos(2 * kPi * i / 60), std::sin(2 * kPi * i / 60)));
      d.frames[f].contours.push_back({joint, circle, ""});
    }
  }
  return d;
}

std::vector<std::string> inputs(const Document& document, bool mirror,
                                const SurfaceOptions& options) {
  std::vector<Part> parts = parts_of(document);
  if (mirror) add_mirrored_views(document, parts);
  std::vector<std::string> all;
  for (const Part& part : parts) all.push_back(surface_inputs(part, options));
  return all;
}

// How many of the three parts an edit has made anew.
int remade_by(const std::function<void(Document&)>& edit, bool mirror = true,
              const SurfaceOptions& after = {}) {
  Document document = figure();
  const std::vector<std::string> before = inputs(document, mirror, {});
  edit(document);
  const std::vector<std::string> now = inputs(document, mirror, after);
  EXPECT_EQ(before.size(), 3u);
  EXPECT_EQ(now.size(), 3u);
  int remade = 0;
  for (int p = 0; p < 3; ++p) remade += before[p] != now[p];
  return remade;
}

TEST(PartInputs, WithoutAnEditNothingIsMadeAgain) {
  EXPECT_EQ(remade_by([](Document&) {}), 0);
}

TEST(PartInputs, AnEditedContourRemakesItsPartAndItsMirrorImage) {
  const auto edit = [](Document& d) { d.frames[1].contours[1].line.points[7].x() += 0.25; };
  EXPECT_EQ(remade_by(edit, false), 1);
  EXPECT_EQ(remade_by(edit, true), 2);
}

TEST(PartInputs, APoseRemakesWhatItMoves) {
  const auto turn = [](int joint) {
    return [joint](Document& d) {
      d.frames[1].pose.rotations[joint] =
          d.frames[1].pose.rotations[joint] * Quat(Eigen::AngleAxisd(0.02, Vec3::UnitX()));
    };
  };
  EXPECT_EQ(remade_by(turn(1), false), 1);
  EXPECT_EQ(remade_by(turn(0), false), 3);
}

TEST(PartInputs, FatnessCamerasAndOptionsCount) {
  EXPECT_EQ(remade_by([](Document& d) { d.parts[2].fatness = 1.2; }), 1);
  EXPECT_EQ(remade_by([](Document& d) { d.camera.pixels_per_unit = 101; }), 3);
  const auto nothing = [](Document&) {};
  EXPECT_EQ(remade_by(nothing, true, {kDefaultMethod, 32, false}), 3);
  EXPECT_EQ(remade_by(nothing, true, {kDefaultMethod, 100, true}), 3);
  EXPECT_EQ(remade_by(nothing, true, {Method::paper, 100, false}), 3);
}

TEST(PartInputs, WhatNoSurfaceIsMadeOfDoesNotCount) {
  EXPECT_EQ(remade_by([](Document& d) { d.name = "renamed"; }), 0);
}

}  // namespace
}  // namespace artisketch

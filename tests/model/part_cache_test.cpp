#include "model/part_cache.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "model/mirror.h"

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

std::vector<PartSurface> surfaces(const Document& document, PartCache& cache, bool mirror = true,
                                  SurfaceOptions options = {kDefaultMethod, 24, false}) {
  std::vector<Part> parts = parts_of(document);
  if (mirror) add_mirrored_views(document, parts);
  artisketch::Run run;
  std::vector<PartSurface> all;
  for (const Part& part : parts) {
    Result<PartSurface> one = cache.surface(part, options, run);
    EXPECT_TRUE(one);
    all.push_back(std::move(*one));
  }
  return all;
}

void expect_same(const std::vector<PartSurface>& a, const std::vector<PartSurface>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].joint, b[i].joint);
    EXPECT_EQ(a[i].mesh.V, b[i].mesh.V);
    EXPECT_EQ(a[i].mesh.F, b[i].mesh.F);
    EXPECT_EQ(a[i].distance.values, b[i].distance.values);
    EXPECT_EQ(a[i].warnings, b[i].warnings);
  }
}

// Edits the document after a first pass; returns how many surfaces the second one made, which must
// be what a fresh cache makes.
int made_after(const std::function<void(Document&)>& edit, bool mirror = true) {
  Document document = figure();
  PartCache cache, fresh;
  surfaces(document, cache, mirror);
  EXPECT_EQ(cache.made(), 3);
  edit(document);
  expect_same(surfaces(document, cache, mirror), surfaces(document, fresh, mirror));
  return cache.made() - 3;
}

TEST(PartCache, WithoutAnEditNothingIsMadeAgain) {
  EXPECT_EQ(made_after([](Document&) {}), 0);
}

TEST(PartCache, AnEditedContourRemakesItsPartAndItsMirrorImage) {
  const auto edit = [](Document& d) { d.frames[1].contours[1].line.points[7].x() += 0.25; };
  EXPECT_EQ(made_after(edit, false), 1);
  EXPECT_EQ(made_after(edit, true), 2);
}

TEST(PartCache, APoseRemakesWhatItMoves) {
  const auto turn = [](int joint) {
    return [joint](Document& d) {
      d.frames[1].pose.rotations[joint] =
          d.frames[1].pose.rotations[joint] * Quat(Eigen::AngleAxisd(0.02, Vec3::UnitX()));
    };
  };
  EXPECT_EQ(made_after(turn(1), false), 1);
  EXPECT_EQ(made_after(turn(0), false), 3);
}

TEST(PartCache, FatnessCamerasAndOptionsCount) {
  EXPECT_EQ(made_after([](Document& d) { d.parts[2].fatness = 1.2; }), 1);
  EXPECT_EQ(made_after([](Document& d) { d.camera.pixels_per_unit = 101; }), 3);
  PartCache cache;
  const Document document = figure();
  for (const int grid : {24, 32})
    for (const bool hull : {false, true})
      surfaces(document, cache, true, {kDefaultMethod, grid, hull});
  surfaces(document, cache, true, {Method::paper, 32, true});
  EXPECT_EQ(cache.made(), 15);
}

TEST(PartCache, WhatNoSurfaceIsMadeOfDoesNotCount) {
  EXPECT_EQ(made_after([](Document& d) { d.name = "renamed"; }), 0);
}

TEST(PartCache, ThePipelineKeepsParts) {
  Document document = figure();
  PartCache cache;
  PipelineOptions options;
  options.grid = 24;
  options.calibrate = false;
  options.mirror = false;
  options.cache = &cache;
  artisketch::Run run;
  ASSERT_TRUE(reconstruct(document, options, run));
  document.frames[0].contours[2].line.points[3].y() -= 0.5;
  const auto edited = reconstruct(document, options, run);
  EXPECT_EQ(cache.made(), 4);
  options.cache = nullptr;
  const auto fresh = reconstruct(document, options, run);
  ASSERT_TRUE(edited && fresh);
  EXPECT_EQ(edited->model.mesh.V, fresh->model.mesh.V);
  EXPECT_EQ(edited->model.weights.weights, fresh->model.weights.weights);
}

TEST(PartCache, ATraceIsAlwaysLeft) {
  PartCache cache;
  const Part part = parts_of(figure())[0];
  artisketch::Run run;
  Trace trace;
  run.trace = &trace;
  for (int times = 1; times <= 2; ++times) {
    ASSERT_TRUE(cache.surface(part, {Method::paper, 24, false}, run));
    EXPECT_EQ(cache.made(), times);
  }
}

}  // namespace
}  // namespace artisketch

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "model/stages.h"

namespace artisketch {
namespace {

constexpr double kRadius = 0.8;

Polyline circle(const Vec2& centre, double radius) {
  Polyline line;
  for (int i = 0; i < 120; ++i)
    line.points.push_back(centre +
                          radius * Vec2(std::cos(2 * kPi * i / 120), std::sin(2 * kPi * i / 120)));
  return line;
}

// One joint at the origin whose part is a ball, drawn in frames of 400 × 300 pixels.
struct Ball {
  Document document;
  Model model;
  std::vector<PartSurface> parts;

  Ball() {
    document.camera.pixels_per_unit = 100;
    document.skeleton.joints.push_back({"ball", -1, Vec3::Zero(), -1, ""});
    model.skeleton = document.skeleton;
    model.mesh = icosphere(Vec3::Zero(), kRadius, 4);
    const auto n = model.mesh.V.rows();
    model.weights.joints.setZero(n, 4);
    model.weights.weights.setZero(n, 4);
    model.weights.weights.col(0).setOnes();
    parts.push_back({0, model.mesh, {}, {}, {}});
  }
  void add_frame(const Vec3& at, std::vector<Polyline> lines) {
    Frame frame;
    frame.width = 400;
    frame.height = 300;
    frame.pose = rest_pose(document.skeleton);
    frame.pose.root_position = at;
    for (Polyline& line : lines) frame.contours.push_back({0, std::move(line), ""});
    document.frames.push_back(std::move(frame));
  }
  std::vector<FrameFit> fits() const { return measure_fit(document, model, parts); }
};

TEST(Silhouette, ABallFitsItsCircle) {
  Ball ball;
  ball.add_frame(Vec3(0.3, -0.2, 0), {circle({230, 170}, 80)});
  const auto fits = ball.fits();
  ASSERT_EQ(fits.size(), 1u);
  EXPECT_GT(fits[0].iou, 0.99);
  ASSERT_EQ(fits[0].parts.size(), 1u);
  EXPECT_EQ(fits[0].parts[0].joint, 0);
  EXPECT_LT(fits[0].parts[0].distance, 0.3);
}

TEST(Silhouette, DistanceIsInPixelsOfTheSketch) {
  Ball ball;
  ball.add_frame(Vec3::Zero(), {circle({200, 150}, 86)});
  const auto fits = ball.fits();
  EXPECT_NEAR(fits[0].iou, 80.0 * 80 / (86 * 86), 0.01);
  EXPECT_NEAR(fits[0].parts[0].distance, 6, 0.3);
}

TEST(Silhouette, HolesAndStrokesCountAsDrawn) {
  Ball ball;
  Polyline stroke;
  stroke.closed = false;
  stroke.points = {{10, 10}, {390, 10}, {390, 290}};
  ball.add_frame(Vec3::Zero(), {circle({200, 150}, 80), circle({200, 150}, 40), stroke});
  ball.add_frame(Vec3::Zero(), {stroke});
  const auto fits = ball.fits();
  EXPECT_NEAR(fits[0].iou, 0.75, 0.01);
  EXPECT_EQ(fits[1].iou, 0);
  EXPECT_TRUE(fits[1].parts.empty());
}

TEST(Silhouette, PerspectiveAndPrincipalPointCount) {
  Ball ball;
  ball.document.camera.type = Camera::Type::perspective;
  ball.document.camera.distance = 4;
  ball.document.camera.focal_length = 300;
  // The cone that touches the ball: half-angle asin(r / d).
  const double radius = 300 * std::tan(std::asin(kRadius / 4));
  ball.add_frame(Vec3::Zero(), {circle({150, 120}, radius)});
  ball.document.frames[0].principal_point = Vec2(150, 120);
  EXPECT_GT(ball.fits()[0].iou, 0.985);
}

TEST(Silhouette, WhatStandsBehindTheCameraIsLeftOut) {
  Ball ball;
  ball.document.camera.type = Camera::Type::perspective;
  ball.document.camera.distance = 4;
  ball.add_frame(Vec3(0, 0, 9), {circle({200, 150}, 80)});
  ball.add_frame(Vec3(0, 0, 4), {circle({200, 150}, 80)});
  ball.add_frame(Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), {circle({200, 150}, 80)});
  const auto fits = ball.fits();
  EXPECT_EQ(fits[0].iou, 0);
  EXPECT_TRUE(fits[0].parts.empty());
  for (const FrameFit& fit : fits) {
    EXPECT_TRUE(fit.iou >= 0 && fit.iou <= 1);
    for (const auto& part : fit.parts) EXPECT_TRUE(std::isfinite(part.distance));
  }
}

}  // namespace
}  // namespace artisketch

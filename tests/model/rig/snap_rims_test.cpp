#include "model/rig/snap_rims.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

constexpr double kScale = 40;  // pixels per unit
constexpr int kSize = 160;

Polyline circle(const Vec2& centre, double radius) {
  Polyline line;
  for (int i = 0; i < 90; ++i) {
    const double angle = i * 2 * kPi / 90;
    line.points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return line;
}

// Two joints side by side, 100 pixels apart, each with a ball of one unit; seen from the front.
struct Balls {
  Document document;
  Mesh mesh;
  Weights weights;

  Balls() {
    document.camera.pixels_per_unit = kScale;
    document.skeleton.joints = {{"left", -1, Vec3::Zero(), -1, ""},
                                {"right", 0, {2.5, 0, 0}, -1, ""}};
    Frame frame;
    frame.width = 2 * kSize;
    frame.height = kSize;
    frame.principal_point = Vec2(kSize / 2.0, kSize / 2.0);
    frame.pose = rest_pose(document.skeleton);
    document.frames = {frame};
    const Mesh one = icosphere(Vec3::Zero(), 1, 3), other = icosphere({2.5, 0, 0}, 1, 3);
    mesh.V.resize(2 * one.V.rows(), 3);
    mesh.V << one.V, other.V;
    mesh.F.resize(2 * one.F.rows(), 3);
    mesh.F << one.F, other.F.array() + int(one.V.rows());
    weights.joints.setZero(mesh.V.rows(), 4);
    weights.weights.setZero(mesh.V.rows(), 4);
    weights.weights.col(0).setOnes();
    weights.joints.col(0).tail(one.V.rows()).setOnes();
  }
  void draw(int joint, double radius) {
    document.frames[0].contours.push_back(
        {joint, circle({kSize / 2.0 + 100 * joint, kSize / 2.0}, radius), ""});
  }
  // Radii in pixels of what the left (0) or right (1) ball shows at its outline and at its middle.
  struct Radii {
    double outline, middle;
  };
  Radii radii(int joint) const {
    Radii r{0, 0};
    int count = 0;
    for (int v = 0; v < mesh.V.rows(); ++v) {
      if (weights.joints(v, 0) != joint) continue;
      const Vec3 p = kScale * (mesh.V.row(v).transpose() - Vec3(2.5 * joint, 0, 0));
      if (std::abs(p.z()) < 1) r.outline += p.norm(), ++count;
      if (p.z() > 0.99 * kScale) r.middle = p.norm();
    }
    r.outline /= count;
    return r;
  }
  void snap() {
    artisketch::Run run;
    snap_rims(document, parts_of(document), weights, mesh, run);
  }
};

TEST(SnapRims, OutlinesComeToTheDrawing) {
  for (const double radius : {38.5, 41.5}) {
    Balls balls;
    balls.draw(0, radius);
    balls.snap();
    EXPECT_NEAR(balls.radii(0).outline, radius, 0.5);
    EXPECT_NEAR(balls.radii(0).middle, kScale, 0.1);
  }
}

TEST(SnapRims, WhatFitsStays) {
  Balls balls;
  balls.draw(0, kScale);
  balls.draw(1, kScale);
  const Points3 before = balls.mesh.V;
  balls.snap();
  EXPECT_LT((balls.mesh.V - before).rowwise().norm().maxCoeff() * kScale, 0.25);
}

TEST(SnapRims, WhatIsNotDrawnOrFarOffStays) {
  Balls balls;
  balls.draw(0, 42);
  const Points3 before = balls.mesh.V;
  balls.snap();
  EXPECT_NEAR(balls.radii(1).outline, kScale, 1e-2);
  balls.document.frames[0].contours.clear();
  balls.draw(1, 50);
  balls.mesh.V = before;
  balls.snap();
  EXPECT_NEAR(balls.radii(1).outline, kScale, 1e-2);
}

// In the drawing the ball lies elsewhere and is turned: what moves is the rest surface.
TEST(SnapRims, CountsInThePoseOfTheDrawing) {
  Balls balls;
  balls.document.frames[0].pose.root_position = {0.5, 0, 0};
  balls.document.frames[0].pose.rotations[0] = Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()));
  balls.document.frames[0].contours = {{0, circle({100, 80}, 41.5), ""}};
  balls.snap();
  EXPECT_GT(balls.radii(0).middle, kScale + 0.5);  // z is seen from aside now
}

}  // namespace
}  // namespace artisketch

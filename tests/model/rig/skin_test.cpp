#include <cmath>

#include <gtest/gtest.h>

#include "base/raster.h"
#include "figures/examples.h"
#include "model/solid_parts.h"

namespace artisketch {
namespace {

TEST(PosedVertices, MixesTheMotionsOfItsJoints) {
  Skeleton skeleton;
  skeleton.joints.resize(2);
  skeleton.joints[1].parent = 0;
  skeleton.joints[1].offset = {1, 0, 0};
  Points3 V(3, 3);
  V << 0.5, 0, 0, 2, 0, 0, 1, 0.5, 0;
  Weights weights;
  weights.joints.setZero(3, 4);
  weights.weights.setZero(3, 4);
  weights.weights(0, 0) = 1;
  weights.joints(1, 0) = 1;
  weights.weights(1, 0) = 1;
  weights.joints.row(2) << 0, 1, 0, 0;
  weights.weights.row(2) << 0.5, 0.5, 0, 0;
  EXPECT_TRUE(posed_vertices(V, weights, skeleton, rest_pose(skeleton)).isApprox(V));

  Pose bent = rest_pose(skeleton);
  bent.root_position = {0, 0, 3};
  bent.rotations[1] = Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()));
  Points3 expected(3, 3);
  expected << 0.5, 0, 3, 1, 1, 3, 0.75, 0.25, 3;
  EXPECT_TRUE(posed_vertices(V, weights, skeleton, bent).isApprox(expected, 1e-12));
}

using namespace figures;

struct Skinned {
  Document document;
  std::vector<PartSurface> parts;
  Mesh mesh;
  Weights weights;
};

Skinned skinned(const Figure& figure, int cells = 40, int triangles = 0) {
  Skinned s;
  s.document.skeleton = figure.skeleton;
  s.parts = surfaces_of(figure, cells);
  std::vector<std::string> warnings;
  artisketch::Run run;
  s.mesh = consolidate(s.document, s.parts, {true, triangles}, warnings, run).value();
  s.weights = skin(s.document, s.parts, s.mesh, run).value();
  return s;
}

// The weight of a joint at each vertex.
Eigen::VectorXd of_joint(const Weights& weights, int joint) {
  Eigen::VectorXd w = Eigen::VectorXd::Zero(weights.joints.rows());
  for (int v = 0; v < w.size(); ++v)
    for (int k = 0; k < 4; ++k)
      if (weights.joints(v, k) == joint) w[v] += weights.weights(v, k);
  return w;
}

Mask silhouette(const Points3& V, const Triangles& F, const FrameCamera& camera) {
  Mask mask(640, 800);
  std::vector<Vec2> pixels(V.rows());
  for (int v = 0; v < V.rows(); ++v) pixels[v] = camera.project(V.row(v).transpose());
  add_triangles(pixels, F, mask);
  return mask;
}

TEST(Skin, SumsToOneWithTheLargestFirst) {
  const Figure figure = human(0);
  const Skinned s = skinned(figure);
  std::vector<bool> drawn(figure.skeleton.size(), false);
  for (const PartSurface& part : s.parts) drawn[part.joint] = true;
  for (int v = 0; v < s.mesh.V.rows(); ++v) {
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      const double w = s.weights.weights(v, k);
      ASSERT_TRUE(std::isfinite(w) && w >= 0 && w <= 1);
      EXPECT_TRUE(k == 0 || w <= s.weights.weights(v, k - 1));
      EXPECT_TRUE(w > 0 ? drawn[s.weights.joints(v, k)] : s.weights.joints(v, k) == 0);
      sum += w;
    }
    EXPECT_NEAR(sum, 1, 1e-15);
  }
}

TEST(Skin, PosesLikeTheRigidParts) {
  for (const Figure& figure : {human(1), quadruped(0)}) {
    SCOPED_TRACE(figure.name);
    const Skinned s = skinned(figure);
    const Camera camera = fitting_camera(figure, Camera::Type::orthographic, 640, 800);
    const FrameCamera before{camera, {320, 400}, 1};
    for (const View& view : random_views(figure, 3, 5)) {
      const Points3 V = posed_vertices(s.mesh.V, s.weights, figure.skeleton, view.pose);
      Mask rigid(640, 800);
      for (const Mesh& part : posed_parts(figure, view.pose, 0.01)) {
        const Mask one = silhouette(part.V, part.F, before);
        for (std::size_t i = 0; i < rigid.in.size(); ++i) rigid.in[i] |= one.in[i];
      }
      EXPECT_GT(intersection_over_union(silhouette(V, s.mesh.F, before), rigid), 0.984);
    }
  }
}

TEST(Skin, BlendsEvenlyRoundAnElbow) {
  const Figure arm = capsule_arm();
  const Skinned s = skinned(arm);
  const int forearm = 1;
  const double elbow = rest_positions(arm.skeleton)[forearm].x();
  const Eigen::VectorXd w = of_joint(s.weights, forearm);
  const double radius = -distance(arm.parts[forearm], rest_positions(arm.skeleton)[forearm]);
  for (int v = 0; v < w.size(); ++v) {
    const double x = s.mesh.V(v, 0) - elbow;
    if (x < -1.5 * radius) {
      EXPECT_LT(w[v], 0.05);
    } else if (std::abs(x) < 0.02 * radius) {
      EXPECT_NEAR(w[v], 0.5, 0.1);
    } else if (x > 1.5 * radius && x < 3 * radius) {
      EXPECT_GT(w[v], 0.95);
    }
  }
}

// Else the surface folds into teeth there when it bends.
TEST(Skin, NoNeighboursStandOnTwoSidesOfAnElbow) {
  for (const char* name : {"hero", "robot"}) {
    const Figure figure = example(name).figure;
    const Skinned s = skinned(figure, 40, 15000);
    for (const char* joint : {"forearm.L", "forearm.R", "shin.L", "shin.R"}) {
      const Eigen::VectorXd w = of_joint(s.weights, figure.skeleton.find(joint));
      double most = 0;
      for (int f = 0; f < s.mesh.F.rows(); ++f)
        for (int c = 0; c < 3; ++c)
          most = std::max(most, std::abs(w[s.mesh.F(f, c)] - w[s.mesh.F(f, (c + 1) % 3)]));
      EXPECT_LT(most, 0.45) << name << " " << joint;
    }
  }
}

// The parts' samples are cut off a few cells below their surface: a trunk isn't as thin as that,
// and bends over its whole width.
TEST(Skin, IsTheSameWhereSamplesTellNoDepth) {
  const Figure figure = human(0);
  Skinned s = skinned(figure);
  for (PartSurface& part : s.parts)
    for (float& distance : part.distance.values)
      distance = std::max(distance, float(-3 * part.distance.cell));
  artisketch::Run run;
  const Weights cut = skin(s.document, s.parts, s.mesh, run).value();
  for (const char* name : {"hips", "thigh.L", "upper_arm.L", "forearm.R", "shin.R"}) {
    const int joint = figure.skeleton.find(name);
    EXPECT_LT((of_joint(cut, joint) - of_joint(s.weights, joint)).cwiseAbs().maxCoeff(), 0.1)
        << name;
  }
}

TEST(Skin, AFingerNeverPullsTheOtherThigh) {
  const Figure figure = human(0);
  const Skinned s = skinned(figure);
  const std::vector<Vec3> rest = rest_positions(figure.skeleton);
  for (const char* name : {"hand.L", "foot.R", "head"}) {
    const int joint = figure.skeleton.find(name);
    const Eigen::VectorXd w = of_joint(s.weights, joint);
    const Ball reach = bounding_ball(figure.parts[joint]);
    for (int v = 0; v < w.size(); ++v)
      if ((s.mesh.V.row(v).transpose() - reach.centre).norm() > 1.5 * reach.radius) {
        EXPECT_EQ(w[v], 0);
      }
  }
}

TEST(Skin, HoldsWhereThePartsDoNot) {
  // A surface with an island of its own, far from every part, and a triangle without area.
  const Figure arm = capsule_arm();
  Skinned s = skinned(arm);
  const Mesh island = icosphere({0, 5, 0}, 0.3, 2);
  const int n = int(s.mesh.V.rows()), m = int(s.mesh.F.rows());
  s.mesh.V.conservativeResize(n + island.V.rows(), 3);
  s.mesh.V.bottomRows(island.V.rows()) = island.V;
  s.mesh.F.conservativeResize(m + island.F.rows() + 1, 3);
  s.mesh.F.middleRows(m, island.F.rows()) = island.F.array() + n;
  s.mesh.F.bottomRows(1) << 0, 0, 1;
  artisketch::Run run;
  const Result<Weights> weights = skin(s.document, s.parts, s.mesh, run);
  ASSERT_TRUE(weights);
  EXPECT_TRUE(weights->weights.allFinite());
  EXPECT_LT((weights->weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace artisketch

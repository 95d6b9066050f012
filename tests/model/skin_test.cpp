#include <gtest/gtest.h>

#include "model/stages.h"

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

}  // namespace
}  // namespace artisketch

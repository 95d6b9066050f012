#include "figures/measure.h"

#include <gtest/gtest.h>

namespace artisketch::figures {
namespace {

TEST(Measure, VolumeOfTheTruthItselfIsWhole) {
  for (const Figure& figure : {two_balls(), capsule_arm(), human(1)})
    EXPECT_GT(volume_iou(figure, rest_mesh(figure, 0.02), 48), 0.97) << figure.name;
}

TEST(Measure, VolumeOfASmallerBallIsTheRatioOfTheVolumes) {
  EXPECT_NEAR(volume_iou(ball_figure(0.5), icosphere(Vec3::Zero(), 0.4, 5)), 0.512, 0.005);
}

TEST(Measure, AMeshThatRunsThroughItselfCountsOnce) {
  Mesh twice = icosphere(Vec3::Zero(), 0.5, 4);
  const int v = int(twice.V.rows()), f = int(twice.F.rows());
  twice.V = twice.V.replicate(2, 1).eval();
  twice.F = twice.F.replicate(2, 1).eval();
  twice.F.bottomRows(f).array() += v;
  EXPECT_GT(volume_iou(ball_figure(0.5), twice), 0.98);
}

TEST(Measure, SilhouetteOfTheTruthsOwnMeshIsTheFigures) {
  const Figure figure = quadruped(1);
  const Camera camera = fitting_camera(figure, Camera::Type::perspective, 300, 300);
  const FrameCamera seen{camera, Vec2(150, 150), 1};
  Model model;
  model.skeleton = figure.skeleton;
  model.mesh = rest_mesh(figure, 0.02);
  model.weights.joints.setZero(model.mesh.V.rows(), 4);
  model.weights.weights.setZero(model.mesh.V.rows(), 4);
  model.weights.weights.col(0).setOnes();
  const View v = view(figure, "", about_y(40));  // as one rigid piece
  EXPECT_GT(intersection_over_union(silhouette(figure, v.pose, seen, 300, 300),
                                    silhouette(model, v.pose, seen, 300, 300)),
            0.975);
}

class Errors : public testing::Test {
 protected:
  const Figure arm = capsule_arm();
  const FrameCamera seen{{Camera::Type::orthographic, 100}, Vec2(100, 100), 1};
  PoseErrors of(const Quat& elbow) const {
    return pose_errors(arm, seen, view(arm, "", Quat::Identity()).pose,
                       view(arm, "", Quat::Identity(), {{"forearm", elbow}}).pose);
  }
};

TEST_F(Errors, ATurnInTheImageIsInPlane) {
  const PoseErrors e = of(about_z(12));  // forearm and hand turn, the upper arm does not
  EXPECT_NEAR(e.in_plane, 12 * 2 / 3.0, 0.5);
  EXPECT_NEAR(e.out_of_plane, 0, 0.2);
  EXPECT_NEAR(e.angle, 8, 1e-9);
  EXPECT_NEAR(e.worst_joint_px, 2 * 45 * std::sin(radians(6)), 1e-6);
}

TEST_F(Errors, ATurnTowardTheCameraIsOutOfPlane) {
  const PoseErrors e = of(about_y(-12));
  EXPECT_NEAR(e.out_of_plane, 8, 0.5);
  EXPECT_NEAR(e.in_plane, 0, 1);
}

TEST_F(Errors, ABoneThatPointsAtTheCameraHardlyMovesWhenItTurnsInTheImage) {
  const View there = view(arm, "", about_y(-80));
  const View here = view(arm, "", about_z(12) * about_y(-80));
  EXPECT_NEAR(pose_errors(arm, seen, there.pose, here.pose).in_plane, 12 * std::cos(radians(80)),
              0.5);
}

TEST_F(Errors, ATurnAboutTheBoneIsTwist) {
  const PoseErrors e = of(about_x(12));
  EXPECT_NEAR(e.twist, 8, 0.5);
  EXPECT_NEAR(e.joint_px, 0, 1e-9);
}

}  // namespace
}  // namespace artisketch::figures

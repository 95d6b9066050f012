#include "document/posing.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

// A chest with an arm of upper arm, forearm, hand and the hand's tip, and a head; 100 pixels a
// unit.
enum : int { kChest, kUpperArm, kForearm, kHand, kTip, kHead, kHeadTip };
Document figure() {
  Document document;
  document.camera.pixels_per_unit = 100;
  const auto joint = [&](const char* name, int parent, Vec3 offset) {
    document.skeleton.joints.push_back({name, parent, offset, -1, ""});
  };
  joint("chest", -1, {0, 1, 0});
  joint("upper_arm", kChest, {0.2, 0, 0});
  joint("forearm", kUpperArm, {0.5, 0, 0});
  joint("hand", kForearm, {0.4, 0, 0});
  joint("hand.tip", kHand, {0.2, 0, 0});
  joint("head", kChest, {0, 0.3, 0});
  joint("head.tip", kHead, {0, 0.3, 0});
  for (const char* name : {"front", "side"}) {
    Frame frame;
    frame.name = name;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(document.skeleton);
    document.frames.push_back(frame);
  }
  return document;
}

struct Seen {
  Document document = figure();
  const Skeleton& skeleton = document.skeleton;
  FrameCamera camera = frame_camera(document, 0);
  Pose rest = document.frames[0].pose;

  Vec3 place(const Pose& pose, int joint) const {
    return posed_joints(skeleton, pose)[joint].translation();
  }
  Vec2 pixel(const Pose& pose, int joint) const { return camera.project(place(pose, joint)); }
  double length(const Pose& pose, int joint) const {
    return (place(pose, joint) - place(pose, skeleton.joints[joint].parent)).norm();
  }
};

TEST(Posing, HandsAndFeetDragALimbTheOthersOneBone) {
  const Seen s;
  EXPECT_EQ(bones_dragged(s.skeleton, kChest), 0);
  EXPECT_EQ(bones_dragged(s.skeleton, kForearm), 1);
  EXPECT_EQ(bones_dragged(s.skeleton, kHand), 2);
  EXPECT_EQ(bones_dragged(s.skeleton, kTip), 1);
  EXPECT_EQ(bones_dragged(s.skeleton, kHeadTip), 1);
}

TEST(Posing, ADraggedHandComesUnderThePointerAndBendsTheElbow) {
  const Seen s;
  const Vec2 pixel = s.camera.project({0.6, 0.6, 0});
  const Pose pose = with_joint_dragged(s.skeleton, s.rest, s.camera, kHand, pixel);
  EXPECT_LT((s.pixel(pose, kHand) - pixel).norm(), 1e-6);
  EXPECT_NEAR(s.place(pose, kHand).z(), 0, 1e-9);
  EXPECT_LT((s.place(pose, kUpperArm) - s.place(s.rest, kUpperArm)).norm(), 1e-9);
  for (int joint : {kForearm, kHand, kTip})
    EXPECT_NEAR(s.length(pose, joint), s.length(s.rest, joint), 1e-9);
}

TEST(Posing, BeyondItsReachALimbPointsAtThePointer) {
  const Seen s;
  const Pose pose =
      with_joint_dragged(s.skeleton, s.rest, s.camera, kHand, s.camera.project({0.2, 9, 0}));
  EXPECT_LT((s.place(pose, kHand) - Vec3(0.2, 1.9, 0)).norm(), 1e-6);
}

TEST(Posing, AJointGoesToAPlaceInSpaceAsNearAsItsBonesReach) {
  const Seen s;
  const Vec3 near(0.5, 1.3, 0.4), far(0.2, 1, 5);
  const Pose pose = with_joint_at(s.skeleton, s.rest, kHand, near, 2);
  EXPECT_LT((s.place(pose, kHand) - near).norm(), 1e-6);
  EXPECT_LT((s.place(pose, kUpperArm) - s.place(s.rest, kUpperArm)).norm(), 1e-9);
  for (int joint : {kForearm, kHand, kTip})
    EXPECT_NEAR(s.length(pose, joint), s.length(s.rest, joint), 1e-9);
  const Pose stretched = with_joint_at(s.skeleton, s.rest, kHand, far, 2);
  EXPECT_LT((s.place(stretched, kHand) - Vec3(0.2, 1, 0.9)).norm(), 1e-6);
  // One bone alone turns; what comes before it stays.
  const Pose wrist = with_joint_at(s.skeleton, s.rest, kHand, near, 1);
  EXPECT_LT((s.place(wrist, kForearm) - s.place(s.rest, kForearm)).norm(), 1e-9);
  const Vec3 aim = (near - s.place(wrist, kForearm)).normalized();
  EXPECT_LT((s.place(wrist, kHand) - s.place(wrist, kForearm) - 0.4 * aim).norm(), 1e-6);
  // The root takes all with it.
  const Pose moved = with_joint_at(s.skeleton, s.rest, kChest, {1, 1, 1}, 0);
  EXPECT_LT((s.place(moved, kTip) - s.place(s.rest, kTip) - Vec3(1, 0, 1)).norm(), 1e-9);
}

TEST(Posing, AShortenedBoneStandsInDepthOnTheSideWhereItWas) {
  const Seen s;
  const Vec2 pixel = s.camera.project({0.5, 1, 0});
  const Pose toward = with_joint_dragged(s.skeleton, s.rest, s.camera, kForearm, pixel);
  EXPECT_LT((s.place(toward, kForearm) - Vec3(0.5, 1, 0.4)).norm(), 1e-6);
  const Pose away = with_bone_flipped(s.skeleton, toward, kForearm);
  const Pose farther =
      with_joint_dragged(s.skeleton, away, s.camera, kForearm, s.camera.project({0.6, 1, 0}));
  EXPECT_LT((s.place(farther, kForearm) - Vec3(0.6, 1, -0.3)).norm(), 1e-6);
}

TEST(Posing, TheHandStaysWhereItIsSeenWhenTheElbowIsDragged) {
  const Seen s;
  const Pose bent =
      with_joint_dragged(s.skeleton, s.rest, s.camera, kHand, s.camera.project({0.7, 0.8, 0}));
  // Nearer to both its neighbours: both bones lean out of the paper.
  const Vec2 between = (s.pixel(bent, kUpperArm) + s.pixel(bent, kHand)) / 2;
  const Vec2 pixel = 0.8 * s.pixel(bent, kForearm) + 0.2 * between;
  const Pose pose = with_joint_dragged(s.skeleton, bent, s.camera, kForearm, pixel);
  EXPECT_LT((s.pixel(pose, kForearm) - pixel).norm(), 1e-6);
  EXPECT_LT((s.pixel(pose, kHand) - s.pixel(bent, kHand)).norm(), 1e-6);
  EXPECT_NEAR(s.length(pose, kHand), 0.4, 1e-9);
}

TEST(Posing, FromTheSideALimbsEndChangesItsDepthAlone) {
  const Seen s;
  const Pose bent =
      with_joint_dragged(s.skeleton, s.rest, s.camera, kHand, s.camera.project({0.6, 0.7, 0}));
  const Pose pose = with_joint_depth(s.skeleton, bent, s.camera, kHand, 0.35);
  EXPECT_NEAR(s.place(pose, kHand).z(), 0.35, 1e-6);
  EXPECT_LT((s.pixel(pose, kHand) - s.pixel(bent, kHand)).norm(), 1e-6);
  // One bone alone keeps its direction in the picture.
  const Pose head = with_joint_depth(s.skeleton, s.rest, s.camera, kHeadTip, -0.1);
  EXPECT_NEAR(s.place(head, kHeadTip).z(), -0.1, 1e-6);
  EXPECT_NEAR(s.place(head, kHeadTip).x(), 0, 1e-9);
  EXPECT_NEAR(s.length(head, kHeadTip), 0.3, 1e-9);
}

TEST(Posing, AFlippedBonePointsAwayAndShowsTheSame) {
  const Seen s;
  const Pose toward =
      with_joint_dragged(s.skeleton, s.rest, s.camera, kForearm, s.camera.project({0.5, 1, 0}));
  const Vec3 before = s.place(toward, kForearm);
  const Vec3 after = s.place(with_bone_flipped(s.skeleton, toward, kForearm), kForearm);
  EXPECT_LT((after - Vec3(before.x(), before.y(), -before.z())).norm(), 1e-9);
}

TEST(Posing, ATwistMovesNeitherEndOfTheBone) {
  const Seen s;
  const Pose bent =
      with_joint_dragged(s.skeleton, s.rest, s.camera, kHand, s.camera.project({0.6, 0.7, 0}));
  const Pose twisted = with_bone_twisted(s.skeleton, bent, kForearm, 0.7);
  EXPECT_LT((s.place(twisted, kForearm) - s.place(bent, kForearm)).norm(), 1e-9);
  EXPECT_GT((s.place(twisted, kHand) - s.place(bent, kHand)).norm(), 0.05);
}

TEST(Posing, TheBallTurnsAsItsSurfaceFollowsThePointer) {
  const Quat turn = ball_turn({0, 0}, {20, 0}, 46);
  EXPECT_LT(((turn * Vec3::UnitZ()).head<2>() - Vec2(20 / 46.0, 0)).norm(), 1e-9);
  const Quat roll = ball_turn({500, 0}, {0, 500}, 46);
  EXPECT_GT(roll.angularDistance(Quat::Identity()), 1.4);
  EXPECT_LT(roll.vec().head<2>().norm(), 0.1);
}

TEST(Posing, ATurnedBodyKeepsItsRootAndItsShape) {
  const Seen seen;
  const Quat quarter(Eigen::AngleAxisd(kPi / 2, Vec3::UnitY()));
  const Pose turned = with_body_turned(seen.rest, quarter);
  EXPECT_LT((seen.place(turned, kChest) - seen.place(seen.rest, kChest)).norm(), 1e-12);
  const Vec3 before = seen.place(seen.rest, kTip) - seen.place(seen.rest, kChest);
  const Vec3 after = seen.place(turned, kTip) - seen.place(turned, kChest);
  EXPECT_LT((after - quarter * before).norm(), 1e-9);
}

TEST(Posing, ACopiedPoseKeepsTheDrawingsPlace) {
  Document document = figure();
  document.frames[0].pose.rotations[kForearm] = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  document.frames[1].pose.root_position = Vec3(0.3, 0, 0);
  const Document copied = with_pose_copied(document, 0, 1);
  EXPECT_EQ(copied.frames[1].pose.root_position, Vec3(0.3, 0, 0));
  EXPECT_LT(copied.frames[1].pose.rotations[kForearm].angularDistance(
                document.frames[0].pose.rotations[kForearm]),
            1e-9);
}

TEST(Posing, ALockIsSetOnceAndFreedWhole) {
  Document document = with_lock(with_lock(figure(), kHand, true), kForearm, true);
  document = with_lock(document, kHand, true);
  EXPECT_EQ(document.calibration.locked, (std::vector<int>{kForearm, kHand}));
  EXPECT_FALSE(is_locked(with_lock(document, kHand, false), kHand));
}

}  // namespace
}  // namespace artisketch

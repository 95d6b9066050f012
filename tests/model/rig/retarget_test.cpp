#include "model/rig/retarget.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

Quat about(double angle, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(radians(angle), axis));
}

// A figure with its arm held out to the side.
Document figure() {
  Document document;
  document.skeleton.joints = {{"hips", -1, {0, 2, 0}, -1, ""},
                              {"upper_arm.L", 0, {0.2, 1, 0}, -1, ""},
                              {"hand.L", 1, {1, 0, 0}, -1, ""},
                              {"foot", 0, {0, -2, 0}, -1, ""}};
  return document;
}

// One ten times as high, its arm hanging down.
Motion motion() {
  Motion motion;
  motion.name = "walk";
  motion.step = 0.5;
  motion.skeleton.joints = {{"Hips", -1, {0, 0, 0}, -1, ""},
                            {"LeftArm", 0, {2, 10, 0}, -1, ""},
                            {"LeftHand", 1, {0, -10, 0}, -1, ""},
                            {"Foot", 0, {0, -20, 0}, -1, ""}};
  for (int k = 0; k < 3; ++k) {
    Pose pose = rest_pose(motion.skeleton);
    pose.root_position = {0, 20.0 - k, 10.0 * k};
    pose.rotations[0] = about(20 * k, Vec3::UnitY());
    pose.rotations[1] = about(45 * k, Vec3::UnitZ());
    motion.poses.push_back(pose);
  }
  return motion;
}

Vec3 bone(const Skeleton& skeleton, const Pose& pose, int from, int to) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  return (posed[to].translation() - posed[from].translation()).normalized();
}

TEST(Retarget, BonesPointAsTheMotionsDoThoughTheRestPosesDiffer) {
  Document document = figure();
  document.motion.joints = {{"LeftArm", 1}, {"LeftHand", 2}};
  const Motion source = motion();
  const Result<Clip> clip = retargeted(document, source);
  ASSERT_TRUE(clip);
  EXPECT_EQ(clip->name, "walk");
  EXPECT_EQ(clip->times, (std::vector<double>{0, 0.5, 1}));
  for (int k = 0; k < 3; ++k) {
    const Vec3 theirs = bone(source.skeleton, source.poses[k], 1, 2);
    EXPECT_LT((bone(document.skeleton, clip->poses[k], 1, 2) - theirs).norm(), 1e-9);
    for (const Quat& q : clip->poses[k].rotations) EXPECT_NEAR(q.norm(), 1, 1e-12);
  }
}

TEST(Retarget, TheRootsWayIsScaledByTheHeightOfTheHips) {
  const Result<Clip> clip = retargeted(figure(), motion());
  ASSERT_TRUE(clip);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT((clip->poses[k].root_position - Vec3(0, 2 - 0.1 * k, 1.0 * k)).norm(), 1e-12);
}

TEST(Retarget, EqualNamesBelongTogetherWhateverTheirCase) {
  const Document document = figure();
  const Motion source = motion();  // "Hips" and "Foot" are known, the arm is not
  const Result<Clip> clip = retargeted(document, source);
  ASSERT_TRUE(clip);
  EXPECT_LT(clip->poses[2].rotations[0].angularDistance(about(40, Vec3::UnitY())), 1e-9);
  EXPECT_LT(clip->poses[2].rotations[1].angularDistance(Quat::Identity()), 1e-9);
}

TEST(Retarget, AMotionOfUnknownNamesSaysHowToMapThem) {
  Document document = figure();
  Motion source = motion();
  for (Joint& joint : source.skeleton.joints) joint.name = "mixamorig:" + joint.name;
  const Result<Clip> none = retargeted(document, source);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("/motion/joints"), std::string::npos);
  document.motion.joints = {{"mixamorig:Hips", 0}};
  EXPECT_TRUE(retargeted(document, source));
}

TEST(Retarget, FlatSkeletonsDoNotDivideByNothing) {
  Document document = figure();
  Motion source = motion();
  for (Joint& joint : source.skeleton.joints) joint.offset.setZero();
  for (Joint& joint : document.skeleton.joints) joint.offset.setZero();
  const Result<Clip> clip = retargeted(document, source);
  ASSERT_TRUE(clip);
  for (const Pose& pose : clip->poses) {
    EXPECT_TRUE(pose.root_position.allFinite());
    for (const Quat& q : pose.rotations) EXPECT_TRUE(q.coeffs().allFinite());
  }
}

}  // namespace
}  // namespace artisketch

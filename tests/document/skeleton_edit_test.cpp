#include "document/skeleton_edit.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "document/edit.h"
#include "document/templates.h"

namespace artisketch {
namespace {

// A person in two frames, the second bent, with something of everything that counts joints.
Document person() {
  Document document;
  document.camera.pixels_per_unit = 200;
  document.skeleton = template_skeleton(Template::human);
  for (int f = 0; f < 2; ++f) {
    Frame frame;
    frame.width = frame.height = 500;
    frame.pose = rest_pose(document.skeleton);
    for (std::size_t j = 0; f == 1 && j < frame.pose.rotations.size(); ++j)
      frame.pose.rotations[j] = Quat(Eigen::AngleAxisd(0.1 * double(j), Vec3(0, 0.6, 0.8)));
    document.frames.push_back(frame);
  }
  const Polyline line{{{0, 0}, {9, 0}, {9, 9}}, true};
  for (int j = 0; j < document.skeleton.size(); ++j)
    document = with_contour(std::move(document), 0, {j, line, ""});
  document.animations.push_back({"wave", {{0, document.frames[1].pose, ""}}, ""});
  const int hand = document.skeleton.find("hand.L"), foot = document.skeleton.find("foot.R");
  document.spheres[hand].radius = 0.25;
  document.parts[foot].fatness = 1.5;
  document.calibration.locked = {hand, foot};
  document.motion.joints = {{"LeftHand", hand}, {"RightFoot", foot}};
  return document;
}

// All that counts joints names one that there is; poses have one rotation each.
void expect_sound(const Document& document) {
  const int n = document.skeleton.size();
  for (int j = 0; j < n; ++j) {
    const Joint& joint = document.skeleton.joints[j];
    EXPECT_LT(joint.parent, j);
    EXPECT_EQ(joint.parent < 0, j == 0);
    EXPECT_LT(joint.mirror, n);
    if (joint.mirror >= 0) {
      EXPECT_EQ(document.skeleton.joints[joint.mirror].mirror, j);
    }
    EXPECT_EQ(document.skeleton.find(joint.name), j);
  }
  for (const Frame& frame : document.frames) {
    EXPECT_EQ(int(frame.pose.rotations.size()), n);
    for (const Contour& contour : frame.contours)
      EXPECT_TRUE(contour.joint >= 0 && contour.joint < n);
  }
  for (const Animation& animation : document.animations)
    for (const Key& key : animation.keys) EXPECT_EQ(int(key.pose.rotations.size()), n);
  for (const auto& [joint, sphere] : document.spheres) EXPECT_LT(joint, n);
  for (const auto& [joint, part] : document.parts) EXPECT_LT(joint, n);
  for (int joint : document.calibration.locked) EXPECT_LT(joint, n);
  for (const auto& [name, joint] : document.motion.joints) EXPECT_LT(joint, n);
}

std::string name_at(const Document& document, int joint) {
  return document.skeleton.joints[joint].name;
}

Quat posed_turn(const Document& document, const char* joint) {
  const Document& d = document;
  return Quat(posed_joints(d.skeleton, d.frames[1].pose)[d.skeleton.find(joint)].rotation());
}

TEST(SkeletonEdit, ADeletedJointLeavesAllElseAsItWas) {
  const Document before = person();
  const int forearm = before.skeleton.find("forearm.L");
  const Vec3 hand_was = rest_positions(before.skeleton)[before.skeleton.find("hand.L")];
  const auto after = without_joint(before, forearm, false);
  ASSERT_TRUE(after);
  expect_sound(*after);
  EXPECT_EQ(after->skeleton.size(), before.skeleton.size() - 1);
  const int hand = after->skeleton.find("hand.L"), foot = after->skeleton.find("foot.R");
  EXPECT_EQ(name_at(*after, after->skeleton.joints[hand].parent), "upper_arm.L");
  EXPECT_LT((rest_positions(after->skeleton)[hand] - hand_was).norm(), 1e-12);
  EXPECT_EQ(after->skeleton.joints[after->skeleton.find("forearm.R")].mirror, -1);
  // The contour that it had is its parent's; the others keep theirs by name.
  for (int j = 0; j < before.skeleton.size(); ++j)
    EXPECT_EQ(name_at(*after, after->frames[0].contours[j].joint),
              j == forearm ? "upper_arm.L" : name_at(before, j));
  EXPECT_EQ(after->spheres.count(hand), 1u);
  EXPECT_EQ(after->parts.count(foot), 1u);
  EXPECT_EQ(after->calibration.locked, (std::vector<int>{hand, foot}));
  EXPECT_EQ(after->motion.joints[1].second, foot);
  for (const char* name : {"hand.L", "hand_tip.L", "foot.R", "head"})
    EXPECT_LT(posed_turn(before, name).angularDistance(posed_turn(*after, name)), 1e-9) << name;
}

TEST(SkeletonEdit, DeletingTakesTheMirrorImageAlongAndKeepsARoot) {
  const Document before = person();
  const auto arms = without_joint(before, before.skeleton.find("hand_tip.R"), true);
  ASSERT_TRUE(arms);
  expect_sound(*arms);
  EXPECT_EQ(arms->skeleton.find("hand_tip.L"), -1);
  EXPECT_EQ(arms->skeleton.find("hand_tip.R"), -1);
  EXPECT_FALSE(without_joint(before, 0, true));  // the hips have three children
  Document chain = before;
  for (const char* name : {"thigh.L", "shin.L", "foot.L", "foot_tip.L"})
    chain = *without_joint(chain, chain.skeleton.find(name), true);
  const Vec3 chest = posed_joints(chain.skeleton, chain.frames[1].pose)[1].translation();
  const auto headless = without_joint(chain, 0, true);
  ASSERT_TRUE(headless);
  expect_sound(*headless);
  EXPECT_EQ(name_at(*headless, 0), "chest");
  EXPECT_LT((headless->frames[1].pose.root_position - chest).norm(), 1e-12);
  Document last = with_template(before, Template::blank, 0, std::nullopt);
  EXPECT_FALSE(without_joint(last, 0, true));
}

TEST(SkeletonEdit, AChildComesWithItsMirrorImage) {
  const Document before = person();
  const int hand = before.skeleton.find("hand.L");
  const Document thumbs = with_joint_added(before, hand, {0.02, -0.1, 0}, true);
  expect_sound(thumbs);
  EXPECT_EQ(thumbs.skeleton.size(), before.skeleton.size() + 2);
  EXPECT_GE(thumbs.skeleton.find("joint.L"), 0);
  const int right = thumbs.skeleton.find("joint.R");
  ASSERT_GE(right, 0);
  EXPECT_EQ(name_at(thumbs, thumbs.skeleton.joints[right].parent), "hand.R");
  EXPECT_EQ(thumbs.skeleton.joints[right].offset, Vec3(-0.02, -0.1, 0));

  const int head = before.skeleton.find("head");
  const Document ears = with_joint_added(before, head, {-0.12, 0.2, 0}, true);
  expect_sound(ears);
  EXPECT_EQ(ears.skeleton.joints.back().offset, Vec3(0.12, 0.2, 0));
  EXPECT_EQ(ears.skeleton.joints.back().name, "joint.L");
  const Document tuft = with_joint_added(before, head, {0.01, 0.4, 0}, true);
  expect_sound(tuft);
  EXPECT_EQ(tuft.skeleton.joints.back().offset.x(), 0);
  EXPECT_EQ(tuft.skeleton.joints.back().mirror, tuft.skeleton.size() - 1);
  const Document one =
      with_joint_added(with_joint_added(before, hand, {0, 1, 0}, false), hand, {0, 1, 0}, false);
  expect_sound(one);
  EXPECT_EQ(one.skeleton.joints.back().name, "joint 2");
}

TEST(SkeletonEdit, NamesAreUniqueAndPairsShareThem) {
  const Document before = person();
  const int arm = before.skeleton.find("upper_arm.L");
  const Document wing = with_joint_renamed(before, arm, "  wing ");
  expect_sound(wing);
  EXPECT_EQ(name_at(wing, arm), "wing.L");
  EXPECT_EQ(name_at(wing, wing.skeleton.joints[arm].mirror), "wing.R");
  const Document taken = with_joint_renamed(before, arm, "hand");
  expect_sound(taken);
  EXPECT_EQ(name_at(taken, arm), "hand 2.L");
  EXPECT_EQ(name_at(with_joint_renamed(before, arm, "   "), arm), "upper_arm.L");
  EXPECT_EQ(name_at(with_joint_renamed(before, 0, "hips"), 0), "hips");
}

TEST(SkeletonEdit, PairsMoveTogetherAndGetOneLength) {
  const Document before = person();
  const int shin = before.skeleton.find("shin.L"), other = before.skeleton.find("shin.R");
  const Document moved = with_joint_moved(before, shin, {0.1, -0.5, 0}, true);
  EXPECT_EQ(moved.skeleton.joints[other].offset, Vec3(-0.1, -0.5, 0));
  const Document alone = with_joint_moved(before, shin, {0, -0.6, 0}, false);
  EXPECT_EQ(alone.skeleton.joints[other].offset, before.skeleton.joints[other].offset);
  for (int joint : {shin, -1}) {
    const Document equal = with_pair_lengths_equal(alone, joint);
    EXPECT_NEAR(equal.skeleton.joints[shin].offset.norm(), 0.5, 1e-12);
    EXPECT_NEAR(equal.skeleton.joints[other].offset.norm(), 0.5, 1e-12);
  }
}

// Whatever is typed: files hold text alone, and names that are not would come back alike.
TEST(SkeletonEdit, NamesAreTextAndDifferAsText) {
  const std::string replaced = "\xEF\xBF\xBD";
  Document document = person();
  document = with_joint_renamed(std::move(document), 1, "\xFF");
  document = with_joint_renamed(std::move(document), 2, "\xFE");
  EXPECT_EQ(document.skeleton.joints[1].name, replaced);
  EXPECT_EQ(document.skeleton.joints[2].name, replaced + " 2");
  // Of other alphabets nothing is lost; half a character, an overlong one and half a pair are none.
  for (const auto& [typed, name] : std::vector<std::pair<std::string, std::string>>{
           {"Kn\xC3\xB6"
            "chel",
            "Kn\xC3\xB6"
            "chel"},
           {"\xE2\x82\xAC\xF0\x9F\xA6\x8A", "\xE2\x82\xAC\xF0\x9F\xA6\x8A"},
           {"a\xC3", "a" + replaced},
           {"\xC0\xAF", replaced + replaced},
           {"\xED\xA0\x80", replaced + replaced + replaced},
           {"\xF4\x90\x80\x80", replaced + replaced + replaced + replaced}})
    EXPECT_EQ(with_joint_renamed(document, 3, typed).skeleton.joints[3].name.substr(0, name.size()),
              name);
}

TEST(SkeletonEdit, AScaledFigureIsTheSameFigure) {
  const Document before = person(), after = with_figure_scaled(before, 2);
  const std::vector<Transform> small = posed_joints(before.skeleton, before.frames[1].pose),
                               large = posed_joints(after.skeleton, after.frames[1].pose);
  for (std::size_t j = 1; j < small.size(); ++j)
    EXPECT_LT((large[j].translation() - large[0].translation() -
               2 * (small[j].translation() - small[0].translation()))
                  .norm(),
              1e-12);
  EXPECT_EQ(*after.spheres.begin()->second.radius, 0.5);
}

}  // namespace
}  // namespace artisketch

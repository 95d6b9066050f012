#include "model/rig/rig_profile.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "document/templates.h"
#include "model/rig/body_plan.h"
#include "model/rig/library.h"
#include "model/rig/t_pose.h"

namespace artisketch {
namespace {

// A vertex at every joint of a person, bound to it, and a walk.
Model person() {
  Model model;
  model.skeleton = template_skeleton(Template::human);
  const std::vector<Vec3> rest = rest_positions(model.skeleton);
  const int n = int(rest.size());
  model.mesh.V.resize(n, 3);
  model.weights.joints.setZero(n, 4);
  model.weights.weights.setZero(n, 4);
  for (int j = 0; j < n; ++j) {
    model.mesh.V.row(j) = (rest[j] + Vec3(0.01, 0.02, 0.03)).transpose();
    model.weights.joints(j, 0) = j;
    model.weights.weights(j, 0) = 1;
  }
  model.clips.push_back(*library_clip(model.skeleton, "walk", {}));
  return model;
}

// A child and the parent that it has in the engine.
using Pairs = std::vector<std::pair<const char*, const char*>>;
const struct {
  const char* name;
  Pairs pairs;
} kEngines[] = {
    {"mixamo",
     {{"mixamorig:Hips", ""},
      {"mixamorig:Spine", "mixamorig:Hips"},
      {"mixamorig:Spine1", "mixamorig:Spine"},
      {"mixamorig:Spine2", "mixamorig:Spine1"},
      {"mixamorig:Neck", "mixamorig:Spine2"},
      {"mixamorig:Head", "mixamorig:Neck"},
      {"mixamorig:LeftShoulder", "mixamorig:Spine2"},
      {"mixamorig:LeftArm", "mixamorig:LeftShoulder"},
      {"mixamorig:RightForeArm", "mixamorig:RightArm"},
      {"mixamorig:RightHand", "mixamorig:RightForeArm"},
      {"mixamorig:LeftUpLeg", "mixamorig:Hips"},
      {"mixamorig:LeftLeg", "mixamorig:LeftUpLeg"},
      {"mixamorig:RightFoot", "mixamorig:RightLeg"},
      {"mixamorig:RightToeBase", "mixamorig:RightFoot"}}},
    {"unreal",
     {{"root", ""},
      {"pelvis", "root"},
      {"spine_01", "pelvis"},
      {"spine_02", "spine_01"},
      {"spine_03", "spine_02"},
      {"neck_01", "spine_03"},
      {"head", "neck_01"},
      {"clavicle_l", "spine_03"},
      {"upperarm_l", "clavicle_l"},
      {"lowerarm_r", "upperarm_r"},
      {"hand_r", "lowerarm_r"},
      {"thigh_l", "pelvis"},
      {"calf_l", "thigh_l"},
      {"foot_r", "calf_r"},
      {"ball_r", "foot_r"}}},
    {"unity",
     {{"hips", ""},
      {"spine", "hips"},
      {"chest", "spine"},
      {"neck", "chest"},
      {"head", "neck"},
      {"leftShoulder", "chest"},
      {"leftUpperArm", "leftShoulder"},
      {"rightLowerArm", "rightUpperArm"},
      {"rightHand", "rightLowerArm"},
      {"leftUpperLeg", "hips"},
      {"leftLowerLeg", "leftUpperLeg"},
      {"rightFoot", "rightLowerLeg"},
      {"rightToes", "rightFoot"}}},
    {"godot",
     {{"Root", ""},
      {"Hips", "Root"},
      {"Spine", "Hips"},
      {"Chest", "Spine"},
      {"UpperChest", "Chest"},
      {"Neck", "UpperChest"},
      {"Head", "Neck"},
      {"LeftShoulder", "UpperChest"},
      {"LeftUpperArm", "LeftShoulder"},
      {"RightLowerArm", "RightUpperArm"},
      {"RightHand", "RightLowerArm"},
      {"LeftUpperLeg", "Hips"},
      {"LeftLowerLeg", "LeftUpperLeg"},
      {"RightFoot", "RightLowerLeg"},
      {"RightToes", "RightFoot"}}},
    {"rigify",
     {{"spine", ""},
      {"spine.001", "spine"},
      {"spine.002", "spine.001"},
      {"spine.003", "spine.002"},
      {"spine.004", "spine.003"},
      {"spine.006", "spine.004"},
      {"shoulder.L", "spine.003"},
      {"upper_arm.L", "shoulder.L"},
      {"forearm.R", "upper_arm.R"},
      {"hand.R", "forearm.R"},
      {"thigh.L", "spine"},
      {"shin.L", "thigh.L"},
      {"foot.R", "shin.R"},
      {"toe.R", "foot.R"}}},
};

TEST(RigProfile, EveryEnginesJointsStandInItsOrder) {
  ASSERT_EQ(std::size(kEngines), rig_profiles().size());
  for (const auto& engine : kEngines) {
    const Result<Model> made = with_rig(person(), engine.name);
    ASSERT_TRUE(made) << made.error().text();
    const std::vector<Joint>& joints = made->skeleton.joints;
    for (const auto& [child, parent] : engine.pairs) {
      const int joint = made->skeleton.find(child);
      ASSERT_GE(joint, 0) << engine.name << ": " << child;
      EXPECT_EQ(joints[joint].parent < 0 ? "" : joints[joints[joint].parent].name, parent) << child;
    }
    int roots = 0;
    std::set<std::string> names;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      EXPECT_LT(joints[j].parent, int(j));  // parents first
      roots += joints[j].parent < 0;
      EXPECT_TRUE(names.insert(joints[j].name).second) << joints[j].name;
      if (std::string(engine.name) != "rigify") {
        EXPECT_EQ(joints[j].name.find('.'), std::string::npos) << joints[j].name;
      }
    }
    EXPECT_EQ(roots, 1);
  }
}

// What engines refuse in a name, and which joints they can't do without. Godot: Skeleton3D's names
// have no : and no /, and SkeletonProfileHumanoid's required bones. Unreal: names end at dots.
// Unity: the humanoid's fifteen.
TEST(RigProfile, NamesAndJointsKeepEveryEnginesRules) {
  const std::vector<std::string> limbs{"UpperArm", "LowerArm", "Hand",
                                       "UpperLeg", "LowerLeg", "Foot"};
  std::map<std::string, std::vector<std::string>> required{
      {"godot", {"Root", "Hips", "Spine", "Chest", "UpperChest", "Neck", "Head"}},
      {"unity", {"hips", "spine", "head"}},
      {"unreal", {"root", "pelvis", "spine_01", "neck_01", "head"}}};
  for (const std::string& limb : limbs)
    for (const char* side : {"Left", "Right"}) {
      required["godot"].push_back(side + limb);
      required["unity"].push_back((side[0] == 'L' ? "left" : "right") + limb);
    }
  for (const char* joint :
       {"clavicle", "upperarm", "lowerarm", "hand", "thigh", "calf", "foot", "ball"})
    for (const char* side : {"_l", "_r"}) required["unreal"].push_back(joint + std::string(side));
  Model drawn = person();
  const int hips = 0;
  for (const char* name : {"tail.1", "tail/2:end", "bow tie"})
    drawn.skeleton.joints.push_back({name, hips, {0, 0, -0.1}, -1, ""});
  for (Clip& clip : drawn.clips)
    for (Pose& pose : clip.poses)
      pose.rotations.resize(drawn.skeleton.joints.size(), Quat::Identity());
  for (const auto& [engine, names] : required) {
    const Result<Model> made = for_engine(drawn, engine);
    ASSERT_TRUE(made) << made.error().text();
    for (const std::string& name : names) EXPECT_GE(made->skeleton.find(name), 0) << name;
    int roots = 0;
    for (const Joint& joint : made->skeleton.joints) {
      EXPECT_EQ(joint.name.find_first_of(".:/ "), std::string::npos) << joint.name;
      roots += joint.parent < 0;
    }
    EXPECT_EQ(roots, 1) << engine;
    // The T-pose, in which engines compare skeletons; joints have offsets alone, no turn and no
    // scale.
    const std::vector<Vec3> rest = rest_positions(made->skeleton);
    const BodyPlan plan = body_plan_of(made->skeleton, rest, false);
    for (std::size_t side = 0; side < 2; ++side) {
      const LimbJoints &arm = plan.arms[side], &leg = plan.legs[side];
      EXPECT_GT((rest[arm.end] - rest[arm.upper]).normalized().x() * (side == 0 ? 1 : -1), 0.99999);
      EXPECT_GT((rest[leg.upper] - rest[leg.end]).normalized().y(), 0.99999) << engine;
    }
  }
}

TEST(RigProfile, NothingThatIsSeenMoves) {
  const Model before = person();
  for (const RigProfile& profile : rig_profiles()) {
    const Result<Model> after = with_rig(before, profile.name);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->mesh.V, before.mesh.V);
    ASSERT_EQ(after->clips.size(), before.clips.size());
    for (std::size_t k = 0; k < before.clips[0].poses.size(); ++k) {
      const Points3 a =
          posed_vertices(before.mesh.V, before.weights, before.skeleton, before.clips[0].poses[k]);
      const Points3 b =
          posed_vertices(after->mesh.V, after->weights, after->skeleton, after->clips[0].poses[k]);
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-12) << profile.name << ", pose " << k;
    }
  }
}

TEST(RigProfile, WhatIsNoPersonIsSaid) {
  for (const Template kind : {Template::fish, Template::quadruped, Template::blank}) {
    Model other;
    other.skeleton = template_skeleton(kind);
    EXPECT_FALSE(with_rig(other, "mixamo"));
  }
  const Result<Model> none = with_rig(person(), "maya");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("there are mixamo, unreal, unity, godot, rigify"),
            std::string::npos);
}

}  // namespace
}  // namespace artisketch

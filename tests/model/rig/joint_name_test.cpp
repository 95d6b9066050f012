#include <gtest/gtest.h>

#include "model/rig/body_plan.h"

namespace artisketch {
namespace {

TEST(JointName, SideWordAndPrefixComeApart) {
  const struct {
    const char *name, *word;
    Side side;
  } cases[] = {
      {"mixamorig:LeftUpLeg", "upleg", Side::left},
      {"Character1_RightForeArm", "forearm", Side::right},
      {"Bip01 L UpperArm", "upperarm", Side::left},
      {"Bip01 Pelvis", "pelvis", Side::none},
      {"Bip01 R Toe0", "toe", Side::right},
      {"upper_arm.L", "upperarm", Side::left},
      {"thigh_r", "thigh", Side::right},
      {"DEF-shin.R.001", "shin", Side::right},
      {"J_Bip_L_LowerLeg", "lowerleg", Side::left},
      {"J_Bip_C_Hips", "hips", Side::none},
      {"lShldrBend", "shldrbend", Side::left},
      {"lfemur", "femur", Side::left},
      {"rwrist", "wrist", Side::right},
      {"LHipJoint", "hipjoint", Side::left},
      {"left_knee", "knee", Side::left},
      {"Leftarm", "arm", Side::left},
      {"RightHand", "hand", Side::right},
      {"leg", "leg", Side::none},  // an l that is no side
      {"rear", "rear", Side::none},
      {"lowerback", "lowerback", Side::none},
      {"root", "root", Side::none},
      {"ribs", "ribs", Side::none},
      {"Bone", "bone", Side::none},  // a prefix alone is a name
      {"spine.006", "spine", Side::none},
      {"Ärmel.L", "Ärmel", Side::left},
  };
  for (const auto& c : cases) {
    const JointName name = joint_name(c.name);
    EXPECT_EQ(name.word, c.word) << c.name;
    EXPECT_EQ(name.side, c.side) << c.name;
    EXPECT_FALSE(name.helper) << c.name;
  }
}

TEST(JointName, LegsOfFourSayFrontOrBack) {
  EXPECT_TRUE(joint_name("fore_thigh.L").fore);
  EXPECT_TRUE(joint_name("LeftFrontUpperLeg").fore);
  EXPECT_EQ(joint_name("LeftFrontUpperLeg").word, "upperleg");
  EXPECT_TRUE(joint_name("hind_paw.R").hind);
  EXPECT_TRUE(joint_name("BackLeg_R").hind);
  EXPECT_FALSE(joint_name("LeftForeArm").fore);  // the lower half of an arm
}

TEST(JointName, TwistsControlsAndEndsAreNoBones) {
  for (const char* name : {"upperarm_twist_01_l", "ik_foot_l", "LeftUpLegRoll", "Bip01 HeadNub",
                           "hand_tip.L", "HeadTop_End", "foot_ik.R", "LeftFootSite"})
    EXPECT_TRUE(joint_name(name).helper) << name;
}

}  // namespace
}  // namespace artisketch

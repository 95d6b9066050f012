#include "files/bvh_file.h"

#include <gtest/gtest.h>

#include "fuzz/mutations.h"

namespace artisketch {
namespace {

const std::string kWave = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Left Arm
  {
    OFFSET 10 50 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -30 0
    }
  }
  JOINT Leg
  {
    OFFSET 0 -90 0
    CHANNELS 0
  }
}
MOTION
Frames: 2
Frame Time: 0.0333333
0 90 0  0 0 0  0 0 0
5 91 -2  10 20 30  90 0 -45
)";

std::string fault_of(const std::string& text) {
  const Result<Motion> motion = parse_bvh(text, "wave", "wave.bvh");
  return motion ? "" : motion.error().text();
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(BvhFile, JointsAndPosesAreRead) {
  const Result<Motion> read = parse_bvh(kWave, "wave", "wave.bvh");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->name, "wave");
  EXPECT_NEAR(read->step, 1 / 30.0, 1e-6);
  const Skeleton& skeleton = read->skeleton;
  ASSERT_EQ(skeleton.size(), 4);
  EXPECT_EQ(skeleton.find("Left Arm"), 1);
  EXPECT_EQ(skeleton.joints[2].name, "");
  EXPECT_EQ(skeleton.joints[2].parent, 1);
  EXPECT_EQ(skeleton.joints[3].parent, 0);
  ASSERT_EQ(read->poses.size(), 2u);
  EXPECT_EQ(read->poses[1].root_position, Vec3(5, 91, -2));
  const auto about = [](double angle, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(radians(angle), axis));
  };
  // In the order of the channels.
  EXPECT_LT(read->poses[1].rotations[0].angularDistance(
                about(10, Vec3::UnitZ()) * about(20, Vec3::UnitX()) * about(30, Vec3::UnitY())),
            1e-12);
  EXPECT_LT(read->poses[1].rotations[1].angularDistance(about(90, Vec3::UnitZ()) *
                                                        about(-45, Vec3::UnitY())),
            1e-12);
}

TEST(BvhFile, FaultsNameTheLineAndWhatWouldBeRight) {
  const struct {
    std::string text, says;
  } cases[] = {
      {"", "line 1"},
      {"not a bvh", "should be HIERARCHY"},
      {with(kWave, "0 90 0", "0 nan 0"), "line 24: is 'nan'"},
      {with(kWave, "0 90 0", "0 1e9 0"), "line 24: is '1e9'"},
      {with(kWave, "0 90 0", "0 9x 0"), "line 24: is '9x'"},
      {with(kWave, "90 0 -45", "90 0"), "ends where"},
      {kWave + "7\n", "line 26: goes on"},
      {with(kWave, "Frames: 2", "Frames: 0"), "has no frames"},
      {with(kWave, "Frames: 2", "Frames: 1e5000"), "line 22"},
      {with(kWave, "Frames: 2", "Frames: 1.5"), "line 22"},
      {with(kWave, "0.0333333", "0"), "line 23"},
      {with(kWave, "0.0333333", "-1"), "line 23"},
      {with(kWave, "JOINT Leg", "JOINT Hips"), "names should be given, each once"},
      {with(kWave, "JOINT Leg", "JOINT"), "is 'OFFSET'; should be {"},
      {with(kWave, "Xposition", "Wposition"), "line 5: is 'Wposition'"},
      {with(kWave, "CHANNELS 6", "CHANNELS 7"), "line 5"},
      {with(kWave, "OFFSET 10", "OFSET 10"), "line 8: is 'OFSET'"},
      {with(kWave, "End Site", "Limb"), "line 10: is 'Limb'"},
  };
  for (const auto& c : cases)
    EXPECT_NE(fault_of(c.text).find(c.says), std::string::npos) << fault_of(c.text);
}

TEST(BvhFile, NestingHasAnEnd) {
  std::string text = "HIERARCHY\nROOT a";
  for (int i = 0; i < 5000; ++i)
    text += "\n{\nOFFSET 0 1 0\nCHANNELS 0\nJOINT j" + std::to_string(i);
  EXPECT_NE(fault_of(text).find("nests"), std::string::npos);
}

TEST(BvhFile, ManyFramesAreRefusedBeforeTheyAreRead) {
  EXPECT_NE(fault_of(with(kWave, "Frames: 2", "Frames: 999999")).find("10 million"),
            std::string::npos);
}

TEST(BvhFile, BrokenFilesAreFaultsAndNothingWorse) {
  Mutator mutator(5);
  int read = 0;
  for (int i = 0; i < 3000; ++i) {
    const Result<Motion> motion = parse_bvh(mutator.damaged(kWave), "x", "x.bvh");
    if (!motion) {
      EXPECT_EQ(motion.error().text().rfind("x.bvh: line ", 0), 0u) << motion.error().text();
      continue;
    }
    ++read;
    for (const Pose& pose : motion->poses) {
      EXPECT_TRUE(pose.root_position.allFinite());
      for (const Quat& q : pose.rotations) EXPECT_NEAR(q.norm(), 1, 1e-9);
    }
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace artisketch

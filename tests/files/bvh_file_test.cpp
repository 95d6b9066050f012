#include "files/bvh_file.h"

#include <cctype>
#include <cstring>

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
      {with(kWave, "JOINT Leg", "JOINT"), "names should be given"},
      {with(kWave, "Xposition", "Wposition"), "line 5: is 'wposition'"},
      {with(kWave, "CHANNELS 6", "CHANNELS 7"), "line 5"},
      {with(kWave, "OFFSET 10", "OFSET 10"), "line 8: is 'OFSET'"},
      {with(kWave, "End Site", "Limb"), "line 10: is 'Limb'"},
  };
  for (const auto& c : cases)
    EXPECT_NE(fault_of(c.text).find(c.says), std::string::npos) << fault_of(c.text);
}

TEST(BvhFile, FilesAreReadAsProgramsWriteThem) {
  const auto replaced = [](std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
      text.replace(at, what.size(), by);
    return text;
  };
  std::string lower = kWave;
  for (const char* word : {"HIERARCHY", "ROOT", "OFFSET", "CHANNELS", "JOINT", "End Site", "MOTION",
                           "Frames", "Frame Time", "Xposition", "Zrotation"}) {
    std::string small = word;
    for (char& c : small) c = char(std::tolower(c));
    lower = replaced(lower, word, small);
  }
  const struct {
    const char* what;
    std::string text;
  } cases[] = {
      {"a byte order mark", "\xEF\xBB\xBF" + kWave},
      {"ends of lines by CR", replaced(kWave, "\n", "\r")},
      {"ends of lines by CR and LF", replaced(kWave, "\n", "\r\n")},
      {"tabs", replaced(kWave, "  ", "\t")},
      {"small letters", lower},
      {"no space after a colon",
       replaced(replaced(kWave, "Frames: ", "Frames:"), "Time: ", "Time:")},
      {"a space before a colon", replaced(kWave, "Frames:", "Frames :")},
      {"comments", "# made by hand\n" + replaced(kWave, "MOTION", "// moves\nMOTION")},
      {"a brace on the joint's line", replaced(kWave, "JOINT Leg\n  {", "JOINT Leg {")},
      {"an end by another name", replaced(kWave, "End Site", "End Effector")},
      {"nothing after the last row", kWave.substr(0, kWave.size() - 1)},
  };
  const Result<Motion> plain = parse_bvh(kWave, "wave", "wave.bvh");
  ASSERT_TRUE(plain);
  for (const auto& c : cases) {
    const Result<Motion> read = parse_bvh(c.text, "wave", "wave.bvh");
    ASSERT_TRUE(read) << c.what << ": " << read.error().text();
    EXPECT_TRUE(read->warnings.empty()) << c.what;
    ASSERT_EQ(read->skeleton.size(), plain->skeleton.size()) << c.what;
    for (int j = 0; j < plain->skeleton.size(); ++j) {
      EXPECT_EQ(read->skeleton.joints[j].name, plain->skeleton.joints[j].name) << c.what;
      EXPECT_EQ(read->skeleton.joints[j].offset, plain->skeleton.joints[j].offset) << c.what;
    }
    ASSERT_EQ(read->poses.size(), plain->poses.size()) << c.what;
    for (std::size_t k = 0; k < plain->poses.size(); ++k)
      EXPECT_TRUE(same_pose(read->poses[k], plain->poses[k])) << c.what;
  }
}

TEST(BvhFile, LinesAreCountedWhicheverWayTheyEnd) {
  for (const char* end : {"\n", "\r", "\r\n"}) {
    std::string text = with(kWave, "OFFSET 10", "OFSET 10");
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += std::strlen(end))
      text.replace(at, 1, end);
    EXPECT_NE(fault_of(text).find("line 8: is 'OFSET'"), std::string::npos) << fault_of(text);
  }
}

TEST(BvhFile, RowsMoreOrFewerThanSaidAreAWarning) {
  for (const auto& [said, word] :
       {std::pair("Frames: 1", "1 frame"), std::pair("Frames: 3", "3 frames")}) {
    const Result<Motion> read = parse_bvh(with(kWave, "Frames: 2", said), "wave", "wave.bvh");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->poses.size(), 2u);
    ASSERT_EQ(read->warnings.size(), 1u);
    EXPECT_NE(read->warnings[0].find(word), std::string::npos) << read->warnings[0];
  }
}

TEST(BvhFile, APositionStandsInPlaceOfItsOffset) {
  const std::string root = with(kWave, "OFFSET 0 0 0", "OFFSET 3 80 7");
  const Result<Motion> read = parse_bvh(root, "wave", "wave.bvh");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->poses[0].root_position, Vec3(0, 90, 0));
}

TEST(BvhFile, JointsBelowTheRootHavePlacesOfTheirOwn) {
  const auto text = [](const std::string& first, const std::string& second) {
    return "HIERARCHY\nROOT World\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
           "JOINT Hips\n{\nOFFSET 0 100 0\n"
           "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
           "End Site\n{\nOFFSET 0 10 0\n}\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.1\n"
           "0 0 0 " +
           first + " 0 0 0\n0 0 0 " + second + " 0 0 0\n";
  };
  // As places, or, as some write them, as ways from the offset.
  for (const auto& [first, second] :
       {std::pair("0 100 0", "0 60 200"), std::pair("0 0 0", "0 -10 5")}) {
    const Result<Motion> read = parse_bvh(text(first, second), "way", "way.bvh");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LT((posed_joints(*read, 0)[1].translation() - Vec3(0, 100, 0)).norm(), 1e-9);
    const Vec3 there = std::string(first) == "0 0 0" ? Vec3(0, 90, 5) : Vec3(0, 60, 200);
    EXPECT_LT((posed_joints(*read, 1)[1].translation() - there).norm(), 1e-9);
  }
}

// Hips that go far from where their offset has them, below them a spine that keeps its place.
TEST(BvhFile, AFarWayIsNotTakenForAnOffset) {
  const Result<Motion> read = parse_bvh(
      "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 0\nJOINT Hips\n{\nOFFSET 1 94 -452\n"
      "CHANNELS 3 Xposition Yposition Zposition\nJOINT Spine\n{\nOFFSET 16 0 0\n"
      "CHANNELS 3 Xposition Yposition Zposition\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n"
      "-6 91 363 16 0 0\n",
      "way", "way.bvh");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_LT((posed_joints(*read, 0)[2].translation() - Vec3(10, 91, 363)).norm(), 1e-9);
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

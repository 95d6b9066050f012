// Files of the kinds that one finds, as small as they can be, and what must come of them.
#include <functional>

#include <gtest/gtest.h>

#include "files/bvh_file.h"
#include "model/rig/retarget.h"

namespace artisketch {
namespace {

// Hips at 1 above the ground, ankles at 0.1, arms to the sides.
Document mini() {
  Document document;
  std::vector<Joint>& joints = document.skeleton.joints;
  const auto add = [&](const char* name, const char* parent, const Vec3& offset) {
    joints.push_back({name, document.skeleton.find(parent), offset, -1, ""});
  };
  add("hips", "", {0, 1, 0});
  add("chest", "hips", {0, 0.4, 0});
  add("head", "chest", {0, 0.3, 0});
  add("upper_arm.L", "chest", {0.2, 0.2, 0});
  add("hand.L", "upper_arm.L", {0.5, 0, 0});
  add("upper_arm.R", "chest", {-0.2, 0.2, 0});
  add("hand.R", "upper_arm.R", {-0.5, 0, 0});
  add("thigh.L", "hips", {0.15, 0, 0});
  add("foot.L", "thigh.L", {0, -0.9, 0});
  add("thigh.R", "hips", {-0.15, 0, 0});
  add("foot.R", "thigh.R", {0, -0.9, 0});
  return document;
}

using Turn = std::function<Vec3(const Vec3&)>;
Vec3 as_it_is(const Vec3& v) {
  return v;
}

// The same figure a hundred times as large; `turn` lays its rest pose otherwise. Rows: the hips'
// place and turn, then three angles (z, x, y) a joint in the order of mini's, without the ends.
std::string file(const Turn& turn, const std::vector<std::string>& rows,
                 bool below_a_root = false) {
  const auto offset = [&](const Vec3& at) {
    const Vec3 v = turn(at);
    return "OFFSET " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
           std::to_string(v.z()) + "\n";
  };
  const std::string place =
                        "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n",
                    angles = "CHANNELS 3 Zrotation Xrotation Yrotation\n",
                    end = "End Site\n{\nOFFSET 0 0 0\n}\n}\n";
  const auto limb = [&](const char* upper, const Vec3& to, const char* lower, const Vec3& on) {
    return std::string("JOINT ") + upper + "\n{\n" + offset(to) + angles + "JOINT " + lower +
           "\n{\n" + offset(on) + angles + end + "}\n";
  };
  std::string text = "HIERARCHY\n";
  if (below_a_root)
    text += "ROOT reference\n{\nOFFSET 0 0 0\n" + place + "JOINT Hips\n{\n" + offset({0, 100, 0}) +
            place;
  else
    text += "ROOT Hips\n{\nOFFSET 0 0 0\n" + place;
  text += "JOINT Spine\n{\n" + offset({0, 40, 0}) + angles;
  text += "JOINT Head\n{\n" + offset({0, 30, 0}) + angles + end;
  text += limb("LeftArm", {20, 20, 0}, "LeftHand", {50, 0, 0});
  text += limb("RightArm", {-20, 20, 0}, "RightHand", {-50, 0, 0}) + "}\n";
  text += limb("LeftUpLeg", {15, 0, 0}, "LeftFoot", {0, -90, 0});
  text += limb("RightUpLeg", {-15, 0, 0}, "RightFoot", {0, -90, 0}) + "}\n";
  if (below_a_root) text += "}\n";
  text += "MOTION\nFrames: " + std::to_string(rows.size()) + "\nFrame Time: 0.0333333\n";
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

std::string still(int joints) {
  std::string zeros;
  for (int i = 0; i < 3 * joints; ++i) zeros += " 0";
  return zeros;
}

Retargeted moved(const std::string& text, const Document& document = mini()) {
  const Result<Motion> motion = parse_bvh(text, "found", "found.bvh");
  EXPECT_TRUE(motion) << motion.error().text();
  if (!motion) return {};
  const Result<Retargeted> result = retargeted(document, *motion, {});
  EXPECT_TRUE(result) << result.error().text();
  return result ? *result : Retargeted();
}

Vec3 place(const Retargeted& result, std::size_t pose, const char* joint,
           const Document& document = mini()) {
  return posed_joints(document.skeleton, result.clip.poses.at(pose))[document.skeleton.find(joint)]
      .translation();
}

#define EXPECT_AT(result, pose, joint, ...)                                \
  EXPECT_LT((place(result, pose, joint) - Vec3(__VA_ARGS__)).norm(), 0.02) \
      << joint << " at " << place(result, pose, joint).transpose()

TEST(FoundMotions, UsualNamesMoveWhatTheyMean) {
  const Retargeted result =
      moved(file(as_it_is, {"0 100 0" + still(11),
                            "0 100 0 0 0 0  0 0 0  0 0 0  -80 0 0  0 0 0  80 0 0  0 0 0  0 -60 0" +
                                still(3)}));
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_EQ(result.map.matches.size(), 11u);
  EXPECT_AT(result, 1, "hand.L", 0.29, 1.11, 0);
  EXPECT_AT(result, 1, "hand.R", -0.29, 1.11, 0);
  EXPECT_AT(result, 1, "foot.L", 0.15, 0.55, 0.78);
}

TEST(FoundMotions, TheHipsOwnWayBelowARootIsGone) {
  const Retargeted result = moved(file(
      as_it_is, {"0 0 0 0 0 0 0 100 0" + still(11), "0 0 0 0 0 0 0 60 200" + still(11)}, true));
  EXPECT_AT(result, 0, "hips", 0, 1, 0);
  EXPECT_AT(result, 1, "hips", 0, 0.6, 2);
}

TEST(FoundMotions, ARestPoseThatLiesIsNotTheFigures) {
  const auto lying = [](const Vec3& v) { return Vec3(v.y(), -v.x(), v.z()); };
  const Retargeted result =
      moved(file(lying, {"0 90 0 90 0 0" + still(10), "0 90 0 90 0 0" + still(10)}));
  EXPECT_FALSE(result.z_up);
  for (const std::size_t k : {0, 1}) {
    EXPECT_AT(result, k, "hips", 0, 1, 0);
    EXPECT_AT(result, k, "head", 0, 1.7, 0);
    EXPECT_AT(result, k, "hand.L", 0.7, 1.6, 0);
    EXPECT_AT(result, k, "foot.R", -0.15, 0.1, 0);
  }
}

TEST(FoundMotions, ZIsUpWhereTheFigureStandsAlongIt) {
  const auto z_up = [](const Vec3& v) { return Vec3(v.x(), -v.z(), v.y()); };
  const Retargeted result = moved(file(z_up, {"0 0 100" + still(11), "0 -200 100" + still(11)}));
  EXPECT_TRUE(result.z_up);
  EXPECT_AT(result, 0, "hips", 0, 1, 0);
  EXPECT_AT(result, 1, "hips", 0, 1, 2);
  EXPECT_AT(result, 1, "foot.L", 0.15, 0.1, 2);
  EXPECT_AT(result, 1, "head", 0, 1.7, 2);
}

TEST(FoundMotions, ARowMoreThanSaidIsAWarning) {
  std::string text =
      file(as_it_is, {"0 100 0" + still(11), "0 100 0" + still(11), "0 100 0" + still(11)});
  text.replace(text.find("Frames: 3"), 9, "Frames: 2");
  const Retargeted result = moved(text);
  EXPECT_EQ(result.clip.poses.size(), 3u);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("says that it has 2 frames"), std::string::npos);
}

TEST(FoundMotions, AFigureThatStandsDoesNotFloat) {
  const Retargeted result = moved(file(as_it_is, {"0 100 0" + still(11), "0 100 0" + still(11)}));
  EXPECT_AT(result, 0, "hips", 0, 1, 0);
  EXPECT_AT(result, 0, "foot.L", 0.15, 0.1, 0);
  // Nor where its rest pose has its legs spread, or the hips begin at zero.
  const auto spread = [](const Vec3& v) { return v.y() < -50 ? Vec3(60, -67, 0) : v; };
  const std::string straight =
      "0 100 0 0 0 0" + still(6) + " -41.845 0 0" + still(1) + " -41.845 0 0" + still(1);
  const Retargeted legs = moved(file(spread, {straight, straight}));
  EXPECT_AT(legs, 0, "hips", 0, 1, 0);
  const Retargeted low = moved(file(as_it_is, {"0 0 0" + still(11), "0 0 5" + still(11)}));
  EXPECT_AT(low, 0, "hips", 0, 1, 0);
  EXPECT_AT(low, 0, "foot.R", -0.15, 0.1, 0);
}

TEST(FoundMotions, NamesInTheDocumentThatTheMotionDoesNotHaveAreSaid) {
  Document document = mini();
  document.motion.joints = {{"Hip", 0}, {"LeftArms", 3}};
  const Retargeted result = moved(file(as_it_is, {"0 100 0" + still(11)}), document);
  ASSERT_EQ(result.warnings.size(), 2u);
  EXPECT_NE(result.warnings[0].find("'Hip'"), std::string::npos);
  EXPECT_NE(result.warnings[1].find("'LeftArms'"), std::string::npos);
}

TEST(FoundMotions, ByteOrderMarksAndOldEndsOfLinesAreRead) {
  std::string text = file(as_it_is, {"0 100 0" + still(11)});
  EXPECT_AT(moved("\xEF\xBB\xBF" + text), 0, "hips", 0, 1, 0);
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_AT(moved(text), 0, "hips", 0, 1, 0);
}

}  // namespace
}  // namespace artisketch

// Files of the kinds that one finds, as small as they can be, and what must come of them.
#include <functional>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "files/bvh_file.h"
#include "files/bytes.h"
#include "files/document_file.h"
#include "model/rig/actor.h"
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

// ---------------------------------------------------------------- by where one finds them

// What those that record motions are known for: names, rest pose, axis, and where positions stand.
struct FoundKind {
  const char* where;
  const char* names;  // of vocabularies()
  Rest rest;
  bool z_up = false;
  bool below_a_root = false;  // the hips have positions of their own, below a root that stays
  bool twice = false;         // the root has an offset, and its positions hold it again
  bool odd = false;           // a row more than the header says, byte order mark, CR, tabs
};
constexpr FoundKind kFoundKinds[] = {
    {"CMU, as BVH", "CMU", Rest::t_pose},
    {"CMU, first frame at rest", "CMU", Rest::first_frame},
    {"CMU, as ASF", "CMU's own", Rest::any},
    {"Mixamo", "Mixamo", Rest::t_pose},
    {"Mixamo without prefix", "Mixamo without prefix", Rest::a_pose},
    {"Bandai-Namco", "Bandai-Namco", Rest::all_one_way, false, true},
    {"LaFAN1", "LaFAN", Rest::all_one_way},
    {"Rokoko", "Rokoko", Rest::along_x, false, false, true},
    {"Rokoko, a row too many", "Rokoko", Rest::along_x, false, false, true, true},
    {"Animated Drawings", "CMU", Rest::t_pose, true},
    {"PyMO's sample", "Biovision", Rest::first_frame},
};

std::string text_of(const FoundKind& kind, const Actor& actor) {
  const Vocabulary* names = nullptr;
  for (const Vocabulary& one : vocabularies())
    if (std::string(one.name) == kind.names) names = &one;
  Motion motion = recorded(actor, *names, kind.rest, kind.z_up);
  if (kind.twice) motion.skeleton.joints[0].offset = motion.poses[0].root_position;
  std::string text = bvh_text(motion);
  if (kind.below_a_root) {
    // As many numbers a row more: the root's, all 0.
    const std::string place =
        "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
    text.replace(text.find("ROOT"), 4, "ROOT reference\n{\nOFFSET 0 0 0\n" + place + "JOINT");
    const std::size_t at = text.find("MOTION");
    text.insert(at, "}\n");
    for (std::size_t row = text.find('\n', text.find("Frame Time")); row + 1 < text.size();
         row = text.find('\n', row + 1))
      text.insert(row + 1, "0 0 0 0 0 0 ");
  }
  if (kind.odd) {
    const std::string count = "Frames: " + std::to_string(motion.poses.size());
    text.replace(text.find(count), count.size(),
                 "Frames:" + std::to_string(motion.poses.size() - 1));
    for (char& c : text)
      if (c == ' ') c = '\t';
    std::string ends = "\xEF\xBB\xBF";
    for (const char c : text) ends += c == '\n' ? std::string("\r\n") : std::string(1, c);
    text = ends;
  }
  return text;
}

struct Shown {
  int turn = 0;        // parts that turn in the world
  double upright = 0;  // degrees that the trunk leans at the median time
  double arms = 0, trunk = 0, off_ground = 0, slides = 0;
};
Shown shown(const Document& document, const Clip& clip, const Actor& actor) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  std::set<int> parts;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours) parts.insert(contour.joint);
  Shown out;
  std::vector<double> leans;
  std::vector<std::vector<Transform>> posed;
  for (const Pose& pose : clip.poses) posed.push_back(posed_joints(skeleton, pose));
  const auto turn = [&](std::size_t k, int j) { return Quat(posed[k][std::size_t(j)].linear()); };
  for (const int part : parts) {
    double most = 0;
    for (std::size_t k = 0; k < posed.size(); ++k)
      most = std::max(most, turn(0, part).angularDistance(turn(k, part)));
    out.turn += most > radians(2);
  }
  const auto way = [&](std::size_t k, const char* from, const char* to) -> Vec3 {
    return posed[k][std::size_t(skeleton.find(to))].translation() -
           posed[k][std::size_t(skeleton.find(from))].translation();
  };
  const auto apart = [](const Vec3& a, const Vec3& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
  };
  for (std::size_t k = 0; k < posed.size(); ++k) {
    const std::vector<Vec3> truth = actor.at(int(k));
    const auto theirs = [&](const char* from, const char* to) -> Vec3 {
      return truth[std::size_t(actor.find(to))] - truth[std::size_t(actor.find(from))];
    };
    leans.push_back(apart(way(k, "hips", "head"), Vec3::UnitY()));
    out.trunk = std::max(out.trunk, apart(way(k, "hips", "head"), theirs("hips", "head")));
    for (const auto& [from, to] :
         {std::pair("upper_arm.L", "forearm.L"), std::pair("forearm.R", "hand.R")})
      out.arms = std::max(out.arms, apart(way(k, from, to), theirs(from, to)));
  }
  std::nth_element(leans.begin(), leans.begin() + std::ptrdiff_t(leans.size() / 2), leans.end());
  out.upright = leans[leans.size() / 2];
  for (const char* foot : {"foot.L", "foot.R"}) {
    const int j = skeleton.find(foot);
    std::optional<Vec3> stood;
    for (std::size_t k = 0; k < posed.size(); ++k) {
      const Vec3 at = posed[k][std::size_t(j)].translation();
      if (!actor.stands.at(foot)[k]) {
        stood.reset();
        continue;
      }
      if (!stood) stood = at;
      out.slides = std::max(out.slides, (at - *stood).norm() / rest[0].y());
      out.off_ground =
          std::max(out.off_ground, std::abs(at.y() - rest[std::size_t(j)].y()) / rest[0].y());
    }
  }
  return out;
}

// The hero, moved by a walk as each of them would have recorded it, and no map.
TEST(FoundMotionsTable, TheHeroWalksWhoeverRecordedIt) {
  const Actor actor = walking_person();
  const auto bytes = read_file(ARTISKETCH_SOURCE_DIR "/assets/examples/hero/hero.artisketch");
  ASSERT_TRUE(bytes);
  const auto document = parse_document(*bytes, "hero");
  ASSERT_TRUE(document);
  std::printf("%-26s %6s %8s %7s %7s %8s %8s\n", "recorded by", "turn", "upright", "arms", "trunk",
              "ground", "slides");
  for (const FoundKind& kind : kFoundKinds) {
    const Result<Motion> motion = parse_bvh(text_of(kind, actor), "walk", "walk.bvh");
    ASSERT_TRUE(motion) << kind.where << ": " << motion.error().text();
    const Result<Retargeted> result = retargeted(*document, *motion, {});
    ASSERT_TRUE(result) << kind.where;
    EXPECT_EQ(result->warnings.size(), kind.odd ? 1u : 0u) << kind.where;
    EXPECT_EQ(result->z_up, kind.z_up) << kind.where;
    ASSERT_EQ(result->clip.poses.size(), actor.turns.size());
    const Shown found = shown(*document, result->clip, actor);
    std::printf("%-26s %3d/15 %7.2f\u00b0 %6.2f\u00b0 %6.2f\u00b0 %6.2f %% %6.2f %%\n", kind.where,
                found.turn, found.upright, found.arms, found.trunk, 100 * found.off_ground,
                100 * found.slides);
    EXPECT_GE(found.turn, 11) << kind.where;
    EXPECT_LT(found.upright, 15) << kind.where;  // the actor leans forward by 7
    EXPECT_LT(found.arms, 1) << kind.where;
    EXPECT_LT(found.trunk, 5) << kind.where;
    EXPECT_LT(found.off_ground, 0.01) << kind.where;
    EXPECT_LT(found.slides, 0.01) << kind.where;
    const double way =
        result->clip.poses.back().root_position.z() - result->clip.poses[0].root_position.z();
    EXPECT_GT(way, 1.5 * result->scale * 100) << kind.where;  // of 2.4 m
  }
}

}  // namespace
}  // namespace artisketch

#include "model/rig/retarget.h"

#include <gtest/gtest.h>

#include "document/templates.h"
#include "files/bvh_file.h"
#include "model/rig/actor.h"

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
                            {"Limb", 0, {2, 10, 0}, -1, ""},
                            {"Claw", 1, {0, -10, 0}, -1, ""},
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

std::vector<Vec3> places(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Vec3> at;
  for (const Transform& joint : posed_joints(skeleton, pose)) at.push_back(joint.translation());
  return at;
}

Vec3 bone(const Skeleton& skeleton, const Pose& pose, int from, int to) {
  const std::vector<Vec3> at = places(skeleton, pose);
  return (at[to] - at[from]).normalized();
}

double angle_between(const Vec3& a, const Vec3& b) {
  return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

TEST(Retarget, BonesPointAsTheMotionsDoThoughTheRestPosesDiffer) {
  Document document = figure();
  document.motion.joints = {{"Limb", 1}, {"Claw", 2}};
  const Motion source = motion();
  const Result<Retargeted> result = retargeted(document, source, {});
  ASSERT_TRUE(result);
  const Clip& clip = result->clip;
  EXPECT_EQ(clip.name, "walk");
  EXPECT_EQ(clip.times, (std::vector<double>{0, 0.5, 1}));
  for (int k = 0; k < 3; ++k) {
    const Vec3 theirs = bone(source.skeleton, source.poses[k], 1, 2);
    EXPECT_LT((bone(document.skeleton, clip.poses[k], 1, 2) - theirs).norm(), 1e-9);
    for (const Quat& q : clip.poses[k].rotations) EXPECT_NEAR(q.norm(), 1, 1e-12);
  }
}

TEST(Retarget, TheRootsWayIsScaledByTheHeightOfTheHips) {
  const Result<Retargeted> result = retargeted(figure(), motion(), {});
  ASSERT_TRUE(result);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT((result->clip.poses[k].root_position - Vec3(0, 2 - 0.1 * k, 1.0 * k)).norm(), 1e-12);
}

TEST(Retarget, EqualNamesBelongTogetherWhateverTheirCase) {
  const Document document = figure();
  const Motion source = motion();  // "Hips" and "Foot" are known, the arm is not
  const Result<Retargeted> result = retargeted(document, source, {});
  ASSERT_TRUE(result);
  EXPECT_LT(result->clip.poses[2].rotations[0].angularDistance(about(40, Vec3::UnitY())), 1e-9);
  EXPECT_LT(result->clip.poses[2].rotations[1].angularDistance(Quat::Identity()), 1e-9);
  EXPECT_EQ(result->map.still, std::vector<int>{1});
  ASSERT_EQ(result->warnings.size(), 1u);
  EXPECT_NE(result->warnings[0].find("upper_arm.L"), std::string::npos);
}

TEST(Retarget, AMotionOfUnknownNamesSaysHowToMapThem) {
  Document document = figure();
  Motion source = motion();
  const char* unknown[] = {"ab", "cd", "ef", "gh"};
  for (int j = 0; j < 4; ++j) source.skeleton.joints[j].name = unknown[j];
  const Result<Retargeted> none = retargeted(document, source, {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("/motion/joints"), std::string::npos);
  document.motion.joints = {{"ab", 0}};
  EXPECT_TRUE(retargeted(document, source, {}));
}

TEST(Retarget, APairOfNamesThatTheMotionDoesNotHaveIsNamed) {
  Document document = figure();
  document.motion.joints = {{"Hip", 0}};
  const Result<Retargeted> result = retargeted(document, motion(), {});
  ASSERT_TRUE(result);
  EXPECT_NE(result->warnings[0].find("'Hip'"), std::string::npos);
  EXPECT_NE(result->warnings[0].find("'Hips'"), std::string::npos);
  EXPECT_EQ(result->map.mover[0], 0);  // by its name
}

TEST(Retarget, CollarBonesThatTheMotionLacksFollowNothing) {
  const Actor actor = walking_person();
  Motion motion = recorded(actor, vocabularies()[0], Rest::t_pose, false);
  // Its arms hang on the chest, and what was a collar bone is a twist beside them.
  std::vector<Joint>& joints = motion.skeleton.joints;
  for (Joint& joint : joints)
    if (joint.parent >= 0 && joints[std::size_t(joint.parent)].name.ends_with("Shoulder")) {
      joint.offset += joints[std::size_t(joint.parent)].offset;
      joint.parent = joints[std::size_t(joint.parent)].parent;
    }
  for (Joint& joint : joints)
    if (joint.name.ends_with("Shoulder")) joint.name += "Twist";
  Document document;
  document.skeleton = actor.skeleton;
  const Result<Retargeted> made = retargeted(document, motion, {});
  ASSERT_TRUE(made) << made.error().text();
  for (const Pose& pose : made->clip.poses)
    for (const Quat& turn : pose.rotations) EXPECT_NEAR(turn.norm(), 1, 1e-9);
  EXPECT_EQ(made->map.mover[std::size_t(document.skeleton.find("collar.L"))], -1);
}

TEST(Retarget, AJointThatNobodyShallMoveStaysAsAtRest) {
  const Actor actor = walking_person();
  const Motion motion = recorded(actor, vocabularies()[0], Rest::t_pose, false);
  Document document;
  document.skeleton = actor.skeleton;
  const auto size = [&](const char* joint) { return std::size_t(document.skeleton.find(joint)); };
  document.motion.joints = {{"", int(size("forearm.L"))}, {"", int(size("shin.R"))}};
  const Result<Retargeted> made = retargeted(document, motion, {});
  ASSERT_TRUE(made) << made.error().text();
  for (const char* joint : {"forearm.L", "shin.R"}) {
    EXPECT_EQ(made->map.mover[size(joint)], -1);
    for (const Pose& pose : made->clip.poses)
      EXPECT_LT(pose.rotations[size(joint)].angularDistance(Quat::Identity()), 1e-9) << joint;
  }
  EXPECT_TRUE(made->map.still.empty());
  EXPECT_TRUE(made->warnings.empty());
}

TEST(Retarget, FlatSkeletonsDoNotDivideByNothing) {
  Document document = figure();
  Motion source = motion();
  for (Joint& joint : source.skeleton.joints) joint.offset.setZero();
  for (Joint& joint : document.skeleton.joints) joint.offset.setZero();
  const Result<Retargeted> result = retargeted(document, source, {});
  ASSERT_TRUE(result);
  for (const Pose& pose : result->clip.poses) {
    EXPECT_TRUE(pose.root_position.allFinite());
    for (const Quat& q : pose.rotations) EXPECT_TRUE(q.coeffs().allFinite());
  }
}

// ---------------------------------------------------------------- every vocabulary, rest and axis

struct Kind {
  const Vocabulary* names;
  Rest rest;
  bool z_up;
};
void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.names->name << ", " << rest_word(kind.rest) << ", " << (kind.z_up ? "z" : "y")
       << " up";
}
std::vector<Kind> kinds(const std::vector<Vocabulary>& all) {
  std::vector<Kind> kinds;
  for (const Vocabulary& names : all)
    for (const Rest rest : kRests)
      for (const bool z_up : {false, true}) kinds.push_back({&names, rest, z_up});
  return kinds;
}

Document document_of(Template kind) {
  Document document;
  document.skeleton = template_skeleton(kind);
  return document;
}

// The motion as it would be read from a file.
Motion read(const Actor& actor, const Kind& kind) {
  const Motion made = recorded(actor, *kind.names, kind.rest, kind.z_up);
  Result<Motion> read = parse_bvh(bvh_text(made), "walk", "walk.bvh");
  EXPECT_TRUE(read) << read.error().text();
  return read ? *read : made;
}

struct Apart {
  double limbs = 0, trunk = 0;  // degrees, the most over all poses
};
// How far limbs and trunk are off the actor's: pairs of the document's and the actor's joints.
Apart apart(const Skeleton& skeleton, const Clip& clip, const Actor& actor,
            const std::vector<std::array<std::string, 4>>& limbs, const std::string& hips) {
  Apart most;
  for (std::size_t k = 0; k < clip.poses.size(); ++k) {
    const std::vector<Vec3> mine = places(skeleton, clip.poses[k]), truth = actor.at(int(k));
    const auto off = [&](const std::array<std::string, 4>& pair) {
      const Vec3 a = mine[skeleton.find(pair[1])] - mine[skeleton.find(pair[0])];
      const Vec3 b = truth[actor.find(pair[3])] - truth[actor.find(pair[2])];
      return angle_between(a, b);
    };
    for (const char* side : {".L", ".R"})
      for (std::array<std::string, 4> pair : limbs) {
        for (std::string& name : pair) name += side;
        most.limbs = std::max(most.limbs, off(pair));
      }
    most.trunk = std::max(most.trunk, off({hips, "head", "hips", "head"}));
  }
  return most;
}

class RetargetPerson : public testing::TestWithParam<Kind> {};

TEST_P(RetargetPerson, LimbsAndTrunkPointAsTheActorsDo) {
  const Actor actor = walking_person();
  const Document document = document_of(Template::human);
  RetargetOptions raw;
  raw.plant_feet = false;
  const Result<Retargeted> result = retargeted(document, read(actor, GetParam()), raw);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->map.still.empty()) << result->warnings.front();
  EXPECT_TRUE(result->warnings.empty());
  EXPECT_EQ(result->z_up, GetParam().z_up);
  const Apart off = apart(document.skeleton, result->clip, actor,
                          {{"upper_arm", "forearm", "upper_arm", "forearm"},
                           {"forearm", "hand", "forearm", "hand"},
                           {"thigh", "shin", "thigh", "shin"},
                           {"shin", "foot", "shin", "foot"}},
                          "hips");
  EXPECT_LT(off.limbs, 1);
  EXPECT_LT(off.trunk, 5);
}

INSTANTIATE_TEST_SUITE_P(All, RetargetPerson, testing::ValuesIn(kinds(vocabularies())));

class RetargetFourLegs : public testing::TestWithParam<Kind> {};

TEST_P(RetargetFourLegs, LimbsAndTrunkPointAsTheActorsDo) {
  const Actor actor = walking_dog();
  const Document document = document_of(Template::quadruped);
  RetargetOptions raw;
  raw.plant_feet = false;
  const Result<Retargeted> result = retargeted(document, read(actor, GetParam()), raw);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_TRUE(result->map.still.empty()) << result->warnings.front();
  EXPECT_EQ(result->z_up, GetParam().z_up);
  const Apart off = apart(document.skeleton, result->clip, actor,
                          {{"fore_thigh", "fore_shin", "upper_arm", "forearm"},
                           {"fore_shin", "fore_paw", "forearm", "hand"},
                           {"hind_thigh", "hind_shin", "thigh", "shin"},
                           {"hind_shin", "hind_paw", "shin", "foot"}},
                          "body");
  EXPECT_LT(off.limbs, 1);
  EXPECT_LT(off.trunk, 5);
}

INSTANTIATE_TEST_SUITE_P(All, RetargetFourLegs,
                         testing::ValuesIn(kinds(four_legged_vocabularies())));

// ---------------------------------------------------------------- feet

// The farthest that a foot is from the ground while the actor's stands flat, and the most it slides
// in one such contact, of the height of the hips.
struct Feet {
  double off_ground = 0, slides = 0, below = 0;
};
Feet measure(const Document& document, const Clip& clip, const Actor& actor,
             const std::vector<std::pair<std::string, std::string>>& feet) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  const double hips = rest[0].y();
  Feet most;
  for (const char* side : {".L", ".R"})
    for (const auto& [mine, theirs] : feet) {
      const int foot = skeleton.find(mine + side);
      const std::vector<bool>& stands = actor.stands.at(theirs + side);
      std::optional<Vec3> stood;
      for (std::size_t k = 0; k < clip.poses.size(); ++k) {
        const Vec3 at = places(skeleton, clip.poses[k])[foot];
        most.below = std::max(most.below, (rest[foot].y() - at.y()) / hips);
        if (!stands[k]) {
          stood.reset();
          continue;
        }
        if (!stood) stood = at;
        most.off_ground = std::max(most.off_ground, std::abs(at.y() - rest[foot].y()) / hips);
        most.slides = std::max(most.slides, (at - *stood).norm() / hips);
      }
    }
  return most;
}

// All of it at once, feet planted, a line for each vocabulary: the worst over rest poses and axes.
struct Row {
  std::string name;
  int kinds = 0, mapped = 0;
  Apart off;
  double legs = 0;
  Feet feet;
};
// Where thighs, shins and feet are in another proportion, feet that stay on the ground and in their
// place cost the legs some of their direction, most where they are nearly straight: 3 mm of a leg
// of 50 cm that is bent by 16 degrees are 3 degrees of each bone.
constexpr double kPersonsLegs = 2, kFourLegs = 6;  // degrees
using Pairs = std::vector<std::array<std::string, 4>>;
using FeetPairs = std::vector<std::pair<std::string, std::string>>;

Row row_of(const Vocabulary& names, const Actor& actor, const Document& document, const Pairs& arms,
           const Pairs& legs, const std::string& hips, const FeetPairs& feet) {
  Row row;
  row.name = names.name;
  for (const Kind& kind : kinds({names})) {
    ++row.kinds;
    const Result<Retargeted> result =
        retargeted(document, read(actor, {&names, kind.rest, kind.z_up}), {});
    if (!result) continue;
    row.mapped += result->map.still.empty();
    const Apart off = apart(document.skeleton, result->clip, actor, arms, hips);
    row.off.limbs = std::max(row.off.limbs, off.limbs);
    row.off.trunk = std::max(row.off.trunk, off.trunk);
    row.legs = std::max(row.legs, apart(document.skeleton, result->clip, actor, legs, hips).limbs);
    const Feet found = measure(document, result->clip, actor, feet);
    row.feet.off_ground = std::max(row.feet.off_ground, found.off_ground);
    row.feet.slides = std::max(row.feet.slides, found.slides);
    row.feet.below = std::max(row.feet.below, found.below);
  }
  return row;
}

void print_and_expect(const std::vector<Row>& table, double legs) {
  std::printf("%-24s %7s %7s %7s %7s %8s %8s\n", "vocabulary", "mapped", "arms", "legs", "trunk",
              "ground", "slides");
  for (const Row& row : table) {
    std::printf("%-24s %3d/%-3d %6.2f\u00b0 %6.2f\u00b0 %6.2f\u00b0 %6.2f %% %6.2f %%\n",
                row.name.c_str(), row.mapped, row.kinds, row.off.limbs, row.legs, row.off.trunk,
                100 * row.feet.off_ground, 100 * row.feet.slides);
    EXPECT_EQ(row.mapped, row.kinds) << row.name;
    EXPECT_LT(row.off.limbs, 1) << row.name;
    EXPECT_LT(row.legs, legs) << row.name;
    EXPECT_LT(row.off.trunk, 5) << row.name;
    EXPECT_LT(row.feet.off_ground, 0.01) << row.name;
    EXPECT_LT(row.feet.slides, 0.01) << row.name;
    EXPECT_LT(row.feet.below, 0.01) << row.name;
  }
}

TEST(RetargetTable, PersonsOfAnyVocabularyRestAndAxisWithFeetPlanted) {
  const Actor actor = walking_person();
  std::vector<Row> table;
  for (const Vocabulary& names : vocabularies())
    table.push_back(row_of(
        names, actor, document_of(Template::human),
        {{"upper_arm", "forearm", "upper_arm", "forearm"}, {"forearm", "hand", "forearm", "hand"}},
        {{"thigh", "shin", "thigh", "shin"}, {"shin", "foot", "shin", "foot"}}, "hips",
        {{"foot", "foot"}}));
  print_and_expect(table, kPersonsLegs);
}

TEST(RetargetTable, FourLegsOfAnyVocabularyRestAndAxisWithFeetPlanted) {
  const Actor actor = walking_dog();
  std::vector<Row> table;
  for (const Vocabulary& names : four_legged_vocabularies())
    table.push_back(row_of(names, actor, document_of(Template::quadruped), {},
                           {{"fore_thigh", "fore_shin", "upper_arm", "forearm"},
                            {"fore_shin", "fore_paw", "forearm", "hand"},
                            {"hind_thigh", "hind_shin", "thigh", "shin"},
                            {"hind_shin", "hind_paw", "shin", "foot"}},
                           "body", {{"hind_paw", "foot"}, {"fore_paw", "hand"}}));
  print_and_expect(table, kFourLegs);
}

TEST(RetargetFeet, PlantingLeavesLegsAloneThatStandRight) {
  const Pairs limbs = {{"thigh", "shin", "thigh", "shin"}, {"shin", "foot", "shin", "foot"}},
              fore = {{"upper_arm", "forearm", "upper_arm", "forearm"},
                      {"forearm", "hand", "forearm", "hand"}};
  const auto most = [](const Actor& actor, const Vocabulary& names, const Pairs& pairs) {
    Document document;
    document.skeleton = actor.skeleton;
    const Result<Retargeted> result =
        retargeted(document, read(actor, {&names, Rest::t_pose, false}), {});
    EXPECT_TRUE(result);
    return result ? apart(document.skeleton, result->clip, actor, pairs, "hips").limbs : 180;
  };
  EXPECT_LT(most(walking_person(), vocabularies()[0], limbs), 0.1);
  EXPECT_LT(most(walking_dog(), four_legged_vocabularies()[0], limbs), 0.1);
  EXPECT_LT(most(walking_dog(), four_legged_vocabularies()[0], fore), 0.1);
}

// Other proportions than the actor's: short legs, shins longer than thighs, big feet.
Document short_legged() {
  Document document = document_of(Template::human);
  for (Joint& joint : document.skeleton.joints) {
    if (joint.name.starts_with("shin")) joint.offset *= 0.6;
    if (joint.name.starts_with("foot.")) joint.offset *= 0.8;
  }
  const double lost = 0.4 * 0.4 + 0.2 * 0.39;
  document.skeleton.joints[0].offset.y() -= lost;
  return document;
}

TEST(RetargetFeet, StandWhereTheyStandOnTheGround) {
  const Actor actor = walking_person();
  for (const Document& document : {document_of(Template::human), short_legged()})
    for (const bool z_up : {false, true}) {
      const Kind kind{&vocabularies()[0], Rest::along_x, z_up};
      const Result<Retargeted> result = retargeted(document, read(actor, kind), {});
      ASSERT_TRUE(result);
      const Feet feet = measure(document, result->clip, actor, {{"foot", "foot"}});
      EXPECT_LT(feet.off_ground, 0.01);
      EXPECT_LT(feet.slides, 0.01);
      EXPECT_LT(feet.below, 0.01);
    }
}

TEST(RetargetFeet, OfFourLegsStandToo) {
  const Actor actor = walking_dog();
  const Document document = document_of(Template::quadruped);
  const Kind kind{&four_legged_vocabularies()[0], Rest::t_pose, false};
  const Result<Retargeted> result = retargeted(document, read(actor, kind), {});
  ASSERT_TRUE(result);
  const Feet feet =
      measure(document, result->clip, actor, {{"hind_paw", "foot"}, {"fore_paw", "hand"}});
  EXPECT_LT(feet.off_ground, 0.01);
  EXPECT_LT(feet.slides, 0.01);
}

TEST(RetargetFeet, AWalkGoesAsFarAsItsLegsCarryItOrStaysInPlace) {
  const Actor actor = walking_person();
  const Document document = document_of(Template::human);
  const Motion motion = read(actor, {&vocabularies()[0], Rest::t_pose, false});
  const Result<Retargeted> goes = retargeted(document, motion, {});
  ASSERT_TRUE(goes);
  const double legs = 0.79 / 0.83;
  EXPECT_NEAR(goes->clip.poses.back().root_position.z() - goes->clip.poses[0].root_position.z(),
              legs * 2.4, 0.03);
  EXPECT_TRUE(goes->loops);
  RetargetOptions options;
  options.in_place = true;
  const Result<Retargeted> stays = retargeted(document, motion, options);
  ASSERT_TRUE(stays);
  for (const Pose& pose : stays->clip.poses) EXPECT_LT(std::abs(pose.root_position.z()), 0.05);
}

}  // namespace
}  // namespace artisketch

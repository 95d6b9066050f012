#include "model/rig/own_skeleton.h"

#include <set>

#include <gtest/gtest.h>

#include "model/rig/actor.h"
#include "model/rig/retarget.h"

namespace artisketch {
namespace {

TEST(OwnSkeleton, KeepsNamesAndBonesAndStands) {
  const Actor actor = walking_person();
  for (const bool z_up : {false, true})
    for (const Rest rest : {Rest::t_pose, Rest::along_x, Rest::all_one_way}) {
      SCOPED_TRACE(std::string(rest_word(rest)) + (z_up ? ", z up" : ""));
      const Motion motion = recorded(actor, vocabularies()[0], rest, z_up);
      const Document document = document_with_skeleton(motion);
      const std::vector<Joint>& joints = document.skeleton.joints;
      ASSERT_EQ(document.skeleton.size(), motion.skeleton.size());
      std::set<std::string> names;
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const Joint& theirs = motion.skeleton.joints[j];
        EXPECT_EQ(joints[j].parent, theirs.parent);
        if (j > 0) {
          EXPECT_NEAR(joints[j].offset.norm(), theirs.offset.norm(), 1e-3);  // of 170
        }
        if (!theirs.name.empty()) {
          EXPECT_EQ(joints[j].name, theirs.name);
        }
        EXPECT_FALSE(joints[j].name.empty());
        EXPECT_TRUE(names.insert(joints[j].name).second) << joints[j].name;
      }
      const std::vector<Vec3> at = rest_positions(document.skeleton);
      const BodyPlan plan = body_plan_of(document.skeleton, at, false);
      const auto up = standing_direction(plan, at);
      ASSERT_TRUE(up);
      EXPECT_GT(up->y(), 0.9);
      double lowest = 1e9;
      for (const Vec3& p : at) lowest = std::min(lowest, p.y());
      EXPECT_NEAR(lowest, 0, 2e-3);
      if (rest == Rest::t_pose) {
        // Both hands are 170 cm apart at most, and each other's image.
        const LimbJoints &left = plan.arms[0], &right = plan.arms[1];
        EXPECT_EQ(joints[std::size_t(left.end)].mirror, right.end);
        EXPECT_EQ(joints[std::size_t(right.end)].mirror, left.end);
        EXPECT_EQ(joints[std::size_t(plan.head)].mirror, plan.head);
      }
      // The motion it came from moves all of it.
      const Result<Retargeted> moved = retargeted(document, motion, {});
      ASSERT_TRUE(moved);
      EXPECT_TRUE(moved->map.still.empty());
    }
}

TEST(OwnSkeleton, AnythingWithJointsIsOne) {
  Motion motion;
  motion.name = "rope";
  motion.skeleton.joints = {{"", -1, Vec3::Zero(), -1, ""},
                            {"a", 0, {1, 0, 0}, -1, ""},
                            {"a", 1, {1, 0, 0}, -1, ""},
                            {"", 2, Vec3::Zero(), -1, ""}};
  const Document document = document_with_skeleton(motion);
  std::vector<std::string> names;
  for (const Joint& joint : document.skeleton.joints) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"root", "a", "a_2", "a_2_end"}));
  EXPECT_GT(document.camera.pixels_per_unit, 0);
}

}  // namespace
}  // namespace artisketch

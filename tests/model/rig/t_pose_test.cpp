#include "model/rig/t_pose.h"

#include <gtest/gtest.h>

#include "files/sample_models.h"

namespace artisketch {
namespace {

TEST(TPose, ArmsAreLevelLegsUprightFeetWhereTheyWere) {
  const Model before = person_with_tail_model(), after = t_posed(before);
  const std::vector<Vec3> rest = rest_positions(after.skeleton),
                          was = rest_positions(before.skeleton);
  const BodyPlan plan = body_plan_of(after.skeleton, rest, false);
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec3 out = (side == 0 ? 1 : -1) * Vec3::UnitX();
    const LimbJoints &arm = plan.arms[side], &leg = plan.legs[side];
    EXPECT_LT((was[arm.lower] - was[arm.upper]).normalized().dot(out), 0.8);  // they hung
    for (const auto& [from, to] : {std::pair(arm.upper, arm.lower), {arm.lower, arm.end}})
      EXPECT_GT((rest[to] - rest[from]).normalized().dot(out), 0.999999);
    for (const auto& [from, to] : {std::pair(leg.upper, leg.lower), {leg.lower, leg.end}})
      EXPECT_GT((rest[from] - rest[to]).normalized().y(), 0.999999);
    EXPECT_NEAR(rest[leg.end].y(), was[leg.end].y(), 1e-9);
    EXPECT_LT((rest[leg.tip] - rest[leg.end] - was[leg.tip] + was[leg.end]).norm(), 1e-9);
  }
}

TEST(TPose, EveryClipIsSeenAsItWas) {
  const Model before = person_with_tail_model(), after = t_posed(before);
  ASSERT_EQ(after.clips.size(), before.clips.size());
  for (std::size_t c = 0; c < before.clips.size(); ++c)
    for (std::size_t k = 0; k < before.clips[c].poses.size(); ++k) {
      const Points3 a = posed_vertices(before.mesh.V, before.weights, before.skeleton,
                                       before.clips[c].poses[k]),
                    b = posed_vertices(after.mesh.V, after.weights, after.skeleton,
                                       after.clips[c].poses[k]);
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9) << before.clips[c].name << ", pose " << k;
    }
}

TEST(TPose, WhatHasNoLimbsStaysAsItWas) {
  const Model before = two_joint_model(), after = t_posed(before);
  EXPECT_LT((after.mesh.V - before.mesh.V).cwiseAbs().maxCoeff(), 1e-12);
  for (std::size_t k = 0; k < before.clips[0].poses.size(); ++k)
    for (int j = 0; j < 2; ++j)
      EXPECT_LT(after.clips[0].poses[k].rotations[j].angularDistance(
                    before.clips[0].poses[k].rotations[j]),
                1e-7);
}

}  // namespace
}  // namespace artisketch

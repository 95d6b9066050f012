#include "model/rig/library.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "document/templates.h"
#include "model/rig/body_plan.h"

namespace artisketch {
namespace {

std::vector<Vec3> places(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Vec3> at;
  for (const Transform& joint : posed_joints(skeleton, pose)) at.push_back(joint.translation());
  return at;
}

std::vector<std::string> names(const Skeleton& skeleton) {
  std::vector<std::string> all;
  for (const LibraryClip& clip : library_clips(skeleton)) all.push_back(clip.name);
  return all;
}

TEST(Library, EverySkeletonHasWhatFitsIt) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(template_skeleton(Template::human)),
            (Names{"idle", "walk", "run", "jump", "wave", "sit"}));
  EXPECT_EQ(names(template_skeleton(Template::quadruped)), (Names{"idle", "walk", "trot"}));
  EXPECT_EQ(names(template_skeleton(Template::spider)), (Names{"idle", "walk", "trot"}));
  EXPECT_EQ(names(template_skeleton(Template::bird)), (Names{"idle", "walk", "run", "jump"}));
  EXPECT_EQ(names(template_skeleton(Template::fish)), Names{"idle"});
  const Result<Clip> none = library_clip(template_skeleton(Template::fish), "walk", {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("there are idle"), std::string::npos);
}

TEST(Library, EveryClipGoesRoundWithItsFeetOnTheGround) {
  for (const TemplateWords& kind : all_templates()) {
    const Skeleton skeleton = template_skeleton(kind.kind);
    const std::vector<Vec3> rest = rest_positions(skeleton);
    const BodyPlan plan = body_plan_of(skeleton, rest, false);
    for (const std::string& name : names(skeleton)) {
      const Result<Clip> clip = library_clip(skeleton, name, {});
      ASSERT_TRUE(clip) << name;
      EXPECT_TRUE(same_pose(clip->poses.front(), clip->poses.back())) << kind.name << " " << name;
      for (std::size_t k = 1; k < clip->times.size(); ++k) {
        EXPECT_GT(clip->times[k], clip->times[k - 1]);
        double turn = 0;
        for (int j = 0; j < skeleton.size(); ++j)
          turn = std::max(
              turn, clip->poses[k].rotations[j].angularDistance(clip->poses[k - 1].rotations[j]));
        EXPECT_LT(degrees(turn), 45) << kind.name << " " << name << ", pose " << k;  // no jolts
      }
      if (plan.legs[0].end < 0) continue;
      const double low = rest[plan.legs[0].end].y(), tall = rest[plan.legs[0].upper].y();
      for (const Pose& pose : clip->poses) {
        const std::vector<Vec3> at = places(skeleton, pose);
        double lowest = 1e9;
        for (const LimbJoints& leg : plan.legs) {
          lowest = std::min(lowest, at[leg.end].y());
          if (leg.tip >= 0) {
            EXPECT_GT(at[leg.tip].y(), rest[leg.tip].y() - 0.02 * tall) << kind.name << " " << name;
          }
        }
        EXPECT_GT(lowest, low - 0.01 * tall) << kind.name << " " << name;
        if (name == "idle" || name == "sit" || name == "wave") {
          EXPECT_LT(lowest, low + 0.01 * tall) << kind.name << " " << name;
        }
      }
    }
  }
}

TEST(Library, AWalkersFootKeepsTheGroundsPaceWhileItStands) {
  for (const Template kind : {Template::human, Template::quadruped}) {
    const Skeleton skeleton = template_skeleton(kind);
    const BodyPlan plan = body_plan_of(skeleton, rest_positions(skeleton), false);
    const Result<Clip> clip = library_clip(skeleton, "walk", {});
    ASSERT_TRUE(clip);
    // The toes', or the ankle's, way back from key to key is one and the same.
    const int foot = plan.legs[0].tip;
    std::vector<double> ways;
    for (std::size_t k = 1; k < clip->poses.size(); ++k) {
      const Vec3 a = places(skeleton, clip->poses[k - 1])[foot],
                 b = places(skeleton, clip->poses[k])[foot];
      const double ground = rest_positions(skeleton)[foot].y();
      if (std::max(a.y(), b.y()) < ground + 0.002) ways.push_back(a.z() - b.z());
    }
    ASSERT_GT(ways.size(), 6u);
    const auto [least, most] = std::minmax_element(ways.begin(), ways.end());
    EXPECT_GT(*least, 0);
    EXPECT_LT(*most - *least, 0.01 * rest_positions(skeleton)[0].y());
  }
}

// Degrees from straight.
double knee_bend(const LimbJoints& leg, const std::vector<Vec3>& at) {
  const Vec3 thigh = at[leg.lower] - at[leg.upper], shin = at[leg.end] - at[leg.lower];
  return degrees(std::acos(std::clamp(thigh.normalized().dot(shin.normalized()), -1.0, 1.0)));
}

TEST(Library, AWalkerRisesOverANearlyStraightLegAndBendsTheOther) {
  // Also where feet are as long as half a leg.
  for (const double feet : {1.0, 2.0}) {
    Skeleton skeleton = template_skeleton(Template::human);
    const BodyPlan plan = body_plan_of(skeleton, rest_positions(skeleton), false);
    for (const LimbJoints& leg : plan.legs) skeleton.joints[leg.tip].offset.z() *= feet;
    const std::vector<Vec3> rest = rest_positions(skeleton);
    const double tall = rest[plan.hips].y() - rest[plan.legs[0].end].y();
    const Result<Clip> clip = library_clip(skeleton, "walk", {});
    ASSERT_TRUE(clip);
    double straightest = 180, swung = 0, strike = 0, lowest = 1e9, highest = 0;
    for (std::size_t k = 0; k < clip->poses.size(); ++k) {
      const std::vector<Vec3> at = places(skeleton, clip->poses[k]);
      const double bend = knee_bend(plan.legs[0], at);
      if (k == 0) strike = bend;  // the left heel meets the ground
      if (clip->times[k] < 0.4 * clip->times.back())
        straightest = std::min(straightest, bend);
      else
        swung = std::max(swung, bend);
      lowest = std::min(lowest, at[plan.hips].y());
      highest = std::max(highest, at[plan.hips].y());
    }
    EXPECT_LT(straightest, 20);
    EXPECT_LT(strike, 30);
    EXPECT_GT(swung, 50);
    EXPECT_LT(swung, 95);
    EXPECT_GT(lowest, rest[plan.hips].y() - 0.08 * tall);
    EXPECT_LT(highest, rest[plan.hips].y() + 0.04 * tall);
    EXPECT_GT(highest - lowest, 0.015 * tall);
  }
}

TEST(Library, HandsStayClearOfTheTrunk) {
  const Skeleton skeleton = template_skeleton(Template::human);
  const double hips = rest_positions(skeleton)[skeleton.find("thigh.L")].x();
  for (const char* name : {"idle", "walk", "run", "jump", "wave", "sit"}) {
    const Result<Clip> clip = library_clip(skeleton, name, {});
    ASSERT_TRUE(clip);
    for (const Pose& pose : clip->poses) {
      const std::vector<Vec3> at = places(skeleton, pose);
      const double beside = at[skeleton.find("hand.L")].x() - at[skeleton.find("hips")].x();
      EXPECT_GT(beside, 1.5 * hips) << name;
    }
  }
}

TEST(Library, StyleIsSeen) {
  const Skeleton skeleton = template_skeleton(Template::human);
  const int foot = skeleton.find("foot.L");
  const auto swing = [&](const ClipStyle& style) {
    const Result<Clip> clip = library_clip(skeleton, "walk", style);
    Box3 box, root;
    for (const Pose& pose : clip->poses) {
      box.extend(places(skeleton, pose)[foot]);
      root.extend(pose.root_position);
    }
    return std::array{box.sizes().z(), root.sizes().y(), root.sizes().x(), clip->times.back()};
  };
  ClipStyle style;
  const auto usual = swing(style);
  style.stride = 0.5;
  EXPECT_LT(swing(style)[0], 0.7 * usual[0]);
  style = {};
  style.bounce = 2;
  EXPECT_GT(swing(style)[1], 1.5 * usual[1]);
  style = {};
  style.weight = 2;
  EXPECT_GT(swing(style)[2], 1.5 * usual[2]);
  style = {};
  style.speed = 2;
  EXPECT_NEAR(swing(style)[3], usual[3] / 2, 1e-9);
}

TEST(Library, FewerKeysSayTheSame) {
  const Skeleton skeleton = template_skeleton(Template::human);
  const Result<Clip> clip = library_clip(skeleton, "wave", {});
  ASSERT_TRUE(clip);
  const Animation animation = animation_of(*clip);
  EXPECT_EQ(animation.name, "wave");
  EXPECT_LT(animation.keys.size(), clip->poses.size());
  EXPECT_TRUE(same_pose(animation.keys.front().pose, animation.keys.back().pose));
  // A clip that stands still says so with two keys.
  Clip still{"still", {}, {}};
  for (int k = 0; k < 50; ++k) {
    still.times.push_back(0.1 * k);
    still.poses.push_back(rest_pose(skeleton));
  }
  EXPECT_EQ(animation_of(still).keys.size(), 2u);
  std::size_t next = 0;
  for (std::size_t k = 0; k < clip->poses.size(); ++k) {
    while (animation.keys[next + 1].time < clip->times[k] - 1e-9) ++next;
    const Key &a = animation.keys[next], &b = animation.keys[next + 1];
    const double t = (clip->times[k] - a.time) / (b.time - a.time);
    for (int j = 0; j < skeleton.size(); ++j)
      EXPECT_LT(degrees(a.pose.rotations[j]
                            .slerp(t, b.pose.rotations[j])
                            .angularDistance(clip->poses[k].rotations[j])),
                0.26);
  }
}

TEST(Library, AWishIsANameAndAStyle) {
  const Result<ClipWish> wish = clip_wish("walk:stride=1.5,weight=2");
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->name, "walk");
  EXPECT_EQ(wish->style.stride, 1.5);
  EXPECT_EQ(wish->style.weight, 2);
  EXPECT_EQ(wish->style.speed, 1);
  EXPECT_TRUE(clip_wish("run"));
  for (const char* wrong :
       {"walk:", "walk:pace=1", "walk:stride", "walk:stride=x", "walk:stride=9", "walk:stride=nan"})
    EXPECT_FALSE(clip_wish(wrong)) << wrong;
}

}  // namespace
}  // namespace artisketch

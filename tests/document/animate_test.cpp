#include "document/animate.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

Document figure() {
  Document document;
  document.skeleton.joints = {{"hips", -1, {0, 1, 0}, -1, ""}, {"head", 0, {0, 0.5, 0}, -1, ""}};
  Frame frame;
  frame.width = frame.height = 100;
  frame.pose = rest_pose(document.skeleton);
  frame.contours.push_back({0, {{{10, 10}, {40, 10}, {40, 60}}, true}, ""});
  document.frames.push_back(frame);
  return document;
}

Pose turned(const Document& document, double angle) {
  Pose pose = rest_pose(document.skeleton);
  pose.rotations[1] = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  return pose;
}

TEST(Animate, AClipsNameIsItsOwn) {
  Document document;
  Animation walk;
  walk.name = "walk";
  walk.keys.push_back({0, {}, ""});
  for (int i = 0; i < 3; ++i) document = with_animation(std::move(document), walk);
  ASSERT_EQ(document.animations.size(), 3u);
  EXPECT_EQ(document.animations[0].name, "walk");
  EXPECT_EQ(document.animations[1].name, "walk 2");
  EXPECT_EQ(document.animations[2].name, "walk 3");
}

TEST(Animate, KeysStandInTheOrderOfTheirTimes) {
  const Document document = figure();
  Document clip = with_clip(document, turned(document, 0));
  ASSERT_EQ(clip.animations.size(), 1u);
  EXPECT_EQ(clip.animations[0].name, "clip 1");
  clip = with_key(clip, 0, 2, turned(document, 0.2));
  clip = with_key(clip, 0, 1, turned(document, 0.1));
  const std::vector<Key>& keys = clip.animations[0].keys;
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_EQ(keys[1].time, 1);
  EXPECT_EQ(keys[2].time, 2);
  EXPECT_NEAR(keys[1].pose.rotations[1].angularDistance(Quat::Identity()), 0.1, 1e-9);
}

TEST(Animate, AKeyWhereOneIsTakesItsPlace) {
  const Document document = figure();
  Document clip = with_key(with_clip(document, turned(document, 0)), 0, 0.01, turned(document, 1));
  ASSERT_EQ(clip.animations[0].keys.size(), 1u);
  EXPECT_EQ(clip.animations[0].keys[0].time, 0);
  EXPECT_NEAR(clip.animations[0].keys[0].pose.rotations[1].angularDistance(Quat::Identity()), 1,
              1e-9);
}

TEST(Animate, AMovedKeyStaysBetweenItsNeighbours) {
  const Document document = figure();
  Document clip = with_clip(document, turned(document, 0));
  clip = with_key(with_key(clip, 0, 1, turned(document, 1)), 0, 2, turned(document, 2));
  EXPECT_EQ(with_key_moved(clip, 0, 1, 1.4).animations[0].keys[1].time, 1.4);
  EXPECT_EQ(with_key_moved(clip, 0, 1, 9).animations[0].keys[1].time, 2 - kLeastStep);
  EXPECT_EQ(with_key_moved(clip, 0, 1, -3).animations[0].keys[1].time, kLeastStep);
  EXPECT_EQ(with_key_moved(clip, 0, 2, 9).animations[0].keys[2].time, 9);
  EXPECT_EQ(with_key_moved(clip, 0, 0, -1).animations[0].keys[0].time, 0);
}

TEST(Animate, ARemovedClipLeavesTheOthers) {
  Document document = figure();
  document = with_clip(with_clip(document, turned(document, 0)), turned(document, 1));
  const std::string second = document.animations[1].name;
  const Document left = without_clip(document, 0);
  ASSERT_EQ(left.animations.size(), 1u);
  EXPECT_EQ(left.animations[0].name, second);
}

TEST(Animate, TheLastKeyGoesWithItsClip) {
  const Document document = figure();
  Document clips = with_clip(with_clip(document, turned(document, 0)), turned(document, 1));
  EXPECT_EQ(clips.animations[1].name, "clip 2");
  clips = without_key(clips, 0, 0);
  ASSERT_EQ(clips.animations.size(), 1u);
  EXPECT_EQ(with_clip(clips, turned(document, 0)).animations[1].name, "clip 1");
}

TEST(Animate, FatnessStaysWithinWhatASurfaceBears) {
  EXPECT_EQ(fatness_of(figure(), 1), 1);
  EXPECT_EQ(fatness_of(with_fatness(figure(), 1, 1.5), 1), 1.5);
  EXPECT_EQ(fatness_of(with_fatness(figure(), 1, 99), 1), kFattest);
  EXPECT_EQ(fatness_of(with_fatness(figure(), 1, -1), 1), kThinnest);
}

TEST(Animate, ClipsAndNamesMakeNoOtherModelAllElseDoes) {
  const Document document = figure();
  Document other = with_clip(document, turned(document, 1));
  other.name = other.frames[0].name = "other";
  EXPECT_TRUE(same_model(document, other));
  EXPECT_TRUE(same_model(document, with_fatness(document, 0, 1)));
  EXPECT_FALSE(same_model(document, with_fatness(document, 0, 1.1)));
  EXPECT_FALSE(same_model(document, with_sphere(document, 1, 0.2, Vec3::Zero())));
  Document posed = document;
  posed.frames[0].pose = turned(document, 0.1);
  EXPECT_FALSE(same_model(document, posed));
  Document moved = document;
  moved.frames[0].contours[0].line.points[1].x() += 1;
  EXPECT_FALSE(same_model(document, moved));
  moved = document;
  moved.frames.clear();
  EXPECT_FALSE(same_model(document, moved));
}

}  // namespace
}  // namespace artisketch

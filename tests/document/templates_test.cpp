#include "document/templates.h"

#include <set>

#include <gtest/gtest.h>

#include "document/edit.h"

namespace artisketch {
namespace {

TEST(Templates, AreSkeletonsByFormatsRules) {
  for (const TemplateWords& words : all_templates()) {
    const Skeleton skeleton = template_skeleton(words.kind);
    ASSERT_GT(skeleton.size(), 0) << words.name;
    std::set<std::string> names;
    const std::vector<Vec3> rest = rest_positions(skeleton);
    for (int j = 0; j < skeleton.size(); ++j) {
      const Joint& joint = skeleton.joints[j];
      EXPECT_TRUE(names.insert(joint.name).second) << joint.name;
      EXPECT_EQ(joint.parent < 0, j == 0) << joint.name;
      EXPECT_LT(joint.parent, j) << joint.name;
      if (j > 0) {
        EXPECT_GT(joint.offset.norm(), 0.03) << joint.name;
      }
      if (joint.mirror < 0) continue;
      EXPECT_EQ(skeleton.joints[joint.mirror].mirror, j) << joint.name;
      const Vec3 across(2 * rest[0].x() - rest[j].x(), rest[j].y(), rest[j].z());
      EXPECT_LT((rest[joint.mirror] - across).norm(), 1e-12) << joint.name;
      const JointWords own = joint_words(joint.name),
                       other = joint_words(skeleton.joints[joint.mirror].name);
      EXPECT_EQ(own.name, other.name);
      EXPECT_EQ(own.side == other.side, joint.mirror == j) << joint.name;
      // The person's left is at the viewer's right.
      if (own.side == "L") {
        EXPECT_GT(rest[j].x(), rest[0].x()) << joint.name;
      }
    }
  }
  EXPECT_EQ(template_skeleton(Template::spider).size(), 5 + 8 * 3);
}

Document with_frames(int frames, Camera::Type type) {
  Document document;
  document.camera.type = type;
  document.skeleton = template_skeleton(Template::blank);
  for (int f = 0; f < frames; ++f) {
    Frame frame;
    frame.width = 400;
    frame.height = 300;
    frame.pose = rest_pose(document.skeleton);
    document.frames.push_back(frame);
  }
  return document;
}

Box2 shown(const Document& document, int frame) {
  Box2 box;
  const FrameCamera camera = frame_camera(document, frame);
  for (const Transform& joint : posed_joints(document.skeleton, document.frames[frame].pose))
    box.extend(camera.project(joint.translation()));
  return box;
}

TEST(Templates, AreFittedToTheFigure) {
  const Box2 figure(Vec2(120, 40), Vec2(200, 270));
  for (Camera::Type type : {Camera::Type::orthographic, Camera::Type::perspective}) {
    const Document document = with_template(with_frames(2, type), Template::human, 0, figure);
    const Box2 box = shown(document, 0);
    EXPECT_NEAR(box.min().y(), 40, 4);
    EXPECT_NEAR(box.max().y(), 270, 4);
    EXPECT_NEAR(box.center().x(), 160, 1);
    EXPECT_NEAR(shown(document, 1).center().x(), 200, 1);
  }
}

TEST(Templates, ALongBodyStandsSidewaysWhereTheFigureIsWide) {
  const Document side = with_template(with_frames(1, Camera::Type::orthographic),
                                      Template::quadruped, 0, Box2(Vec2(20, 80), Vec2(380, 260)));
  const std::vector<Transform> posed = posed_joints(side.skeleton, side.frames[0].pose);
  const int head = side.skeleton.find("head_tip"), tail = side.skeleton.find("tail_tip");
  EXPECT_LT(posed[head].translation().x(), posed[tail].translation().x());
  const Document front = with_template(with_frames(1, Camera::Type::orthographic),
                                       Template::quadruped, 0, Box2(Vec2(160, 20), Vec2(240, 280)));
  EXPECT_NEAR(front.frames[0].pose.rotations[0].angularDistance(Quat::Identity()), 0, 1e-9);
}

TEST(Templates, ContoursKeepTheirNamesOrGoToTheNearestBone) {
  Document document = with_template(with_frames(1, Camera::Type::orthographic), Template::human, 0,
                                    Box2(Vec2(120, 40), Vec2(200, 270)));
  const auto around = [&](int joint) {
    const Vec2 at =
        frame_camera(document, 0)
            .project(posed_joints(document.skeleton, document.frames[0].pose)[joint].translation());
    return Polyline{{at + Vec2(-5, -5), at + Vec2(5, -5), at + Vec2(5, 5), at + Vec2(-5, 5)}, true};
  };
  const int head = document.skeleton.find("head"), hand = document.skeleton.find("hand.L");
  document = with_contour(document, 0, {head, around(head), ""});
  document = with_contour(document, 0, {hand, around(hand), ""});
  const Document bird = with_template(document, Template::bird, 0, std::nullopt);
  ASSERT_EQ(bird.frames[0].contours.size(), 2u);
  EXPECT_EQ(bird.skeleton.joints[bird.frames[0].contours[0].joint].name, "head");
  EXPECT_EQ(joint_words(bird.skeleton.joints[bird.frames[0].contours[1].joint].name).side, "L");
  const Document blank = with_template(document, Template::blank, 0, std::nullopt);
  for (const Contour& contour : blank.frames[0].contours) EXPECT_EQ(contour.joint, 0);
}

}  // namespace
}  // namespace artisketch

#include "document/drawing_edit.h"

#include <random>

#include <gtest/gtest.h>

#include "document/edit.h"
#include "document/templates.h"

namespace artisketch {
namespace {

// A person, whose halves are alike, in a pose that isn't.
Document posed_person(Camera::Type camera) {
  Document document;
  Frame frame;
  frame.width = 300;
  frame.height = 500;
  document = with_frame(std::move(document), std::move(frame));
  document = with_template(std::move(document), Template::human, 0, std::nullopt);
  document = with_camera_type(std::move(document), camera);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-0.6, 0.6);
  Frame& first = document.frames[0];
  for (Quat& q : first.pose.rotations)
    q = Quat(1, some(random), some(random), some(random)).normalized();
  first.pose.root_position += Vec3(0.3, -0.2, 0.4);
  const int arm = document.skeleton.find("upper_arm.L");
  first.contours.push_back({arm, {{{100, 200}, {140, 210}, {120, 260}}, true}, ""});
  first.set_joints = {arm};
  return document;
}

std::vector<Vec2> drawn_joints_of(const Document& document) {
  std::vector<Vec2> pixels;
  for (const Transform& joint : posed_joints(document.skeleton, document.frames[0].pose))
    pixels.push_back(frame_camera(document, 0).project(joint.translation()));
  return pixels;
}

template <class Map>
void expect_all_moved(const Document& before, const Document& after, const Map& map) {
  const std::vector<Vec2> was = drawn_joints_of(before), is = drawn_joints_of(after);
  for (std::size_t j = 0; j < was.size(); ++j)
    EXPECT_LT((is[j] - map(was[j])).norm(), 1e-6) << before.skeleton.joints[j].name;
  const auto &a = before.frames[0].contours[0].line.points,
             &b = after.frames[0].contours[0].line.points;
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((b[i] - map(a[i])).norm(), 1e-9);
}

TEST(DrawingEdit, TheSkeletonAndTheOutlinesGoWithThePicture) {
  for (const auto type : {Camera::Type::orthographic, Camera::Type::perspective}) {
    const Document document = posed_person(type);
    expect_all_moved(document, with_drawing_turned(document, 0, 1),
                     [](const Vec2& p) { return Vec2(500 - p.y(), p.x()); });
    expect_all_moved(document, with_drawing_turned(document, 0, -1),
                     [](const Vec2& p) { return Vec2(p.y(), 300 - p.x()); });
    expect_all_moved(document, with_drawing_turned(document, 0, 4),
                     [](const Vec2& p) { return p; });
    const Document cropped = with_drawing_cropped(document, 0, {20, 50, 201, 333});
    expect_all_moved(document, cropped, [](const Vec2& p) { return Vec2(p - Vec2(20, 50)); });
    // Again, with a principal point off the middle.
    expect_all_moved(cropped, with_drawing_turned(cropped, 0, 1),
                     [](const Vec2& p) { return Vec2(333 - p.y(), p.x()); });
  }
  const Document flat = posed_person(Camera::Type::orthographic);
  expect_all_moved(flat, with_drawing_resized(flat, 0, 750, 1250),
                   [](const Vec2& p) { return Vec2(2.5 * p); });
}

TEST(DrawingEdit, TheMirrorImageShowsTheOtherSidesParts) {
  for (const auto type : {Camera::Type::orthographic, Camera::Type::perspective}) {
    const Document document = posed_person(type), flipped = with_drawing_flipped(document, 0);
    const std::vector<Vec2> was = drawn_joints_of(document), is = drawn_joints_of(flipped);
    for (std::size_t j = 0; j < was.size(); ++j) {
      const int other = document.skeleton.joints[j].mirror;
      ASSERT_GE(other, 0);
      EXPECT_LT((is[std::size_t(other)] - Vec2(300 - was[j].x(), was[j].y())).norm(), 1e-6)
          << document.skeleton.joints[j].name;
    }
    const int right = document.skeleton.find("upper_arm.R");
    EXPECT_EQ(flipped.frames[0].contours[0].joint, right);
    EXPECT_EQ(flipped.frames[0].set_joints, std::vector{right});
    const Document again = with_drawing_flipped(flipped, 0);
    EXPECT_EQ(again.frames[0].contours[0].line.points[0],
              document.frames[0].contours[0].line.points[0]);
    EXPECT_TRUE(same_pose(again.frames[0].pose, document.frames[0].pose));
  }
}

TEST(DrawingEdit, PicturesTurnTheWayTheirOutlinesDo) {
  Image picture(3, 2);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] = std::uint8_t(i);
  const Image right = turned(picture, 1);
  ASSERT_EQ(right.width, 2);
  ASSERT_EQ(right.height, 3);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) EXPECT_EQ(right.at(1 - y, x)[0], picture.at(x, y)[0]);
  EXPECT_EQ(turned(right, -1).rgba, picture.rgba);
  EXPECT_EQ(turned(turned(picture, 2), 2).rgba, picture.rgba);
  EXPECT_EQ(turned(picture, 3).rgba, turned(picture, -1).rgba);
  EXPECT_EQ(flipped(flipped(picture)).rgba, picture.rgba);
  EXPECT_EQ(flipped(picture).at(0, 1)[0], picture.at(2, 1)[0]);
  const Image part = cropped(picture, {1, 1, 2, 1});
  ASSERT_EQ(part.width, 2);
  EXPECT_EQ(part.at(0, 0)[0], picture.at(1, 1)[0]);
}

}  // namespace
}  // namespace artisketch

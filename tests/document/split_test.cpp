// A limb drawn as one part and bent from drawing to drawing, taken apart where it bends.
#include "document/split.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "document/camera.h"
#include "document/edit.h"

namespace artisketch {
namespace {

constexpr double kWide = 14, kScale = 100;  // pixels: half a limb's width; a unit's

// The outline of a limb along a line, with round ends.
Polyline limb_along(const std::vector<Vec2>& line) {
  Polyline outline;
  const auto arc = [&](const Vec2& centre, double from, double to) {
    for (int i = 0; i <= 8; ++i) {
      const double a = from + (to - from) * i / 8;
      outline.points.push_back(centre + kWide * Vec2(std::cos(a), std::sin(a)));
    }
  };
  const auto angle = [&](std::size_t i) {
    const Vec2 d = line[i + 1] - line[i];
    return std::atan2(d.y(), d.x());
  };
  const std::size_t last = line.size() - 1;
  const auto side = [&](double turn, bool forth) {
    for (std::size_t k = 1; k < last; ++k) {
      const std::size_t i = forth ? k : last - k;
      const double before = angle(i - 1), after = angle(i);
      const double middle = (before + after) / 2, reach = kWide / std::cos((after - before) / 2);
      outline.points.push_back(line[i] +
                               reach * Vec2(std::cos(middle + turn), std::sin(middle + turn)));
    }
  };
  arc(line.front(), angle(0) + kPi / 2, angle(0) + 3 * kPi / 2);
  side(-kPi / 2, true);
  arc(line.back(), angle(last - 1) - kPi / 2, angle(last - 1) + kPi / 2);
  side(kPi / 2, false);
  return outline;
}

// A chest with an arm of one bone of 1.2 units on each side, drawn twice: first both arms straight
// out, then bent at `share` of their length, by `bend` upwards. As a person has it who has no joint
// there, the arm's bone goes straight from the shoulder to the hand.
struct Drawn {
  Document document;
  int arm = 1, hand = 2;
  Vec2 elbow = Vec2::Zero(), end = Vec2::Zero();  // pixels, in the second drawing
};
Drawn arms(double share, double bend, bool with_hand = true) {
  Drawn made;
  Document& d = made.document;
  d.camera.pixels_per_unit = kScale;
  d.skeleton.joints = {{"chest", -1, Vec3::Zero(), 0, ""},
                       {"arm.L", 0, {0.3, 0, 0}, 2, ""},
                       {"arm.R", 0, {-0.3, 0, 0}, 1, ""}};
  if (with_hand) {
    d.skeleton.joints = {{"chest", -1, Vec3::Zero(), 0, ""},
                         {"arm.L", 0, {0.3, 0, 0}, 3, ""},
                         {"hand.L", 1, {1.2, 0, 0}, 4, ""},
                         {"arm.R", 0, {-0.3, 0, 0}, 1, ""},
                         {"hand.R", 3, {-1.2, 0, 0}, 2, ""}};
  }
  for (int f = 0; f < 2; ++f) {
    Frame frame;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(d.skeleton);
    d.frames.push_back(frame);
    const FrameCamera camera = frame_camera(d, f);
    for (const double sign : {1.0, -1.0}) {
      const double turn = f == 0 ? 0 : bend, length = 1.2;
      const Vec3 shoulder(0.3 * sign, 0, 0), elbow = shoulder + Vec3(share * length * sign, 0, 0);
      const Vec3 end =
          elbow + (1 - share) * length * Vec3(sign * std::cos(turn), std::sin(turn), 0);
      const int arm = d.skeleton.find(sign > 0 ? "arm.L" : "arm.R");
      Contour contour{
          arm, limb_along({camera.project(shoulder), camera.project(elbow), camera.project(end)}),
          ""};
      d.frames[std::size_t(f)].contours.push_back(contour);
      if (f == 0) continue;
      const Vec3 way = end - shoulder;
      // Shorter than the bone: the rest of it stands in depth.
      const double depth = std::sqrt(std::max(0.0, length * length - way.squaredNorm()));
      Pose& pose = d.frames[1].pose;
      pose.rotations[std::size_t(arm)] =
          Quat::FromTwoVectors(Vec3(sign, 0, 0), Vec3(way.x(), way.y(), depth));
      if (sign > 0) made.elbow = camera.project(elbow), made.end = camera.project(end);
    }
  }
  return made;
}

Vec2 seen(const Document& d, int frame, const char* joint) {
  const int j = d.skeleton.find(joint);
  return frame_camera(d, frame).project(
      posed_joints(d.skeleton, d.frames[std::size_t(frame)].pose)[std::size_t(j)].translation());
}

TEST(Split, TheFoldIsWhereTheLimbBends) {
  for (const double share : {0.4, 0.5, 0.62}) {
    const Drawn drawn = arms(share, radians(80));
    const std::optional<Fold> fold = fold_of(drawn.document, drawn.arm);
    ASSERT_TRUE(fold);
    EXPECT_NEAR(fold->along, share, 0.06);
    EXPECT_NEAR(fold->angle, radians(80), radians(14));
  }
  const std::optional<Fold> straight = fold_of(arms(0.4, 0).document, 1);
  ASSERT_TRUE(straight);
  EXPECT_LT(straight->angle, kFold);
  EXPECT_EQ(straight->along, 0.5) << "a straight one tells of no place";
}

TEST(Split, ABoneGetsAJointAndEachOutlineBecomesTwoThatOverlap) {
  const Drawn drawn = arms(0.4, radians(80));
  const std::optional<Document> next = with_part_split(drawn.document, drawn.arm);
  ASSERT_TRUE(next);
  const Skeleton& skeleton = next->skeleton;
  ASSERT_EQ(skeleton.size(), drawn.document.skeleton.size() + 2) << "the mirror image's too";
  const int arm = skeleton.find("arm.L"), lower = skeleton.find("arm 2.L");
  ASSERT_GE(lower, 0);
  EXPECT_EQ(skeleton.joints[std::size_t(lower)].parent, arm);
  EXPECT_EQ(skeleton.joints[std::size_t(skeleton.find("hand.L"))].parent, lower);
  EXPECT_EQ(skeleton.joints[std::size_t(lower)].mirror, skeleton.find("arm 2.R"));
  EXPECT_NEAR(skeleton.joints[std::size_t(lower)].offset.x(), 0.4 * 1.2, 0.07 * 1.2);
  EXPECT_TRUE(
      rest_positions(skeleton)[std::size_t(skeleton.find("hand.L"))].isApprox(Vec3(1.5, 0, 0)));
  for (int j = 0; j < skeleton.size(); ++j) EXPECT_LT(skeleton.joints[std::size_t(j)].parent, j);
  for (int f = 0; f < 2; ++f) {
    const Frame& before = drawn.document.frames[std::size_t(f)];
    const Frame& frame = next->frames[std::size_t(f)];
    ASSERT_EQ(frame.contours.size(), 4u);
    const Polyline whole = contours_of(before, drawn.arm)[0];
    const Polyline near = contours_of(frame, arm)[0], far = contours_of(frame, lower)[0];
    int both = 0;
    for (double y = 0; y < 400; y += 3)
      for (double x = 0; x < 400; x += 3) {
        const Vec2 p(x, y);
        EXPECT_EQ(contains(whole, p), contains(near, p) || contains(far, p)) << p.transpose();
        both += contains(near, p) && contains(far, p);
      }
    EXPECT_GT(both, 5) << "they overlap";
    EXPECT_TRUE(contains(near, seen(*next, f, "arm.L") + Vec2(3, 0)));
    EXPECT_TRUE(contains(far, seen(*next, f, "hand.L")));
  }
}

TEST(Split, WhereADrawingBendsItTheJointLiesAtTheBendAndTheHandStays) {
  const Drawn drawn = arms(0.4, radians(80));
  const std::optional<Document> next = with_part_split(drawn.document, drawn.arm);
  ASSERT_TRUE(next);
  EXPECT_LT((seen(*next, 1, "arm 2.L") - drawn.elbow).norm(), 8);
  EXPECT_LT((seen(*next, 1, "hand.L") - seen(drawn.document, 1, "hand.L")).norm(), 2);
  EXPECT_LT((seen(*next, 0, "hand.L") - seen(drawn.document, 0, "hand.L")).norm(), 1e-6);
  // What the hand was turned by stays.
  const auto turn = [](const Document& d) {
    const int hand = d.skeleton.find("hand.L");
    return Mat3(posed_joints(d.skeleton, d.frames[1].pose)[std::size_t(hand)].rotation());
  };
  EXPECT_TRUE(turn(*next).isApprox(turn(drawn.document), 1e-9));
  // Each half is one rigid thing now.
  for (const char* part : {"arm.L", "arm 2.L", "arm.R", "arm 2.R"}) {
    const std::optional<Fold> fold = fold_of(*next, next->skeleton.find(part));
    EXPECT_LT(fold ? fold->angle : 0, kFold) << part;
  }
}

TEST(Split, APartAtALimbsEndIsSplitToo) {
  const Drawn drawn = arms(0.5, radians(70), false);
  const std::optional<Document> next = with_part_split(drawn.document, drawn.arm);
  ASSERT_TRUE(next);
  const int lower = next->skeleton.find("arm 2.L");
  ASSERT_GE(lower, 0);
  EXPECT_NEAR(next->skeleton.joints[std::size_t(lower)].offset.norm(), 0.6, 0.12);
  EXPECT_LT((seen(*next, 1, "arm 2.L") - drawn.elbow).norm(), 10);
}

TEST(Split, AStraightPartIsSplitInTheMiddleOrWhereOneSays) {
  const Drawn drawn = arms(0.5, 0);
  const auto at = [&](std::optional<double> along) {
    const Document next = *with_part_split(drawn.document, drawn.arm, along);
    return next.skeleton.joints[std::size_t(next.skeleton.find("arm 2.L"))].offset.x() / 1.2;
  };
  EXPECT_NEAR(at(std::nullopt), 0.5, 1e-9);
  EXPECT_NEAR(at(0.3), 0.3, 1e-9);
  const std::optional<double> along =
      along_part(drawn.document, 0, drawn.arm, seen(drawn.document, 0, "arm.L") + Vec2(36, 5));
  ASSERT_TRUE(along);
  EXPECT_NEAR(*along, 0.3, 0.03);
}

TEST(Split, WhatHasNoBoneOrSeveralIsNot) {
  Drawn drawn = arms(0.5, radians(80));
  EXPECT_FALSE(can_split(drawn.document, 0)) << "two arms hang on the chest";
  EXPECT_FALSE(can_split(drawn.document, drawn.hand)) << "no outline";
  EXPECT_FALSE(can_split(drawn.document, -1));
  EXPECT_FALSE(with_part_split(drawn.document, 0));
  // A hole and the settings go along.
  drawn.document.parts[drawn.arm].fatness = 1.5;
  const FrameCamera camera = frame_camera(drawn.document, 0);
  Polyline hole;
  for (const Vec2& by : {Vec2(0, 0), Vec2(4, 0), Vec2(4, 4)})
    hole.points.push_back(camera.project(Vec3(1.3, 0, 0)) + by);
  drawn.document.frames[0].contours.push_back({drawn.arm, hole, ""});
  const Document next = *with_part_split(drawn.document, drawn.arm);
  const int lower = next.skeleton.find("arm 2.L");
  EXPECT_EQ(contours_of(next.frames[0], lower).size(), 2u);
  EXPECT_EQ(next.parts.at(lower).fatness, 1.5);
}

}  // namespace
}  // namespace artisketch

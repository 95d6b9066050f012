#include "document/edit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "document/history.h"
#include "document/outline_edit.h"
#include "document/posing.h"

namespace artisketch {
namespace {

// A body with two arms of two bones each, seen by an orthographic camera, 100 pixels per unit.
Document figure() {
  Document document;
  document.camera.pixels_per_unit = 100;
  const auto joint = [&](const char* name, int parent, Vec3 offset, int mirror) {
    document.skeleton.joints.push_back({name, parent, offset, mirror, ""});
  };
  joint("chest", -1, {0, 1, 0}, 0);
  joint("upper_arm.L", 0, {0.2, 0, 0}, 4);
  joint("forearm.L", 1, {0.5, 0, 0}, 5);
  joint("hand.L", 2, {0.5, 0, 0}, 6);
  joint("upper_arm.R", 0, {-0.2, 0, 0}, 1);
  joint("forearm.R", 4, {-0.5, 0, 0}, 2);
  joint("hand.R", 5, {-0.5, 0, 0}, 3);
  Frame frame;
  frame.name = "front";
  frame.width = frame.height = 400;
  frame.pose = rest_pose(document.skeleton);
  document.frames.push_back(frame);
  return document;
}

Polyline circle(Vec2 centre, double radius, int points = 64) {
  Polyline line;
  for (int i = 0; i < points; ++i) {
    const double a = 2 * kPi * i / points;
    line.points.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return line;
}

TEST(History, UndoAndRedoLeadBackToTheSameStateByItsName) {
  History history(figure());
  EXPECT_FALSE(history.can_undo());
  const long before = history.revision();
  history.commit("Draw Hand L", with_contour(history.now(), 0, {3, circle({200, 200}, 20), ""}));
  EXPECT_EQ(history.undo_name(), "Draw Hand L");
  const long after = history.revision();
  history.undo();
  EXPECT_EQ(history.revision(), before);
  EXPECT_TRUE(history.now().frames[0].contours.empty());
  EXPECT_EQ(history.redo_name(), "Draw Hand L");
  history.redo();
  EXPECT_EQ(history.revision(), after);
  EXPECT_EQ(history.now().frames[0].contours.size(), 1u);
}

TEST(Edit, PosesOfAnotherDocumentAreTakenWholeOrNotAtAll) {
  const Document mine = with_contour(figure(), 0, {3, circle({200, 200}, 20), ""});
  Document other = figure();
  other.frames[0].pose.root_position = {1, 2, 3};
  other.frames[0].scale = 1.5;
  const Document posed = with_poses_of(mine, other);
  EXPECT_EQ(posed.frames[0].pose.root_position, Vec3(1, 2, 3));
  EXPECT_EQ(posed.frames[0].scale, 1.5);
  EXPECT_EQ(posed.frames[0].contours.size(), 1u);
  other.frames.push_back(other.frames[0]);
  EXPECT_EQ(with_poses_of(mine, other).frames[0].scale, 1);
}

TEST(History, AnEditAfterUndoDropsWhatWasUndone) {
  History history(figure());
  history.commit("one", figure());
  const long one = history.revision();
  history.undo();
  history.commit("two", figure());
  EXPECT_FALSE(history.can_redo());
  EXPECT_NE(history.revision(), one);
}

TEST(History, NoTwoHistoriesShareAName) {
  // Results of a job are taken by it: one that was asked for by the document before is not this
  // one's.
  History one(figure()), other(figure());
  EXPECT_NE(one.revision(), other.revision());
  EXPECT_NE(one.state(), other.state());
}

TEST(History, AGestureIsOneStep) {
  History history(figure());
  history.commit("Move point", figure());
  for (int i = 0; i < 100; ++i) history.amend(figure());
  history.undo();
  EXPECT_FALSE(history.can_undo());
}

TEST(Words, JointsAreReadAsPeopleCallThem) {
  EXPECT_EQ(joint_words("upper_arm.L").name, "Upper arm");
  EXPECT_EQ(joint_words("upper_arm.L").side, "L");
  EXPECT_EQ(joint_words("head").whole(), "Head");
  EXPECT_EQ(joint_words("").whole(), "");
}

TEST(Strokes, AStrokeThatEndsNearItsStartCloses) {
  Polyline drawn = circle({100, 100}, 50);
  drawn.points.pop_back();
  const std::optional<Polyline> outline = outline_of_stroke(drawn.points, {});
  ASSERT_TRUE(outline);
  EXPECT_TRUE(outline->closed);
  EXPECT_LT(outline->points.size(), 40u);
  EXPECT_NEAR(std::abs(signed_area(*outline)), kPi * 50 * 50, 0.02 * kPi * 50 * 50);
}

TEST(Strokes, AHandThatGoesPastItsBeginningLeavesNoLoop) {
  Polyline drawn = circle({100, 100}, 50);
  drawn.points.pop_back();
  // On beyond the start, a little inside, then across the line and out.
  const Vec2 start = drawn.points.front();
  for (const Vec2& past : {Vec2(-3, 4), Vec2(1, 8), Vec2(4, 11)})
    drawn.points.push_back(start + past);
  StrokeOptions options;
  options.smooth = 0;
  const std::optional<Polyline> outline = outline_of_stroke(drawn.points, options);
  ASSERT_TRUE(outline && outline->closed);
  EXPECT_FALSE(self_crossing(*outline));
  EXPECT_NEAR(std::abs(signed_area(*outline)), kPi * 50 * 50, 0.03 * kPi * 50 * 50);
}

TEST(Strokes, AnEightIsAnOutlineThatCrossesItself) {
  // Some of these have loops that cancel out to less than a pixel.
  for (int offset = 0; offset < 100; ++offset) {
    std::vector<Vec2> drawn;
    for (int i = 0; i <= 60; ++i) {
      const double angle = i * kPi / 30;
      const Vec2 p(60 * std::sin(2 * angle) + 0.07 * offset, 90 * std::sin(angle) + 0.03 * offset);
      drawn.emplace_back(std::floor(0.6 * p.x()) / 0.6, std::floor(0.6 * p.y()) / 0.6);
    }
    StrokeOptions options;
    options.smooth = 2 / 0.6;
    options.error = 0.4 / 0.6;
    const std::optional<Polyline> outline = outline_of_stroke(drawn, options);
    ASSERT_TRUE(outline && outline->closed) << offset;
    EXPECT_TRUE(self_crossing(*outline)) << offset;
  }
}

TEST(Strokes, AStrokeThatEndsElsewhereStaysOpenAndKeepsItsEnds) {
  const std::vector<Vec2> drawn = {{0, 0}, {50, 3}, {100, 0}};
  const std::optional<Polyline> outline = outline_of_stroke(drawn, {});
  ASSERT_TRUE(outline);
  EXPECT_FALSE(outline->closed);
  EXPECT_EQ(outline->points.front(), drawn.front());
  EXPECT_LT((outline->points.back() - drawn.back()).norm(), 1e-9);
}

TEST(Strokes, ADotIsNoOutline) {
  const std::vector<Vec2> dot = {{5, 5}, {5, 5}, {5.2, 5}};
  EXPECT_FALSE(outline_of_stroke(dot, {}));
}

Document with_second_drawing() {
  Frame frame;
  frame.name = "side";
  frame.width = frame.height = 400;
  return with_frame(figure(), frame);
}

TEST(Frames, ADrawingThatIsAddedWaitsForItsPose) {
  const Document document = with_second_drawing();
  ASSERT_EQ(document.frames.size(), 2u);
  EXPECT_TRUE(is_posed(document, 0));
  EXPECT_FALSE(is_posed(document, 1));

  Pose moved = document.frames[1].pose;
  moved.root_position.x() += 1;
  EXPECT_FALSE(is_posed(with_pose(document, 1, moved), 1)) << "laid over the figure, no more";

  moved.rotations[2] = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  const Document posed = with_pose(document, 1, moved);
  EXPECT_TRUE(is_posed(posed, 1));
  EXPECT_EQ(posed.frames[1].set_joints, std::vector<int>{2});

  const Document guessed = with_guessed_pose(document, 1, moved);
  EXPECT_TRUE(is_posed(guessed, 1));
  EXPECT_TRUE(guessed.frames[1].set_joints.empty());

  EXPECT_TRUE(is_posed(with_frame_posed(document, 1), 1));
  EXPECT_TRUE(is_posed(with_pose_copied(document, 0, 1), 1));
  EXPECT_TRUE(with_rest_pose(posed, 1).frames[1].set_joints.empty());
  EXPECT_TRUE(is_posed(without_frame(document, 0), 0)) << "the first is what others are told from";
}

TEST(Frames, AFiguresSizeInADrawingGrowsAboutItsRoot) {
  Document document = figure();
  document.frames[0].pose.root_position = {0.3, 0.7, 0.2};
  const Vec2 before = frame_camera(document, 0).project(document.frames[0].pose.root_position);
  const Document larger = with_frame_scale(document, 0, 1.5);
  const FrameCamera camera = frame_camera(larger, 0);
  EXPECT_LT((camera.project(larger.frames[0].pose.root_position) - before).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(camera.pixels_per_unit(0), 150);
}

TEST(Frames, OutlinesOfADrawingWithoutAPoseSayNothing) {
  Document document = with_second_drawing();
  document = with_contour(document, 1, {0, circle({200, 200}, 50), ""});
  EXPECT_EQ(with_shaping_contours(document).frames[1].contours.size(), 1u) << "there are no others";
  document = with_contour(document, 0, {0, circle({200, 200}, 50), ""});
  EXPECT_TRUE(with_shaping_contours(document).frames[1].contours.empty());
  EXPECT_EQ(with_shaping_contours(with_frame_posed(document, 1)).frames[1].contours.size(), 1u);
}

TEST(Frames, TheOtherCameraShowsDepthZeroAsLarge) {
  const Document flat = figure();
  const Document deep = with_camera_type(flat, Camera::Type::perspective);
  const Vec3 hand(1.2, 0.3, 0);
  EXPECT_LT((frame_camera(flat, 0).project(hand) - frame_camera(deep, 0).project(hand)).norm(),
            1e-9);
  EXPECT_TRUE(frame_camera(deep, 0).in_front({0, 0, 2}));
  const Document back = with_camera_type(deep, Camera::Type::orthographic);
  EXPECT_NEAR(back.camera.pixels_per_unit, flat.camera.pixels_per_unit, 1e-9);
}

TEST(Camera, StandsBeforeWhatIsDrawnAndEveryJoint) {
  Document one;  // whose skeleton has no height
  one.camera.pixels_per_unit = 100;
  one.skeleton.joints.emplace_back().name = "heart";
  one.frames.resize(1);
  one.frames[0].width = one.frames[0].height = 400;
  one.frames[0].pose = rest_pose(one.skeleton);
  one.frames[0].contours.push_back({0, circle({200, 200}, 100), ""});
  EXPECT_NEAR(with_camera_type(one, Camera::Type::perspective).camera.distance, 8, 0.1);
  one.frames[0].pose.root_position.z() = 50;
  const Document deep = with_camera_type(one, Camera::Type::perspective);
  EXPECT_TRUE(frame_camera(deep, 0).in_front({0, 0, 50}));
}

TEST(Join, TheOtherOutlineGoes) {
  Document document = figure();
  document = with_contour(document, 0, {1, circle({100, 100}, 20), ""});
  document = with_contour(document, 0, {2, circle({130, 100}, 20), ""});
  document = with_contour(document, 0, {3, circle({300, 100}, 20), ""});
  const auto joined = with_contours_joined(document, 0, 1, 0, 12);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->frames[0].contours.size(), 2u);
  EXPECT_EQ(joined->frames[0].contours[0].joint, 2);
  EXPECT_GT(std::abs(signed_area(joined->frames[0].contours[0].line)), 1.5 * kPi * 400);
  EXPECT_FALSE(with_contours_joined(document, 0, 0, 2, 12));
  EXPECT_FALSE(with_contours_joined(document, 0, 0, 0, 12));
}

TEST(Cut, TheHalvesOverlapAndCoverTheWhole) {
  const Polyline whole = circle({100, 100}, 50);
  const auto halves = cut_outline(whole, {20, 101}, {180, 101}, 0.2);
  ASSERT_TRUE(halves);
  const double a = std::abs(signed_area(halves->first)), b = std::abs(signed_area(halves->second));
  EXPECT_GT(a + b, std::abs(signed_area(whole)) * 1.05);
  EXPECT_LT(a, std::abs(signed_area(whole)) * 0.7);
  EXPECT_FALSE(self_crossing(halves->first));
  EXPECT_FALSE(self_crossing(halves->second));
}

TEST(Cut, ALineThatDoesNotCrossTwiceCutsNothing) {
  const Polyline whole = circle({100, 100}, 50);
  EXPECT_FALSE(cut_outline(whole, {100, 100}, {180, 100}, 0.2));
  EXPECT_FALSE(cut_outline(whole, {0, 0}, {180, 0}, 0.2));
  EXPECT_FALSE(cut_outline(whole, {0, 0}, {0, 0}, 0.2));
}

TEST(Cut, StaysInsideAndTakesTheStretchNearestToTheLinesMiddle) {
  // A comb of two teeth: the line passes through both.
  const Polyline comb{
      {{0, 0}, {100, 0}, {100, 60}, {70, 60}, {70, 20}, {30, 20}, {30, 60}, {0, 60}}, true};
  const auto halves = cut_outline(comb, {60, 40}, {120, 40}, 0.5);
  ASSERT_TRUE(halves);
  const Polyline& tooth =
      std::abs(signed_area(halves->first)) < 2000 ? halves->first : halves->second;
  EXPECT_GT(bounds(std::span(&tooth, 1)).min().x(), 69);
  const double both = std::abs(signed_area(halves->first)) + std::abs(signed_area(halves->second));
  EXPECT_GT(both, std::abs(signed_area(comb)) + 100);
  EXPECT_LT(bounds(std::span(&tooth, 1)).max().x(), 100.01);
}

TEST(Cut, GivesEachHalfThePartWhoseBoneLiesInIt) {
  // A whole body as the chest's outline: the arm comes off, then the forearm from the arm.
  Document document = figure();
  document.frames[0].contours.push_back(
      {0, {{{120, 80}, {350, 80}, {350, 120}, {210, 120}, {210, 180}, {120, 180}}, true}, ""});
  const auto arm = with_contour_cut(document, 0, 0, {222, 60}, {222, 130});
  ASSERT_TRUE(arm);
  ASSERT_EQ(arm->frames[0].contours.size(), 2u);
  EXPECT_EQ(arm->frames[0].contours[0].joint, 0);
  EXPECT_EQ(arm->frames[0].contours[1].joint, 1);
  const auto forearm = with_contour_cut(*arm, 0, 1, {270, 60}, {270, 130});
  ASSERT_TRUE(forearm);
  EXPECT_EQ(forearm->frames[0].contours[1].joint, 1);
  EXPECT_EQ(forearm->frames[0].contours[2].joint, 2);
  EXPECT_FALSE(with_contour_cut(document, 0, 0, {300, 60}, {300, 100}));
}

TEST(Redraw, OnlyTheStretchBetweenTheStrokesEndsChanges) {
  const Polyline whole = circle({100, 100}, 50);
  const std::vector<Vec2> bulge = {{150, 100}, {160, 130}, {130, 160}, {100, 150}};
  const Polyline redrawn = with_stretch_redrawn(whole, bulge);
  EXPECT_GT(std::abs(signed_area(redrawn)), std::abs(signed_area(whole)));
  EXPECT_FALSE(self_crossing(redrawn));
  for (const Vec2& p : whole.points) {
    if (p.y() > 99) continue;  // the far half stays
    bool kept = false;
    for (const Vec2& q : redrawn.points) kept = kept || p == q;
    EXPECT_TRUE(kept);
  }
}

TEST(Redraw, BeginsOnTheLineWhereThatHasFewPoints) {
  const Polyline square{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, true};
  // From one side to the next round a corner, begun a little inside and ended a little outside.
  const std::vector<Vec2> round = {{60, 3}, {75, 10}, {90, 25}, {102, 40}};
  const Polyline redrawn = with_stretch_redrawn(square, round);
  EXPECT_FALSE(self_crossing(redrawn));
  EXPECT_FALSE(contains(redrawn, {96, 4}));  // the corner is cut off
  EXPECT_TRUE(contains(redrawn, {30, 3}));   // and nothing else
  EXPECT_TRUE(contains(redrawn, {97, 70}));
}

TEST(Candidates, AWholeFigureIsTheRootsFirst) {
  const Polyline all{{{60, 60}, {340, 60}, {340, 140}, {60, 140}}, true};
  const std::vector<Candidate> found = joint_candidates(figure(), 0, all);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].joint, 0);
  EXPECT_NE(found[0].reason.find("holds most bones"), std::string::npos);
}

TEST(Candidates, TheNearestBoneComesFirstItsMirrorImageToo) {
  const Document document = figure();
  const FrameCamera camera = frame_camera(document, 0);
  const std::vector<Candidate> likely =
      joint_candidates(document, 0, circle(camera.project({0.45, 1, 0}), 20));
  ASSERT_FALSE(likely.empty());
  EXPECT_EQ(likely[0].joint, 1);
  bool mirrored = false;
  for (const Candidate& candidate : likely) mirrored = mirrored || candidate.joint == 4;
  EXPECT_TRUE(mirrored);
}

TEST(Candidates, APartThatIsDrawnOverIsTheLikelyOneThoughItHasAnOutline) {
  Document document = figure();
  const Vec2 at = frame_camera(document, 0).project({0.45, 1, 0});
  document = with_contour(document, 0, {1, circle(at, 20), ""});
  EXPECT_EQ(joint_candidates(document, 0, circle(at + Vec2(4, 0), 20))[0].joint, 1);
  EXPECT_NE(joint_candidates(document, 0, circle(at + Vec2(36, 0), 20))[0].joint, 1);
}

TEST(Contours, OneDrawnOverAnotherTakesItsPlaceAndItsHolesGoWithIt) {
  const auto add = [](Document document, int joint, Vec2 at, double radius) {
    return with_contour(std::move(document), 0, {joint, circle(at, radius), ""});
  };
  Document document = add(figure(), 1, {200, 200}, 40);
  document = add(document, 1, {200, 200}, 8);  // a hole
  document = add(document, 2, {210, 200}, 40);
  document = add(document, 1, {320, 200}, 20);  // beside
  const Polyline over = circle({210, 205}, 35);
  EXPECT_EQ(contours_redrawn(document.frames[0], 1, over), (ContourSet{0, 1}));
  const Document next = with_contour_over(document, 0, {1, over, ""});
  ASSERT_EQ(next.frames[0].contours.size(), 3u);
  EXPECT_EQ(next.frames[0].contours[0].line.points, over.points);
  EXPECT_EQ(next.frames[0].contours[1].joint, 2);
  EXPECT_EQ(next.frames[0].contours[2].joint, 1);
}

TEST(Contours, APieceBesideAndAHoleAreNoneThatTakeAnothersPlace) {
  const Document document = with_contour(figure(), 0, {1, circle({200, 200}, 40), ""});
  const auto redrawn = [&](Vec2 at, double radius) {
    return contours_redrawn(document.frames[0], 1, circle(at, radius)).size();
  };
  EXPECT_EQ(redrawn({270, 200}, 40), 0u) << "a piece that overlaps a little";
  EXPECT_EQ(redrawn({200, 200}, 15), 0u) << "a hole";
  EXPECT_EQ(redrawn({175, 200}, 15), 1u) << "smaller, along the old line";
  EXPECT_EQ(redrawn({200, 200}, 90), 1u) << "larger";
}

TEST(Contours, TheMirrorImageLiesOnTheOtherSide) {
  Document document = figure();
  const FrameCamera camera = frame_camera(document, 0);
  document = with_contour(document, 0, {1, circle(camera.project({0.45, 1.1, 0}), 20), ""});
  const std::optional<Document> both = with_contour_mirrored(document, 0, 0);
  ASSERT_TRUE(both);
  const Contour& copy = both->frames[0].contours[1];
  EXPECT_EQ(copy.joint, 4);
  const Vec2 middle = centroid(std::span(&copy.line, 1));
  EXPECT_LT((middle - camera.project({-0.45, 1.1, 0})).norm(), 1e-6);
}

TEST(Contours, ACopyLiesWhereTheOtherDrawingHasItsJoint) {
  Document document = with_frame_copied(figure(), 0);
  // In the second drawing all stands half a unit to the right.
  document.frames[1].pose.root_position.x() += 0.5;
  document = with_contour(document, 0, {3, circle({320, 100}, 20), ""});
  const Document copied = with_contour_copied(document, 0, 0, 1);
  ASSERT_EQ(copied.frames[1].contours.size(), 1u);
  EXPECT_EQ(copied.frames[1].contours[0].joint, 3);
  const std::vector<Polyline> from = contours_of(copied.frames[0], 3),
                              to = contours_of(copied.frames[1], 3);
  EXPECT_LT((centroid(to) - centroid(from) - Vec2(50, 0)).norm(), 1e-6);
  EXPECT_NEAR(signed_area(to[0]), signed_area(from[0]), 1e-6);
}

TEST(Contours, SeveralAreMappedAndTheOthersStay) {
  Document document = figure();
  for (const double x : {50, 150, 250})
    document = with_contour(document, 0, {1, circle({x, 50}, 9), ""});
  PictureMap map = PictureMap::Identity();
  map.translate(Vec2(0, 100)).scale(2.0);
  const Document mapped = with_contours_mapped(document, 0, {0, 2}, map);
  const std::vector<Contour>& now = mapped.frames[0].contours;
  EXPECT_LT((centroid(std::span(&now[0].line, 1)) - Vec2(100, 200)).norm(), 1e-6);
  EXPECT_NEAR(signed_area(now[2].line), 4 * signed_area(document.frames[0].contours[2].line), 1e-6);
  EXPECT_EQ(now[1].line.points, document.frames[0].contours[1].line.points);
  EXPECT_EQ(without_contours(mapped, 0, {0, 2}).frames[0].contours.size(), 1u);
}

TEST(Contours, SimplifiedTheyHaveFewerPointsAndTheSameShape) {
  Document document = with_contour(figure(), 0, {1, circle({150, 150}, 80), ""});
  const Polyline was = document.frames[0].contours[0].line;
  const Polyline now = with_contours_simplified(document, 0, {0}, 0.5).frames[0].contours[0].line;
  EXPECT_LT(now.points.size(), was.points.size());
  EXPECT_GT(now.points.size(), 8u);
  EXPECT_NEAR(signed_area(now) / signed_area(was), 1, 0.01);
}

TEST(Contours, WhatWouldVanishIsNotSimplified) {
  const Document document = with_contour(figure(), 0, {1, circle({50, 50}, 0.2), ""});
  EXPECT_EQ(with_contours_simplified(document, 0, {0}, 0.5).frames[0].contours[0].line.points,
            document.frames[0].contours[0].line.points);
}

TEST(Contours, LooseOnesAreLaidByTheJointsName) {
  Document document = with_contour(figure(), 0, {3, circle({320, 100}, 20), ""});
  std::vector<LooseOutline> loose = loose_outlines(document, 0, {0});
  ASSERT_EQ(loose.size(), 1u);
  EXPECT_EQ(loose[0].joint, document.skeleton.joints[3].name);
  const Document laid = with_outlines_laid(document, 0, loose);
  ASSERT_EQ(laid.frames[0].contours.size(), 2u);
  EXPECT_LT((laid.frames[0].contours[1].line.points[0] - loose[0].line.points[0]).norm(), 1e-9);
  loose[0].joint = "a joint of another skeleton";
  EXPECT_EQ(with_outlines_laid(document, 0, loose).frames[0].contours.size(), 1u);
}

TEST(Contours, BehindAndInFrontStayWithinTheDrawing) {
  Document document = figure();
  document = with_contour(document, 0, {1, circle({50, 50}, 9), ""});
  document = with_contour(document, 0, {2, circle({50, 50}, 9), ""});
  EXPECT_EQ(with_contour_shifted(document, 0, 1, -1).frames[0].contours[0].joint, 2);
  EXPECT_EQ(with_contour_shifted(document, 0, 0, -1).frames[0].contours[0].joint, 1);
}

TEST(Contours, HoldWhatADocumentCanHold) {
  const Vec2 a(0, 0), b(10, 0), c(0, 10);
  Document document = with_contour(figure(), 0, {1, {{a, a, b, b, c, {-1e9, 0}, a}}, ""});
  const std::vector<Vec2>& points = document.frames[0].contours[0].line.points;
  EXPECT_EQ(points, (std::vector<Vec2>{a, b, c, {-1e6, 0}}));
  EXPECT_EQ(with_contour(document, 0, {1, {{a, b, a, a}}, ""}).frames[0].contours.size(), 1u);
  document = with_contour_points(document, 0, 0, {a, b, b, c});  // as a drag passes its neighbour
  EXPECT_EQ(document.frames[0].contours[0].line.points.size(), 4u);
  EXPECT_EQ(with_contour_points(document, 0, 0, {a, a, b}).frames[0].contours[0].line.points,
            document.frames[0].contours[0].line.points);
}

TEST(Frames, CopyMoveAndRemoveKeepTheOthers) {
  Document document = with_frame_copied(figure(), 0);
  ASSERT_EQ(document.frames.size(), 2u);
  EXPECT_EQ(document.frames[1].name, "front copy");
  document = with_frame_moved(document, 1, 0);
  EXPECT_EQ(document.frames[0].name, "front copy");
  document = without_frame(document, 0);
  ASSERT_EQ(document.frames.size(), 1u);
  EXPECT_EQ(document.frames[0].name, "front");
}

TEST(Frames, ANewDrawingHasAPose) {
  Frame blank;
  blank.width = blank.height = 300;
  const Document document = with_frame(figure(), blank);
  EXPECT_EQ(int(document.frames[1].pose.rotations.size()), document.skeleton.size());
}

}  // namespace
}  // namespace artisketch

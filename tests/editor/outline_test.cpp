// Outline: its tools and commands, by what they make of the document.
#include <fstream>

#include <gtest/gtest.h>

#include "base/distance_field.h"
#include "document/edit.h"
#include "document/split.h"
#include "editor/step.h"

namespace artisketch {
namespace {

class Outline : public WithDocument {
 protected:
  // By a click on its line, where nothing else is near.
  void choose(const std::string& name) {
    h.click(on_screen(h, lowest(outline(h, name))));
    h.wait(0.5);
  }
  // Nothing is outlined in this drawing.
  void begin_empty() {
    h.key(ImGuiKey_A, ImGuiMod_Ctrl);
    h.key(ImGuiKey_Delete);
    begin();
  }
  // Round the middle of a part's outline, as large as that times `size`, with the pen.
  void draw_over(const std::string& name, double size) {
    h.key(ImGuiKey_D);
    const Polyline line = outline(h, name);
    std::vector<Vec2> way;
    for (const Vec2& p : line.points)
      way.push_back(on_screen(h, centre(line) + size * (p - centre(line))));
    way.push_back(way.front());
    h.draw(way);
  }
};

// ---------------------------------------------------------------- Edit

TEST_F(Outline, EditChoosesTheOutlineUnderThePointer) {
  choose("hand.R");
  EXPECT_TRUE(h.active("Hand R"));
  EXPECT_TRUE(h.enabled("Redraw"));
  h.click(h.on_screen(4, 4));  // paper
  EXPECT_FALSE(h.active("Hand R"));
  EXPECT_EQ(h.find("Redraw"), nullptr);
  expect_nothing_happened();
}

TEST_F(Outline, EditDragsAPoint) {
  choose("hand.R");
  const Polyline was = outline(h, "hand.R");
  h.drag(on_screen(h, lowest(was)), {4, 12});
  const Polyline now = outline(h, "hand.R");
  EXPECT_EQ(now.points.size(), was.points.size());
  EXPECT_NEAR(lowest(now).y(), lowest(was).y() + 12 / zoom(h), 2);
  EXPECT_NEAR(leftmost(now).x(), leftmost(was).x(), 1e-9) << "what is far stays";
  expect_step("Move point");
}

TEST_F(Outline, EditTakesThePointsBesideAlongTheLessTheFartherTheyAre) {
  begin_empty();
  h.key(ImGuiKey_T);
  h.click(h.on_screen(285, 600));  // a traced outline has points close together
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_V);
  const Polyline was = contours(h).back().line;
  const std::size_t lowest_point =
      std::size_t(std::max_element(was.points.begin(), was.points.end(),
                                   [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); }) -
                  was.points.begin());
  h.drag(on_screen(h, was.points[lowest_point]), {0, 20});
  const Polyline now = contours(h).back().line;
  ASSERT_EQ(now.points.size(), was.points.size());
  std::vector<double> moved;
  for (std::size_t i = 0; i < was.points.size(); ++i)
    moved.push_back((now.points[i] - was.points[i]).norm());
  const double most = *std::max_element(moved.begin(), moved.end());
  EXPECT_NEAR(most, 20 / zoom(h), 0.5);
  const auto between = std::count_if(
      moved.begin(), moved.end(), [&](double by) { return by > 0.02 * most && by < 0.98 * most; });
  const auto still = std::count(moved.begin(), moved.end(), 0);
  EXPECT_GE(between, 2) << "neighbours go along, less";
  EXPECT_GT(still, std::ptrdiff_t(was.points.size() / 2)) << "what is far stays";
}

TEST_F(Outline, EditBendsAnEdgeWhereItIsHeld) {
  choose("hand.R");
  const Polyline was = outline(h, "hand.R");
  // Seen from near, the middle of the longest edge is no handle.
  std::size_t longest = 0;
  const auto length = [&](std::size_t s) { return (was.end_of(s) - was.points[s]).norm(); };
  for (std::size_t s = 0; s < was.segments(); ++s)
    if (length(s) > length(longest)) longest = s;
  const Vec2 middle = (was.points[longest] + was.end_of(longest)) / 2;
  h.point_at(on_screen(h, middle));
  for (int i = 0; i < 12; ++i) h.wheel(1);
  h.drag(on_screen(h, middle), {9, -9});
  EXPECT_EQ(outline(h, "hand.R").points.size(), was.points.size() + 1);
  expect_step("Move point");
}

TEST_F(Outline, EditAddsAPointByDoubleClick) {
  choose("hand.R");
  const Polyline was = outline(h, "hand.R");
  std::size_t longest = 0;
  const auto length = [&](std::size_t s) { return (was.end_of(s) - was.points[s]).norm(); };
  for (std::size_t s = 0; s < was.segments(); ++s)
    if (length(s) > length(longest)) longest = s;
  const Vec2 middle = (was.points[longest] + was.end_of(longest)) / 2;
  h.point_at(on_screen(h, middle));
  for (int i = 0; i < 12; ++i) h.wheel(1);
  h.double_click(on_screen(h, middle));
  EXPECT_EQ(outline(h, "hand.R").points.size(), was.points.size() + 1);
  expect_step("Add point");
}

TEST_F(Outline, DeleteRemovesThePointUnderThePointer) {
  choose("hand.R");
  const Polyline was = outline(h, "hand.R");
  h.point_at(on_screen(h, lowest(was)));
  h.frame();
  h.key(ImGuiKey_Delete);
  EXPECT_LT(outline(h, "hand.R").points.size(), was.points.size());
  expect_step("Delete point");
}

TEST_F(Outline, DeleteRemovesTheOutlineWhereNoPointIsNear) {
  choose("hand.R");
  h.point_at(h.on_screen(4, 4));
  h.key(ImGuiKey_Delete);
  EXPECT_TRUE(outlines(h, "hand.R").empty());
  expect_step("Delete Hand R");
}

TEST_F(Outline, DeleteNeedsAnOutline) {
  h.key(ImGuiKey_Delete);
  expect_nothing_happened();
  EXPECT_FALSE(h.enabled("Delete tool"));
}

TEST_F(Outline, EscLetsGoOfWhatIsChosen) {
  choose("hand.R");
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Redraw"), nullptr);
}

// ---------------------------------------------------------------- Draw

TEST_F(Outline, DrawProposesAPartAndEnterKeepsIt) {
  h.key(ImGuiKey_D);
  EXPECT_TRUE(h.active("Draw tool"));
  h.draw(circle(h.on_screen(250, 330), 40));
  EXPECT_TRUE(text(h) == before) << "it only waits to be kept";
  const std::size_t count = contours(h).size();
  h.key(ImGuiKey_Enter);
  ASSERT_EQ(contours(h).size(), count + 1);
  const Contour& drawn = contours(h).back();
  EXPECT_TRUE(drawn.line.closed);
  EXPECT_NEAR(centre(drawn.line).x(), 250, 4);
  EXPECT_NEAR(centre(drawn.line).y(), 330, 4);
  EXPECT_TRUE(h.state().undo.starts_with("Draw "));
  expect_step(h.state().undo);
}

TEST_F(Outline, WhatIsDrawnOverAPartTakesItsOutlinesPlace) {
  const std::size_t count = contours(h).size();
  const int place = place_of(h, "head");
  const double size = std::abs(signed_area(outline(h, "head")));
  draw_over("head", 1.2);
  EXPECT_TRUE(h.active("Assign Head")) << "it is the likely one, though it has an outline";
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(contours(h).size(), count);
  EXPECT_EQ(place_of(h, "head"), place) << "as far in front as it was";
  EXPECT_NEAR(std::abs(signed_area(outline(h, "head"))), 1.44 * size, 0.1 * size);
  EXPECT_TRUE(h.active("Head"));
  expect_step("Redraw Head");
}

TEST_F(Outline, WhatIsDrawnWithinAPartClearOfItsLineIsAHole) {
  const std::vector<Vec2> was_head = outline(h, "head").points;
  draw_over("head", 0.3);
  while (!h.active("Assign Head")) h.key(ImGuiKey_Tab);
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(outlines(h, "head").size(), 2u);
  EXPECT_EQ(outline(h, "head").points, was_head);
  expect_step("Draw Head");
}

TEST_F(Outline, TabGivesTheNewOutlineToTheNextCandidate) {
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(250, 330), 40));
  std::vector<std::string> cards;
  for (const std::string& label : h.labels())
    if (label.starts_with("Assign ")) cards.push_back(label.substr(7));
  ASSERT_GT(cards.size(), 1u);
  EXPECT_TRUE(h.active("Assign " + cards[0]));
  h.key(ImGuiKey_Tab);
  EXPECT_TRUE(h.active("Assign " + cards[1]));
  h.click("Assign " + cards[0]);
  EXPECT_TRUE(h.active("Assign " + cards[0]));
  h.key(ImGuiKey_Tab);
  h.key(ImGuiKey_Enter);
  expect_step("Draw " + cards[1]);
}

TEST_F(Outline, DrawingOnKeepsTheNewOutline) {
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(250, 330), 40));
  h.draw(circle(h.on_screen(250, 520), 30));
  EXPECT_EQ(contours(h).size(), was.frames[0].contours.size() + 1);
  const std::string first = text(h);
  h.key(ImGuiKey_Escape);  // the second goes
  EXPECT_TRUE(h.state().undo.starts_with("Draw "));
  h.key(ImGuiKey_Enter);
  EXPECT_TRUE(text(h) == first);
}

TEST_F(Outline, EscDropsTheNewOutline) {
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(250, 330), 40));
  h.key(ImGuiKey_Escape);
  h.key(ImGuiKey_Enter);
  expect_nothing_happened();
}

TEST_F(Outline, AltDrawsAnOpenStroke) {
  h.key(ImGuiKey_D);
  h.hold(ImGuiMod_Alt, true);
  h.draw(circle(h.on_screen(250, 330), 40));
  h.hold(ImGuiMod_Alt, false);
  h.key(ImGuiKey_Enter);
  EXPECT_FALSE(contours(h).back().line.closed);
}

TEST_F(Outline, ADotIsNoOutline) {
  h.key(ImGuiKey_D);
  h.click(h.on_screen(250, 330));
  h.key(ImGuiKey_Enter);
  expect_nothing_happened();
}

TEST_F(Outline, SmoothMakesTheNewOutlineSmoother) {
  h.key(ImGuiKey_D);
  const Vec2 middle = h.on_screen(250, 330);
  std::vector<Vec2> zigzag;
  for (const Vec2& p : circle(middle, 50))
    zigzag.push_back(middle + (p - middle) * (zigzag.size() % 2 ? 0.9 : 1.1));
  h.draw(zigzag);
  const Vec2 bar = h.middle("Smooth");
  h.drag(bar, {200, 0});
  h.key(ImGuiKey_Enter);
  double nearest = 1e9, farthest = 0;
  for (const Vec2& p : contours(h).back().line.points) {
    const double r = (p - centre(contours(h).back().line)).norm();
    nearest = std::min(nearest, r);
    farthest = std::max(farthest, r);
  }
  EXPECT_LT(farthest / nearest, 1.1) << "the zigzag is 1.2 to 1";
}

TEST_F(Outline, AStrokeFromTheOutlineToItselfRedrawsThatStretch) {
  choose("hand.R");
  h.click("Draw tool");
  const Polyline was = outline(h, "hand.R");
  const Vec2 left = leftmost(was), right = rightmost(was);
  const Vec2 bulge((left.x() + right.x()) / 2, lowest(was).y() + 25);
  std::vector<Vec2> stroke;
  for (int i = 0; i <= 24; ++i) {
    const double t = i / 24.0;
    stroke.push_back(
        on_screen(h, (1 - t) * (1 - t) * left + 2 * t * (1 - t) * bulge + t * t * right));
  }
  h.draw(stroke);
  EXPECT_EQ(outlines(h, "hand.R").size(), 1u);
  expect_step("Redraw Hand R");
}

TEST_F(Outline, RedrawPutsTheNextOutlineInPlaceOfTheChosenOne) {
  choose("hand.R");
  h.key(ImGuiKey_D, ImGuiMod_Shift);
  EXPECT_TRUE(h.active("Draw tool"));
  const std::size_t count = contours(h).size();
  h.draw(circle(on_screen(h, centre(outline(h, "hand.R"))), 60));
  EXPECT_EQ(contours(h).size(), count);
  EXPECT_NEAR(rightmost(outline(h, "hand.R")).x() - leftmost(outline(h, "hand.R")).x(),
              120 / zoom(h), 6);
  expect_step("Redraw Hand R");
}

TEST_F(Outline, RedrawNeedsAnOutline) {
  h.key(ImGuiKey_D, ImGuiMod_Shift);
  EXPECT_FALSE(h.active("Draw tool"));
}

// ---------------------------------------------------------------- Points

TEST_F(Outline, PointsSetsCornersAndEnterCloses) {
  h.key(ImGuiKey_P);
  EXPECT_TRUE(h.active("Points tool"));
  const std::vector<Vec2> corners = {{200, 300}, {300, 300}, {300, 400}, {200, 400}};
  for (const Vec2& corner : corners) h.click(on_screen(h, corner));
  h.key(ImGuiKey_Enter);  // closes
  EXPECT_TRUE(text(h) == before);
  h.key(ImGuiKey_Enter);  // keeps
  const Polyline& line = contours(h).back().line;
  EXPECT_TRUE(line.closed);
  EXPECT_NEAR(std::abs(signed_area(line)), 100 * 100, 200);
  expect_step(h.state().undo);
}

TEST_F(Outline, PointsClosesByAClickOnTheFirst) {
  h.key(ImGuiKey_P);
  for (const Vec2& corner : {Vec2(200, 300), Vec2(300, 300), Vec2(300, 400), Vec2(200, 300)})
    h.click(on_screen(h, corner));
  h.key(ImGuiKey_Enter);
  EXPECT_NEAR(std::abs(signed_area(contours(h).back().line)), 100 * 100 / 2, 200);
}

TEST_F(Outline, BackspaceTakesTheLastPointBack) {
  h.key(ImGuiKey_P);
  for (const Vec2& corner : {Vec2(200, 300), Vec2(300, 300), Vec2(300, 400), Vec2(210, 600)})
    h.click(on_screen(h, corner));
  h.key(ImGuiKey_Backspace);
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_Enter);
  EXPECT_NEAR(lowest(contours(h).back().line).y(), 400, 2);
}

TEST_F(Outline, DraggingFromAPointBendsTheCurve) {
  h.key(ImGuiKey_P);
  h.click(h.on_screen(200, 300));
  h.drag(h.on_screen(300, 300), {40, 0});
  h.click(h.on_screen(250, 420));
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_Enter);
  const Polyline& line = contours(h).back().line;
  EXPECT_GT(line.points.size(), 6u) << "a curve, not three corners";
  EXPECT_GT(rightmost(line).x(), 302);
}

TEST_F(Outline, TwoPointsAreNoOutline) {
  h.key(ImGuiKey_P);
  h.click(h.on_screen(200, 300));
  h.click(h.on_screen(300, 300));
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_Escape);
  expect_nothing_happened();
}

// ---------------------------------------------------------------- an outline that waits

Vec2 joint_on_screen(const Harness& h, const std::string& name) {
  const std::vector<Transform> posed =
      posed_joints(h.document().skeleton, h.document().frames[0].pose);
  return on_screen(
      h, frame_camera(h.document(), 0).project(posed[std::size_t(joint(h, name))].translation()));
}

TEST_F(Outline, AStrokeMayBeginOverAJointWhileAnotherOutlineWaits) {
  begin_empty();
  const std::size_t count = contours(h).size();
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(60, 60), 30));
  const std::vector<Vec2> round = circle(joint_on_screen(h, "forearm.L") - Vec2(25, 0), 25);
  h.draw(round);  // begins and ends at the joint
  EXPECT_EQ(contours(h).size(), count + 1) << "what waited is kept";
  h.key(ImGuiKey_Enter);
  ASSERT_EQ(contours(h).size(), count + 2) << "and what was drawn";
  const Polyline& drawn = contours(h).back().line;
  EXPECT_NEAR(bounds(std::span(&drawn, 1)).sizes().x(), 50 / zoom(h), 4 / zoom(h));
}

TEST_F(Outline, AClickOnAJointGivesItTheOutlineThatWaits) {
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(60, 60), 30));
  h.click(joint_on_screen(h, "shin.L"));
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(contours(h).back().joint, joint(h, "shin.L"));
}

TEST_F(Outline, ACutMayBeginOverAJointWhileAnOutlineWaits) {
  begin_empty();
  h.key(ImGuiKey_T);
  h.drag(h.on_screen(285, 600), {400, 0});  // the whole figure
  const std::size_t count = contours(h).size();
  h.key(ImGuiKey_K);
  const Vec2 elbow = joint_on_screen(h, "forearm.L"), across(zoom(h) * 50, zoom(h) * 50);
  h.drag(elbow, across);
  EXPECT_GE(contours(h).size(), count + 1) << "the whole is kept";
}

TEST_F(Outline, WhatWaitsIsKeptByJobsAndBySaving) {
  const std::size_t count = contours(h).size();
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(60, 60), 30));
  h.key(ImGuiKey_R);
  EXPECT_EQ(contours(h).size(), count + 1);
  h.settle();
  h.click("Outline mode");
  h.draw(circle(h.on_screen(60, 160), 30));
  h.key(ImGuiKey_C, ImGuiMod_Shift);
  EXPECT_EQ(contours(h).size(), count + 2);
  h.settle();
  h.click("Discard");
  h.click("Outline mode");
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  ASSERT_FALSE(h.platform.unsaved_shown);
  h.draw(circle(h.on_screen(60, 260), 30));
  EXPECT_TRUE(h.platform.unsaved_shown);
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  ASSERT_EQ(h.platform.files.size(), 1u);
  const Result<Document> saved = parse_document(h.platform.files.begin()->second, "saved");
  ASSERT_TRUE(saved.ok());
  EXPECT_EQ(saved->frames[0].contours.size(), count + 3);
  EXPECT_EQ(contours(h).size(), count + 3);
}

// ---------------------------------------------------------------- Trace

TEST_F(Outline, TraceOutlinesTheShapeUnderThePointer) {
  begin_empty();
  h.key(ImGuiKey_T);
  EXPECT_TRUE(h.active("Trace tool"));
  h.click(h.on_screen(285, 600));
  EXPECT_NE(h.find("Tolerance"), nullptr);
  h.key(ImGuiKey_Enter);
  EXPECT_TRUE(contains(contours(h).back().line, Vec2(285, 600)));
  EXPECT_TRUE(h.state().undo.starts_with("Trace "));
  expect_step(h.state().undo);
}

TEST_F(Outline, TraceTakesInMoreTheFartherItIsDragged) {
  begin_empty();
  h.key(ImGuiKey_T);
  h.click(h.on_screen(285, 600));
  h.key(ImGuiKey_Enter);
  const double part = std::abs(signed_area(contours(h).back().line));
  h.drag(h.on_screen(285, 600), {260, 0});
  h.key(ImGuiKey_Enter);
  EXPECT_GT(std::abs(signed_area(contours(h).back().line)), 2 * part);
}

TEST_F(Outline, ToleranceChangesWhatWasTraced) {
  begin_empty();
  h.key(ImGuiKey_T);
  h.click(h.on_screen(285, 600));
  h.drag(h.middle("Tolerance"), {400, 0});
  h.key(ImGuiKey_Enter);
  EXPECT_GT(std::abs(signed_area(contours(h).back().line)), 60000) << "the whole figure";
}

TEST_F(Outline, TraceSaysWhatPaperIs) {
  h.key(ImGuiKey_T);
  h.click(h.on_screen(8, 8));
  EXPECT_TRUE(h.says("That is paper."));
  expect_nothing_happened();
}

TEST(OutlineAlone, TraceNeedsAPicture) {
  Harness h;
  h.click("Blank paper");
  h.click("Outline mode");
  h.key(ImGuiKey_T);
  h.click(h.on_screen(400, 400));
  EXPECT_TRUE(h.says("There is no picture to trace here."));
}

// ---------------------------------------------------------------- Outline all

std::string picture(const std::string& place) {
  std::ifstream file(std::string(ARTISKETCH_SOURCE_DIR "/assets/") + place, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Drawings in, a template over them, outlines, model, file: no pointer draws anything. What is
// clicked are buttons, which Tab reaches in the page (tests/browser/page.test.mjs).
TEST(OutlineAlone, FromABlankPageToAnExportWithoutDrawing) {
  Harness h;
  h.start_over();
  h.platform.to_open.push_back(
      std::vector<NamedBytes>{{"front.png", picture("gallery/alien/front.png"), ""},
                              {"behind.png", picture("gallery/alien/behind.png"), ""}});
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  h.frames(3);
  ASSERT_EQ(h.state().frames, 2);
  h.key(ImGuiKey_2);
  h.click("Template Human");
  for (const int frame : {0, 1}) {
    h.key(ImGuiKey_1);
    h.key(ImGuiKey_T, ImGuiMod_Shift);
    EXPECT_GE(contours(h, frame).size(), 6u) << "drawing " << frame << ": " << h.said();
    h.key(ImGuiKey_Period);
  }
  h.key(ImGuiKey_R);
  h.settle();
  ASSERT_TRUE(h.state().has_model) << h.said();
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  const std::vector<std::string> labels = h.labels();
  const auto button = std::find_if(labels.begin(), labels.end(), [](const std::string& label) {
    return label.starts_with("Export ") && label.ends_with(".glb");
  });
  ASSERT_NE(button, labels.end());
  h.click(*button);
  ASSERT_EQ(h.platform.files.size(), 1u);
  EXPECT_TRUE(h.platform.files.begin()->second.starts_with("glTF"));
}

TEST_F(Outline, OutlineAllGivesEveryPartThatHasNoneOne) {
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.key(ImGuiKey_Delete);
  ASSERT_TRUE(contours(h).empty());
  h.key(ImGuiKey_T, ImGuiMod_Shift);
  EXPECT_EQ(contours(h).size(), 15u);
  EXPECT_EQ(h.state().undo, "Outline 15 parts");
  EXPECT_TRUE(h.says("15 parts are outlined."));
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_TRUE(contours(h).empty()) << "one step";
}

TEST_F(Outline, OutlineAllLeavesFinishedOnesAlone) {
  choose("forearm.R");
  const std::vector<Vec2> head = outline(h, "head").points;
  h.point_at(h.on_screen(4, 4));  // over none of its points
  h.key(ImGuiKey_Delete);
  const std::size_t count = contours(h).size();
  h.click("Outline all");
  EXPECT_EQ(contours(h).size(), count + 1);
  EXPECT_EQ(h.state().undo, "Outline 1 part");
  EXPECT_TRUE(h.says("1 part is outlined. Outlines that were there stay."));
  EXPECT_EQ(outline(h, "head").points, head);
  h.key(ImGuiKey_T, ImGuiMod_Shift);
  EXPECT_TRUE(h.says("Every part has its outline here."));
  EXPECT_EQ(h.state().undo, "Outline 1 part");
}

TEST(OutlineAlone, OutlineAllNeedsAPicture) {
  Harness h;
  h.click("Blank paper");
  h.click("Outline mode");
  h.key(ImGuiKey_T, ImGuiMod_Shift);
  EXPECT_TRUE(h.says("There is no picture to trace here."));
}

// ---------------------------------------------------------------- Cut

TEST_F(Outline, CutMakesTwoThatOverlap) {
  h.key(ImGuiKey_K);
  EXPECT_TRUE(h.active("Cut tool"));
  const Polyline was = outline(h, "forearm.R");
  const Vec2 middle = centre(was);
  choose("forearm.R");  // by the Cut tool a click is a line of no length
  h.key(ImGuiKey_V);
  choose("forearm.R");
  h.key(ImGuiKey_K);
  const std::size_t count = contours(h).size();
  h.drag(on_screen(h, middle - Vec2(0, 60)), Vec2(0, 120) * zoom(h));
  ASSERT_EQ(contours(h).size(), count + 1);
  EXPECT_TRUE(h.state().undo.starts_with("Cut "));
}

TEST_F(Outline, CutNeedsALineRightAcross) {
  h.key(ImGuiKey_K);
  h.drag(h.on_screen(4, 4), {30, 0});
  EXPECT_TRUE(h.says("The line crosses no outline: draw it right across one."));
  const Vec2 middle = centre(outline(h, "head"));
  h.drag(on_screen(h, middle), {6, 0});
  EXPECT_TRUE(h.says("The line ends within Head: draw it from edge to edge.")) << h.said();
  expect_nothing_happened();
}

TEST_F(Outline, CutReachesTheEdgeThatAHandStopsShortOf) {
  choose("hand.R");
  const Polyline line = outline(h, "hand.R");
  const Box2 box = bounds(std::span(&line, 1));
  h.point_at(on_screen(h, box.center()));
  for (int i = 0; i < 8; ++i) h.wheel(1);
  h.key(ImGuiKey_K);
  // From 6 points within one side to 6 points within the other.
  const PolygonDistance distance(std::vector<std::vector<Vec2>>{line.points});
  Vec2 left = box.center(), right = left;
  while (distance.inside(left - Vec2(6 / zoom(h), 0))) left.x() -= 0.25;
  while (distance.inside(right + Vec2(6 / zoom(h), 0))) right.x() += 0.25;
  ASSERT_TRUE(distance.inside(left) && distance.inside(right));
  h.drag(on_screen(h, left), on_screen(h, right) - on_screen(h, left), 12);
  EXPECT_EQ(contours(h).size(), was.frames[0].contours.size() + 1);
  expect_step("Cut Hand R");
}

TEST_F(Outline, SpaceHeldPansAndNoToolDraws) {
  h.key(ImGuiKey_D);
  const Vec2 there = h.on_screen(100, 100);
  h.hold(ImGuiKey_Space, true);
  h.draw(circle(h.on_screen(250, 330), 40, 0.5));
  h.hold(ImGuiKey_Space, false);
  EXPECT_LT((h.on_screen(100, 100) - there - Vec2(-80, 0)).norm(), 8);
  EXPECT_EQ(h.find("Redraw"), nullptr);
  h.draw(circle(h.on_screen(250, 330), 40));
  EXPECT_NE(h.find("Redraw"), nullptr) << "with Space let go, the tool draws again";
}

TEST_F(Outline, ATrackpadScrollsAndAWheelZooms) {
  h.point_at(h.on_screen(250, 330));
  const double before = zoom(h);
  const Vec2 there = h.on_screen(0, 0);
  for (int i = 0; i < 5; ++i) h.wheel(0.1f);
  EXPECT_EQ(zoom(h), before);
  EXPECT_NEAR(h.on_screen(0, 0).y() - there.y(), 30, 1);
  h.wait(1);
  h.wheel(1);
  EXPECT_GT(zoom(h), before) << "a whole notch is a wheel's";
}

// ---------------------------------------------------------------- commands

TEST_F(Outline, MirrorMakesTheOtherSides) {
  choose("hand.R");
  h.key(ImGuiKey_M);
  EXPECT_EQ(outlines(h, "hand.L").size(), 2u);
  EXPECT_TRUE(h.active("Hand L")) << "and chooses it";
  expect_step("Mirror Hand R");
}

TEST_F(Outline, MirrorNeedsAnotherSide) {
  choose("head");
  EXPECT_FALSE(h.enabled("Mirror tool"));
  h.key(ImGuiKey_M);
  expect_nothing_happened();
}

TEST_F(Outline, CopyToAsksWhereAndWhatBecomesOfTheOneThere) {
  choose("hand.R");
  const std::size_t count = outlines(h, "hand.R", 2).size();
  ASSERT_GT(count, 0u);
  const std::string third = "Copy to " + drawing_words(h.document(), 2);
  const auto ask = [&] {
    h.key(ImGuiKey_C);
    h.frames(2);
    h.click(third);
    h.frames(2);
  };
  ask();
  EXPECT_TRUE(text(h) == before) << "a finished outline was replaced, or doubled, without a word";
  h.click("Cancel");
  EXPECT_TRUE(text(h) == before);
  ask();
  h.click("Keep both");
  h.frames(2);
  EXPECT_EQ(outlines(h, "hand.R", 2).size(), count + 1);
  EXPECT_EQ(h.state().frame, 2);
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_TRUE(text(h) == before);
  h.click("Previous drawing");
  h.click("Previous drawing");
  choose("hand.R");
  ask();
  h.click("Replace");
  h.frames(2);
  EXPECT_EQ(outlines(h, "hand.R", 2).size(), 1u);
  expect_step("Copy Hand R");
}

TEST_F(Outline, CopyToADrawingWithoutThePartJustCopies) {
  choose("hand.R");
  h.point_at(h.on_screen(4, 4));
  h.key(ImGuiKey_Delete);
  ASSERT_TRUE(outlines(h, "hand.R").empty());
  h.click("Next drawing");
  h.wait(0.5);
  h.click(on_screen(h, lowest(outline(h, "hand.R", 1))));
  h.key(ImGuiKey_C);
  h.frames(2);
  h.click("Copy to " + drawing_words(h.document(), 0));
  h.frames(2);
  EXPECT_EQ(h.state().frame, 0);
  EXPECT_EQ(outlines(h, "hand.R").size(), 1u);
}

// ---------------------------------------------------------------- outlines as things

TEST_F(Outline, UndoTakesBackTheOutlineThatWaitsFirst) {
  choose("hand.R");
  h.point_at(h.on_screen(4, 4));
  h.key(ImGuiKey_Delete);
  begin();
  h.key(ImGuiKey_D);
  h.draw(circle(h.on_screen(250, 330), 40));
  EXPECT_EQ(h.state().undo, "new outline");
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_TRUE(text(h) == before) << "the step before was undone in its place";
  EXPECT_EQ(h.find("Redraw"), nullptr);
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl | ImGuiMod_Shift);
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(contours(h).size(), was.frames[0].contours.size() + 1) << "redo brings it back";
  expect_step(h.state().undo);
}

TEST_F(Outline, UndoTakesBackPointAfterPoint) {
  h.key(ImGuiKey_P);
  h.click(h.on_screen(200, 300));
  h.click(h.on_screen(260, 350));
  h.click(h.on_screen(200, 420));
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  h.key(ImGuiKey_Enter);
  expect_nothing_happened();  // two points enclose nothing
  h.click(h.on_screen(210, 430));
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_Enter);
  ASSERT_EQ(contours(h).size(), was.frames[0].contours.size() + 1);
  EXPECT_LT((lowest(contours(h).back().line) - Vec2(210, 430)).norm(), 8);
}

TEST_F(Outline, ArrangeMovesTheOutlineUnderThePointer) {
  h.key(ImGuiKey_A);
  EXPECT_TRUE(h.active("Arrange tool"));
  const Polyline was = outline(h, "hand.R");
  h.drag(on_screen(h, lowest(was)), {30, -20});
  const Polyline now = outline(h, "hand.R");
  ASSERT_EQ(now.points.size(), was.points.size());
  for (std::size_t i = 0; i < was.points.size(); ++i)
    EXPECT_NEAR((now.points[i] - was.points[i] - Vec2(30, -20) / zoom(h)).norm(), 0, 1e-3);
  expect_step("Move Hand R");
}

TEST_F(Outline, ArrangeScalesByACornerAndTurnsByTheKnob) {
  h.key(ImGuiKey_A);
  h.click(on_screen(h, lowest(outline(h, "hand.R"))));
  h.frame();
  const Polyline was = outline(h, "hand.R");
  const Box2 box = bounds(std::span(&was, 1));
  h.drag(h.middle("Scale bottom right"), {40, 40});
  const Polyline larger = outline(h, "hand.R");
  const Box2 now = bounds(std::span(&larger, 1));
  EXPECT_NEAR((now.min() - box.min()).norm(), 0, 1e-6) << "the far corner stays";
  EXPECT_NEAR(now.sizes().x() / now.sizes().y(), box.sizes().x() / box.sizes().y(), 1e-6);
  EXPECT_GT(now.sizes().x(), box.sizes().x() + 20 / zoom(h));
  EXPECT_EQ(h.state().undo, "Scale Hand R");
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  h.frame();
  const Vec2 knob = h.middle("Turn outlines"), middle = on_screen(h, box.center());
  const double r = (knob - middle).norm();
  h.drag(knob, Vec2(middle.x() + r, middle.y()) - knob, 12);  // a quarter turn
  const Polyline turned = outline(h, "hand.R");
  const Box2 after = bounds(std::span(&turned, 1));
  EXPECT_NEAR(after.sizes().x(), box.sizes().y(), 0.02 * box.sizes().y());
  EXPECT_NEAR((after.center() - box.center()).norm(), 0, 0.02 * box.sizes().y());
  expect_step("Turn Hand R");
}

TEST_F(Outline, ABoxChoosesSeveralAndTheyGoTogether) {
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.active("Arrange tool"));
  const std::size_t count = contours(h).size();
  const Vec2 from = outline(h, "hand.R").points[0], head = outline(h, "head").points[0];
  h.key(ImGuiKey_RightArrow);
  h.key(ImGuiKey_RightArrow);
  h.key(ImGuiKey_DownArrow, ImGuiMod_Shift);
  EXPECT_NEAR((outline(h, "hand.R").points[0] - from - Vec2(2, 10)).norm(), 0, 1e-9);
  EXPECT_NEAR((outline(h, "head").points[0] - head - Vec2(2, 10)).norm(), 0, 1e-9);
  expect_step("Move " + std::to_string(count) + " outlines");
  h.key(ImGuiKey_Delete);
  EXPECT_TRUE(contours(h).empty());
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_EQ(contours(h).size(), count);
}

TEST_F(Outline, ShiftAddsAndTakesAwayAgain) {
  h.key(ImGuiKey_A);
  const Vec2 hand = on_screen(h, lowest(outline(h, "hand.R"))),
             foot = on_screen(h, lowest(outline(h, "foot.L")));
  h.click(hand);
  h.hold(ImGuiMod_Shift, true);
  h.click(foot);
  h.hold(ImGuiMod_Shift, false);
  h.key(ImGuiKey_UpArrow);
  EXPECT_EQ(h.state().undo, "Move 2 outlines");
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  h.hold(ImGuiMod_Shift, true);
  h.click(foot);
  h.hold(ImGuiMod_Shift, false);
  h.key(ImGuiKey_UpArrow);
  EXPECT_EQ(h.state().undo, "Move Hand R");
}

TEST_F(Outline, CopyAndPasteLayItOverTheBoneOfAnotherDrawing) {
  choose("hand.R");
  h.key(ImGuiKey_C, ImGuiMod_Ctrl);
  expect_nothing_happened();
  h.click("Next drawing");
  const std::size_t count = outlines(h, "hand.R", 1).size();
  const Vec2 there = centre(outline(h, "hand.R", 1));
  h.key(ImGuiKey_V, ImGuiMod_Ctrl);
  const std::vector<Polyline> now = outlines(h, "hand.R", 1);
  ASSERT_EQ(now.size(), count + 1);
  const Box2 size = bounds(std::span(&now[0], 1));
  EXPECT_LT((centre(now.back()) - there).norm(), size.sizes().maxCoeff())
      << "it lies about where that drawing has the hand";
  expect_step("Paste Hand R");
}

TEST_F(Outline, DuplicateLiesBesideToBeSeen) {
  choose("hand.R");
  h.key(ImGuiKey_D, ImGuiMod_Ctrl);
  const std::vector<Polyline> now = outlines(h, "hand.R");
  ASSERT_EQ(now.size(), 2u);
  EXPECT_GT((now[1].points[0] - now[0].points[0]).norm(), 1);
  expect_step("Duplicate Hand R");
}

TEST_F(Outline, SimplifyKeepsTheLineWithHalfThePoints) {
  h.key(ImGuiKey_T);
  h.click(h.on_screen(320, 260));
  h.key(ImGuiKey_Enter);
  const Polyline traced = contours(h).back().line;
  begin();
  h.key(ImGuiKey_S, ImGuiMod_Shift);
  const Polyline now = contours(h).back().line;
  EXPECT_LT(now.points.size(), traced.points.size());
  const std::vector<std::vector<Vec2>> lines = {now.points};
  const PolygonDistance line(lines);
  for (const Vec2& p : traced.points) EXPECT_LE(std::abs(line.distance(p)), 0.5 + 1e-9);
  expect_step(h.state().undo);
}

TEST(OutlineAlone, CopyToNeedsASecondDrawing) {
  Harness h;
  h.click("Blank paper");
  h.click("Outline mode");
  h.draw(circle(h.on_screen(400, 400), 60));
  h.key(ImGuiKey_Enter);
  ASSERT_EQ(contours(h).size(), 1u);
  EXPECT_FALSE(h.enabled("Copy to tool"));
  const std::string before = text(h);
  h.key(ImGuiKey_C);
  EXPECT_TRUE(text(h) == before);
}

TEST_F(Outline, BehindAndInFrontShiftAmongTheOthers) {
  choose("hand.R");
  const int was = place_of(h, "hand.R");
  ASSERT_GT(was, 0);
  h.key(ImGuiKey_LeftBracket);
  EXPECT_EQ(place_of(h, "hand.R"), was - 1);
  EXPECT_EQ(h.state().undo, "Hand R behind");
  h.key(ImGuiKey_RightBracket);
  EXPECT_EQ(h.state().undo, "Hand R in front");
  EXPECT_TRUE(text(h) == before);
}

TEST_F(Outline, NothingIsBehindTheLastOrInFrontOfTheFirst) {
  h.click("Hips in 1");
  while (h.find("Behind tool")->enabled) h.click("Behind tool");
  const std::string last = text(h);
  h.key(ImGuiKey_LeftBracket);
  EXPECT_TRUE(text(h) == last);
  for (std::size_t i = 0; i < 2 * contours(h).size(); ++i) h.key(ImGuiKey_RightBracket);
  const std::string first = text(h);
  h.key(ImGuiKey_RightBracket);
  EXPECT_TRUE(text(h) == first);
  EXPECT_EQ(place_of(h, "hips"), int(contours(h).size()) - 1);
}

TEST_F(Outline, OtherJointGivesItToTheJointClickedNext) {
  choose("hand.R");
  const Polyline line = outline(h, "hand.R");
  h.key(ImGuiKey_O);
  EXPECT_TRUE(h.active("Other joint"));
  h.click("Hand L");  // in the list of parts
  EXPECT_FALSE(h.active("Other joint"));
  EXPECT_EQ(outlines(h, "hand.L").size(), 2u);
  EXPECT_TRUE(outlines(h, "hand.R").empty());
  expect_step("Give to Hand L");
}

TEST_F(Outline, OtherJointTwiceIsNone) {
  choose("hand.R");
  h.key(ImGuiKey_O);
  h.key(ImGuiKey_O);
  EXPECT_FALSE(h.active("Other joint"));
}

TEST_F(Outline, JoinTakesTheOutlineClickedNext) {
  choose("hand.R");
  const std::size_t count = contours(h).size();
  const double own = std::abs(signed_area(outline(h, "hand.R")));
  h.key(ImGuiKey_J);
  EXPECT_TRUE(h.active("Join"));
  // At a place of its line that is far from the hand.
  const std::vector<Vec2> line = outline(h, "forearm.R").points;
  const Vec2 hand = centre(outline(h, "hand.R"));
  h.click(on_screen(h, *std::max_element(line.begin(), line.end(), [&](auto& a, auto& b) {
                      return (a - hand).norm() < (b - hand).norm();
                    })));
  EXPECT_EQ(contours(h).size(), count - 1);
  EXPECT_GT(std::abs(signed_area(outline(h, "hand.R"))), 1.2 * own);
  EXPECT_FALSE(h.active("Join"));
  expect_step("Join Hand R");
}

TEST_F(Outline, JoinSaysThatOutlinesMustTouch) {
  choose("hand.R");
  h.key(ImGuiKey_J);
  h.click(on_screen(h, lowest(outline(h, "foot.L"))));
  EXPECT_TRUE(h.says("Only outlines that touch can be joined, or strokes."));
  expect_nothing_happened();
}

// An eight: its middle crosses itself.
std::vector<Vec2> eight(const Vec2& middle, double size) {
  std::vector<Vec2> places;
  for (int i = 0; i <= 64; ++i) {
    const double a = 2 * M_PI * i / 64 + 0.3;
    places.push_back(middle + size * Vec2(std::sin(a), std::sin(2 * a) / 1.5));
  }
  return places;
}

TEST_F(Outline, MendPutsRightWhatCrossesItself) {
  h.key(ImGuiKey_D);
  h.draw(eight(h.on_screen(250, 330), 60));
  EXPECT_NE(h.find("Mend new"), nullptr);
  h.key(ImGuiKey_Enter);
  ASSERT_TRUE(h.enabled("Mend"));
  const std::string crossed = text(h);
  h.key(ImGuiKey_M, ImGuiMod_Shift);
  EXPECT_TRUE(h.state().undo.starts_with("Mend "));
  EXPECT_FALSE(h.enabled("Mend"));
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_TRUE(text(h) == crossed);
}

TEST_F(Outline, MendOfANewOutlineIsNoStepOfItsOwn) {
  h.key(ImGuiKey_D);
  h.draw(eight(h.on_screen(250, 330), 60));
  h.click("Mend new");
  EXPECT_EQ(h.find("Mend new"), nullptr);
  EXPECT_TRUE(text(h) == before);
}

TEST_F(Outline, MendNeedsACrossing) {
  choose("hand.R");
  EXPECT_FALSE(h.enabled("Mend"));
  h.key(ImGuiKey_M, ImGuiMod_Shift);
  expect_nothing_happened();
}

TEST_F(Outline, HiddenHereSettlesWhatADrawingLacks) {
  h.click("Hand R in 2");
  h.key(ImGuiKey_Delete);
  h.click("Hand R in 2");
  EXPECT_NE(h.find("Missing in Side"), nullptr);
  const std::string missing = text(h);
  h.key(ImGuiKey_H, ImGuiMod_Shift);
  EXPECT_EQ(h.state().undo, "Hide Hand R");
  EXPECT_TRUE(is_hidden(h.document().frames[1], joint(h, "hand.R")));
  EXPECT_NE(h.find("Hidden in Side"), nullptr);
  h.key(ImGuiKey_H, ImGuiMod_Shift);
  EXPECT_EQ(h.state().undo, "Unhide Hand R");
  EXPECT_TRUE(text(h) == missing);
}

TEST_F(Outline, WhatIsOutlinedIsNotHidden) {
  choose("hand.R");
  h.key(ImGuiKey_H, ImGuiMod_Shift);
  expect_nothing_happened();
}

TEST_F(Outline, AThingBeforeTheBodyIsMarkedAsSuch) {
  choose("hand.R");
  h.click("Held thing");
  EXPECT_EQ(role_of(h.document(), joint(h, "hand.R")), Role::held);
  EXPECT_TRUE(h.active("Held thing"));
  expect_step("Hand R is held");
  h.click("Not of it");
  EXPECT_EQ(role_of(h.document(), joint(h, "hand.R")), Role::apart);
  EXPECT_FALSE(h.active("Held thing"));
  EXPECT_EQ(h.state().undo, "Hand R is no part of the figure");
  h.click("Not of it");
  EXPECT_EQ(h.state().undo, "Hand R is a part of the figure");
  EXPECT_EQ(role_of(h.document(), joint(h, "hand.R")), Role::body);
}

TEST_F(Outline, AThingThatIsHeldIsAPartOfItsOwn) {
  h.click(on_screen(h, lowest(outline(h, "hand.R"))), ImGuiMouseButton_Right);
  ASSERT_NE(h.find("New held thing"), nullptr);
  h.click("New held thing");
  const int thing = joint(h, "thing");
  ASSERT_GE(thing, 0);
  EXPECT_EQ(h.document().skeleton.joints[std::size_t(thing)].parent, joint(h, "hand.R"));
  EXPECT_EQ(role_of(h.document(), thing), Role::held);
  expect_step("Thing held by Hand R");
  EXPECT_NE(h.find("Thing"), nullptr) << "in the list of parts";
}

TEST_F(Outline, TheMenuOfAnOutlineDoesTheSame) {
  h.click(on_screen(h, lowest(outline(h, "hand.R"))), ImGuiMouseButton_Right);
  ASSERT_NE(h.find("Mirror"), nullptr);
  h.click("Mirror");
  expect_step("Mirror Hand R");
}

// ---------------------------------------------------------------- Split

TEST_F(Outline, SplitPutsAJointInAPartAndCutsItInEveryDrawing) {
  choose("forearm.R");
  const int joints = was.skeleton.size();
  h.key(ImGuiKey_K, ImGuiMod_Shift);
  EXPECT_EQ(h.document().skeleton.size(), joints + 2) << "the other side's, too";
  for (int f = 0; f < h.state().frames; ++f)
    for (const char* part : {"forearm.R", "forearm 2.R"})
      EXPECT_EQ(outlines(h, part, f).size(), was.frames[std::size_t(f)].contours.empty() ? 0u : 1u)
          << part << " in " << f;
  EXPECT_TRUE(h.active("Forearm 2 R")) << "the new part is chosen";
  expect_step("Split Forearm R");
}

TEST_F(Outline, SplitFromTheMenuGoesByThePlaceWhereThePartIsStraight) {
  // Where no other outline is near, so far along the part.
  const auto away = [](const Polyline& line, const Vec2& p) {
    double least = 1e9;
    for (const Vec2& q : line.points) least = std::min(least, (q - p).norm());
    return least;
  };
  std::vector<Contour> fine = contours(h);
  for (Contour& contour : fine) contour.line = resampled(contour.line, 3);
  const auto place_at = [&](double along) {
    const Polyline shin = outline(h, "shin.R");
    for (const Vec2& edge : resampled(shin, 3).points) {
      const Vec2 p = edge + 4 * (centre(shin) - edge).normalized();
      bool clear = contains(shin, p);
      for (const Contour& contour : fine)
        clear = clear && (contour.joint == joint(h, "shin.R") || away(contour.line, p) > 8);
      if (clear && std::abs(along_part(was, 0, joint(h, "shin.R"), p).value_or(9) - along) < 0.03)
        return p;
    }
    ADD_FAILURE() << "no such place";
    return Vec2(0, 0);
  };
  for (const double along : {0.4, 0.55}) {
    h.click(on_screen(h, place_at(along)), ImGuiMouseButton_Right);
    h.click("Split at a joint");
    ASSERT_EQ(h.state().undo, "Split Shin R");
    const Skeleton& skeleton = h.document().skeleton;
    const double own = skeleton.joints[std::size_t(joint(h, "shin 2.R"))].offset.norm(),
                 rest = skeleton.joints[std::size_t(joint(h, "foot.R"))].offset.norm();
    EXPECT_NEAR(own / (own + rest), along, 0.04);
    h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  }
}

// A chest and an arm of one part, stretched in one drawing and bent in the other.
Document bending_arm() {
  Document document;
  document.name = "bend";
  document.camera.pixels_per_unit = 100;
  document.skeleton.joints = {{"chest", -1, Vec3::Zero(), -1, ""},
                              {"arm.L", 0, {0.3, 0, 0}, -1, ""},
                              {"hand.L", 1, {1.2, 0, 0}, -1, ""}};
  for (int f = 0; f < 2; ++f) {
    Frame frame;
    frame.name = f == 0 ? "straight" : "bent";
    frame.width = frame.height = 400;
    frame.pose = rest_pose(document.skeleton);
    const Polyline chest{{{160, 150}, {240, 150}, {240, 260}, {160, 260}}, true};
    const Polyline straight{{{222, 186}, {360, 186}, {360, 214}, {222, 214}}, true};
    const Polyline bent{{{222, 186}, {286, 186}, {286, 124}, {314, 124}, {314, 214}, {222, 214}},
                        true};
    frame.contours = {{0, chest, ""}, {1, f == 0 ? straight : bent, ""}};
    if (f == 1) frame.pose.rotations[1] = Quat(Eigen::AngleAxisd(0.75, Vec3::UnitZ()));
    document.frames.push_back(frame);
  }
  return document;
}

TEST(OutlineAlone, ANoteThatAPartBendsOffersToSplitIt) {
  Harness h;
  h.open("bend.artisketch", document_text(bending_arm()));
  h.key(ImGuiKey_R);
  h.settle();
  ASSERT_TRUE(h.state().has_model);
  const std::vector<std::string> labels = h.labels();
  const auto notes = std::find_if(labels.begin(), labels.end(), [](const std::string& label) {
    return label.find("note") != std::string::npos;
  });
  ASSERT_NE(notes, labels.end());
  h.click(*notes);
  h.click("Split Arm L at a joint");
  EXPECT_EQ(h.state().undo, "Split Arm L");
  for (int f = 0; f < 2; ++f) EXPECT_EQ(outlines(h, "arm 2.L", f).size(), 1u);
  const FrameCamera camera = frame_camera(h.document(), 1);
  const Vec2 elbow =
      camera.project(posed_joints(h.document().skeleton,
                                  h.document().frames[1].pose)[std::size_t(joint(h, "arm 2.L"))]
                         .translation());
  EXPECT_LT((elbow - Vec2(300, 200)).norm(), 16) << "where the drawing bends it";
  EXPECT_EQ(h.find("Split Arm L at a joint"), nullptr) << "it bends no more";
}

}  // namespace
}  // namespace artisketch

// Pose: what the tools and commands do to one drawing's pose, and what calibration proposes.
#include <gtest/gtest.h>

#include "document/edit.h"
#include "document/posing.h"
#include "editor/step.h"
#include "files/document_file.h"

namespace artisketch {
namespace {

class PoseMode : public WithDocument {
 protected:
  PoseMode() { h.key(ImGuiKey_3); }
  // In another drawing nothing changes, ever.
  void expect_others_as_before(int frame = 0) {
    for (int f = 0; f < int(was.frames.size()); ++f)
      EXPECT_EQ(
          same_pose(h.document().frames[std::size_t(f)].pose, was.frames[std::size_t(f)].pose),
          f != frame)
          << f;
  }
  void choose(const std::string& words) { h.click("Joint " + words); }
};

TEST_F(PoseMode, DragBendsTheBoneAbove) {
  h.drag(h.middle("Joint Hand L"), {10, -40});
  EXPECT_GT(turned(h, was, "forearm.L") + turned(h, was, "upper_arm.L"), 0.05);
  EXPECT_EQ(h.document().skeleton.joints[std::size_t(joint(h, "hand.L"))].offset,
            was.skeleton.joints[std::size_t(joint(h, "hand.L"))].offset)
      << "lengths are kept";
  expect_others_as_before();
  EXPECT_TRUE(h.state().undo.starts_with("Bend "));
  expect_step(h.state().undo);
}

TEST_F(PoseMode, ADragIsOneStepHoweverFarItGoes) {
  const Vec2 from = h.middle("Joint Hand L");
  h.draw({from, from + Vec2(10, 0), from + Vec2(20, -10), from + Vec2(5, -40)});
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_TRUE(text(h) == before);
  EXPECT_FALSE(h.state().can_undo);
}

TEST_F(PoseMode, TheRootMovesTheBody) {
  const Vec2 from = h.middle("Joint Hips");
  h.drag(from, {40, 0});
  EXPECT_NEAR((h.middle("Joint Hips") - from).x(), 40, 2);
  EXPECT_EQ(turned(h, was, "hips"), 0);
  expect_others_as_before();
  expect_step("Move body");
}

TEST_F(PoseMode, ArrowKeysMoveTheChosenJointInOneStep) {
  choose("Hand L");
  const Vec2 from = h.middle("Joint Hand L");
  for (int i = 0; i < 3; ++i) h.key(ImGuiKey_LeftArrow);
  h.key(ImGuiKey_UpArrow, ImGuiMod_Shift);
  EXPECT_LT((h.middle("Joint Hand L") - from - zoom(h) * Vec2(-3, -10)).norm(), 1);
  expect_others_as_before();
  EXPECT_TRUE(h.state().undo.starts_with("Bend "));
  expect_step(h.state().undo);
}

TEST_F(PoseMode, ArrowKeysThatDoAnotherThingAreAnotherStep) {
  choose("Hand L");
  h.key(ImGuiKey_LeftArrow);
  begin();
  h.key(ImGuiKey_RightArrow, ImGuiMod_Ctrl);
  expect_step("Turn body");
}

TEST_F(PoseMode, ArrowKeysWithCtrlTurnTheBody) {
  for (int i = 0; i < 6; ++i) h.key(ImGuiKey_RightArrow, ImGuiMod_Ctrl);
  EXPECT_NEAR(turned(h, was, "hips"), radians(30), 1e-6);
  const Pose& pose = h.document().frames[0].pose;
  EXPECT_GT((pose.rotations[0] * Vec3::UnitZ()).x(),
            (was.frames[0].pose.rotations[0] * Vec3::UnitZ()).x())
      << "what faces the viewer goes right";
  expect_step("Turn body");
}

TEST_F(PoseMode, TheWheelTwistsTheChosenJoint) {
  choose("Forearm L");
  const double zoom_before = zoom(h);
  h.wheel(2);
  EXPECT_GT(turned(h, was, "upper_arm.L") + turned(h, was, "forearm.L"), 0.05);
  EXPECT_DOUBLE_EQ(zoom(h), zoom_before);
  EXPECT_TRUE(h.state().undo.starts_with("Twist "));
  expect_others_as_before();
}

TEST_F(PoseMode, TheWheelElsewhereZooms) {
  const double was_zoom = zoom(h);
  h.point_at(h.on_screen(20, 20));
  h.wheel(1);
  EXPECT_NEAR(zoom(h), 1.15 * was_zoom, 1e-3);
  expect_nothing_happened();
}

TEST_F(PoseMode, TwistTurnsABoneAboutItself) {
  choose("Hand L");
  h.key(ImGuiKey_T);
  EXPECT_TRUE(h.active("Twist tool"));
  const Vec2 hand = h.middle("Joint Hand L"), elbow = h.middle("Joint Forearm L");
  h.drag(h.on_screen(30, 30), {60, 0});
  EXPECT_LT((h.middle("Joint Hand L") - hand).norm(), 1) << "the bone's ends stay";
  EXPECT_LT((h.middle("Joint Forearm L") - elbow).norm(), 1);
  expect_others_as_before();
  EXPECT_TRUE(h.state().undo.starts_with("Twist "));
  expect_step(h.state().undo);
}

TEST_F(PoseMode, TwistNeedsAJoint) {
  h.key(ImGuiKey_T);
  h.drag(h.on_screen(30, 30), {60, 0});
  expect_nothing_happened();
}

TEST_F(PoseMode, TurnTurnsTheWholeBody) {
  h.key(ImGuiKey_A);
  EXPECT_TRUE(h.active("Turn tool"));
  h.drag(h.middle("Sketch"), {60, 0});
  EXPECT_GT(turned(h, was, "hips"), 0.05);
  EXPECT_EQ(turned(h, was, "hand.L"), 0);
  expect_others_as_before();
  expect_step("Turn body");
}

TEST_F(PoseMode, TheBallTurnsTheWholeBodyWithEveryTool) {
  h.drag(h.middle("Turn the body"), {25, 0});
  EXPECT_GT(turned(h, was, "hips"), 0.05);
  expect_step("Turn body");
}

TEST_F(PoseMode, TheSideViewChangesDepthAlone) {
  const Vec2 hand = h.middle("Joint Hand L");
  h.drag(h.middle("Hand L from the side"), {-20, 0});
  EXPECT_TRUE(h.state().undo.starts_with("Depth of ")) << h.state().undo;
  expect_others_as_before();
  (void)hand;
}

TEST_F(PoseMode, FlipTurnsABoneTowardTheViewer) {
  choose("Hand L");
  h.drag(h.middle("Hand L from the side"), {-20, 0});
  begin();
  h.key(ImGuiKey_F);
  EXPECT_TRUE(h.state().undo.starts_with("Flip "));
  expect_step(h.state().undo);
}

TEST_F(PoseMode, FlipAndLockNeedAJoint) {
  EXPECT_FALSE(h.enabled("Flip tool"));
  EXPECT_FALSE(h.enabled("Lock tool"));
  h.key(ImGuiKey_F);
  h.key(ImGuiKey_L);
  expect_nothing_happened();
}

TEST_F(PoseMode, LockKeepsAPartsTurnAndFreesItAgain) {
  choose("Hand L");
  h.key(ImGuiKey_L);
  EXPECT_EQ(h.document().calibration.locked, std::vector<int>{joint(h, "hand.L")});
  expect_step("Lock Hand L");
  h.key(ImGuiKey_L);
  EXPECT_TRUE(h.document().calibration.locked.empty());
  EXPECT_EQ(h.state().undo, "Free Hand L");
}

TEST_F(PoseMode, ResetBringsTheRestPoseBack) {
  h.click("Reset tool");
  for (std::size_t j = 1; j < h.document().frames[0].pose.rotations.size(); ++j)
    EXPECT_LT(h.document().frames[0].pose.rotations[j].angularDistance(Quat::Identity()), 1e-9);
  expect_others_as_before();
  expect_step("Reset pose");
}

TEST_F(PoseMode, CopyTakesAnotherDrawingsPose) {
  h.key(ImGuiKey_Period);
  h.key(ImGuiKey_C);
  h.click("Pose of Front");
  EXPECT_EQ(turned(h, was, "hand.L", 1) == 0, false);
  for (std::size_t j = 1; j < was.frames[0].pose.rotations.size(); ++j)
    EXPECT_LT(
        h.document().frames[1].pose.rotations[j].angularDistance(was.frames[0].pose.rotations[j]),
        1e-9);
  expect_others_as_before(1);
  expect_step("Copy pose of Front");
}

TEST_F(PoseMode, SuggestFindsAPoseAndAsksWhichWayItBends) {
  h.key(ImGuiKey_S);
  EXPECT_EQ(h.state().undo, "Suggest pose");
  expect_others_as_before();
  h.click("Keep");  // of the poses that explain the drawing, the one it has
  ASSERT_NE(h.find("Toward you"), nullptr);
  const bool toward = h.active("Toward you");
  begin();
  h.click(toward ? "Away" : "Toward you");
  EXPECT_EQ(h.active("Toward you"), !toward);
  expect_step(h.state().undo);
  EXPECT_TRUE(h.state().undo.ends_with(toward ? " away" : " toward you"));
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Toward you"), nullptr);
}

TEST_F(PoseMode, SuggestLeavesWhatAPersonTurned) {
  h.drag(h.middle("Joint Hand L"), {10, -40});
  const Document mine = h.document();
  h.key(ImGuiKey_S);
  EXPECT_EQ(h.state().undo, "Suggest pose");
  for (const int set : mine.frames[0].set_joints)
    EXPECT_EQ(h.document().frames[0].pose.rotations[std::size_t(set)].coeffs(),
              mine.frames[0].pose.rotations[std::size_t(set)].coeffs());
  EXPECT_FALSE(mine.frames[0].set_joints.empty());
}

// The last drawing as it is when it was just added, but outlined.
TEST_F(PoseMode, ADrawingWithoutAPoseSaysSoUntilItHasOne) {
  Document document = h.document();
  document.frames[2].posed = false;
  h.open("again.artisketch", document_text(document));
  h.settle();
  h.key(ImGuiKey_3);
  EXPECT_EQ(h.find("Right as it is"), nullptr) << "the first drawing is the reference";
  h.key(ImGuiKey_Period);
  h.key(ImGuiKey_Period);
  begin();
  ASSERT_NE(h.find("Right as it is"), nullptr);
  h.click("Right as it is");
  EXPECT_EQ(h.find("Right as it is"), nullptr);
  EXPECT_TRUE(is_posed(h.document(), 2));
  expect_step("Take pose as it is");
}

TEST_F(PoseMode, NotesOnTheModelAreListedAndLeadToTheirDrawing) {
  Document document = h.document();
  document.frames[2].posed = false;
  h.open("again.artisketch", document_text(document));
  h.key(ImGuiKey_R);
  h.settle();
  EXPECT_TRUE(h.says("The model is ready. There "));
  h.click("Read");
  const std::vector<std::string> labels = h.labels();
  const auto note = std::find_if(labels.begin(), labels.end(), [](const std::string& label) {
    return label.find("isn't posed yet") != label.npos;
  });
  ASSERT_NE(note, labels.end());
  EXPECT_TRUE(note->starts_with(drawing_words(document, 2))) << *note;
  h.click(*note);
  EXPECT_EQ(h.state().frame, 2);
  h.click("Close notes");
  EXPECT_EQ(h.find("Close notes"), nullptr);
}

TEST_F(PoseMode, SuggestShowsItsRivals) {
  Document document = h.document();
  document.frames[1].posed = false;
  document.frames[1].pose = fitted_rest_pose(document, document.frames[1]);
  h.open("again.artisketch", document_text(document));
  h.settle();
  h.key(ImGuiKey_3);
  h.key(ImGuiKey_Period);
  h.key(ImGuiKey_S);
  EXPECT_EQ(h.state().undo, "Suggest pose");
  const Pose best = h.document().frames[1].pose;
  ASSERT_NE(h.find("Keep"), nullptr);
  begin();
  h.click("Rival 2");
  EXPECT_FALSE(same_pose(h.document().frames[1].pose, best));
  expect_step("Take rival pose");
  h.click("Rival 1");
  EXPECT_TRUE(same_pose(h.document().frames[1].pose, best));
  h.click("Keep");
  EXPECT_EQ(h.find("Keep"), nullptr);
}

class FlatPose : public WithDocument {
 protected:
  FlatPose() : WithDocument("fox") { h.key(ImGuiKey_3); }
};

TEST_F(FlatPose, AFiguresSizeIsSetByItsSlider) {
  EXPECT_EQ(h.find("Figure's size"), nullptr) << "the first drawing is what others are measured by";
  h.key(ImGuiKey_Period);
  const Vec2 root = h.middle("Joint " + joint_words(was.skeleton.joints[0].name).whole());
  begin();
  h.drag(h.middle("Figure's size"), {20, 0});
  EXPECT_GT(h.document().frames[1].scale, was.frames[1].scale);
  EXPECT_LT((h.middle("Joint " + joint_words(was.skeleton.joints[0].name).whole()) - root).norm(),
            1);
  expect_step("Size of " + drawing_words(was, 1));
}

TEST_F(FlatPose, DrawingsOfOtherSizesAreOfferedTheirScale) {
  Document document = h.document();
  Frame& frame = document.frames[1];
  const Vec2 middle = Vec2(frame.width, frame.height) / 2;
  for (Contour& contour : frame.contours)
    for (Vec2& p : contour.line.points) p = middle + 0.7 * (p - middle);
  frame.pose.root_position.head<2>() *= 0.7;
  h.open("small.artisketch", document_text(document));
  h.key(ImGuiKey_R);
  h.settle();
  h.click("Read");
  const std::vector<std::string> labels = h.labels();
  const auto offer = std::find_if(labels.begin(), labels.end(), [](const std::string& label) {
    return label.starts_with("Set size in ");
  });
  ASSERT_NE(offer, labels.end());
  begin();
  h.click(*offer);
  EXPECT_NEAR(h.document().frames[1].scale, 0.7 * was.frames[1].scale, 0.06);
  expect_step("Size of " + drawing_words(was, 1));
}

TEST(PoseAlone, SuggestSaysWhatItLacks) {
  Harness h;
  h.click("Blank paper");
  h.click("Pose mode");
  h.key(ImGuiKey_S);
  EXPECT_TRUE(h.says("Outline a part first."));
  EXPECT_FALSE(h.enabled("Suggest tool"));
  EXPECT_FALSE(h.enabled("Copy tool"));
}

TEST_F(PoseMode, TheTableTellsHowFarPartsAreOff) {
  h.drag(h.middle("Joint Hand L"), {10, -60});
  h.settle();
  const std::vector<std::string> labels = h.labels();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const std::string& label) {
    return label.starts_with("Off ") && label.ends_with(" px");
  }));
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const std::string& label) {
    return label.starts_with("Tag ") && label.ends_with(" px off");
  })) << "and the worst has a tag";
}

// ---------------------------------------------------------------- calibration

class Calibrated : public PoseMode {
 protected:
  Calibrated() {
    h.drag(h.middle("Joint Hips"), {1, 0});  // nothing depends on the pose being perfect
    begin();
    h.key(ImGuiKey_C, ImGuiMod_Shift);
    h.settle();
    h.wait(1);  // it moves there
  }
};

TEST_F(Calibrated, ItWaitsForTheWord) {
  EXPECT_TRUE(text(h) == before);
  EXPECT_TRUE(h.active("Calibrated"));
  h.click("Mine");
  EXPECT_TRUE(h.active("Mine"));
  h.click("Discard");
  EXPECT_EQ(h.find("Discard"), nullptr);
  expect_nothing_happened();
}

TEST_F(Calibrated, KeepTakesIt) {
  h.click("Keep calibrated");
  EXPECT_EQ(h.find("Keep calibrated"), nullptr);
  EXPECT_TRUE(same_pose(h.document().frames[0].pose, was.frames[0].pose))
      << "the first drawing is the reference";
  EXPECT_FALSE(same_pose(h.document().frames[1].pose, was.frames[1].pose));
  expect_step("Keep calibrated");
}

TEST_F(Calibrated, OnlyWhatIsTickedIsTaken) {
  h.key(ImGuiKey_Period);
  const std::string ticked = "Take Head";
  ASSERT_NE(h.find(ticked), nullptr);
  EXPECT_TRUE(h.active(ticked));
  h.click(ticked);
  EXPECT_FALSE(h.active(ticked));
  h.click("Keep calibrated");
  EXPECT_EQ(turned(h, was, "head", 1), 0);
}

TEST_F(Calibrated, PShowsMineWhileItIsHeld) {
  h.key(ImGuiKey_Period);
  const Vec2 theirs = h.middle("Joint Head tip");
  h.hold(ImGuiKey_P, true);
  const Vec2 mine = h.middle("Joint Head tip");
  h.hold(ImGuiKey_P, false);
  EXPECT_EQ(h.middle("Joint Head tip"), theirs);
  EXPECT_NE(mine, theirs);
}

TEST_F(Calibrated, APoseOfOnesOwnTakesItsPlace) {
  h.drag(h.middle("Joint Hand L"), {10, -40});
  EXPECT_EQ(h.find("Keep calibrated"), nullptr);
}

TEST_F(PoseMode, AnEditMeanwhileMakesACalibrationWorthless) {
  h.jobs.held = true;
  h.key(ImGuiKey_C, ImGuiMod_Shift);
  EXPECT_TRUE(h.state().busy);
  h.drag(h.middle("Joint Hips"), {10, 0});
  h.jobs.held = false;
  h.settle();
  EXPECT_EQ(h.find("Keep calibrated"), nullptr);
}

TEST(PoseAlone, CalibrateSaysWhatItLacks) {
  Harness h;
  h.click("Blank paper");
  h.key(ImGuiKey_C, ImGuiMod_Shift);
  EXPECT_TRUE(h.says("Outline a part first."));
  h.key(ImGuiKey_1);
  h.click("Draw tool");
  h.draw(circle(h.on_screen(400, 400), 60));
  h.key(ImGuiKey_Enter);
  h.key(ImGuiKey_C, ImGuiMod_Shift);
  EXPECT_TRUE(h.says("One drawing has no other to agree with: add one."));
  EXPECT_FALSE(h.state().busy);
}

}  // namespace
}  // namespace artisketch

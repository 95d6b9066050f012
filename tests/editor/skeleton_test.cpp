// Skeleton: what the pointer and the commands do to the rest pose.
#include <gtest/gtest.h>

#include "document/edit.h"
#include "document/templates.h"
#include "editor/step.h"

namespace artisketch {
namespace {

class SkeletonMode : public WithDocument {
 protected:
  SkeletonMode() { h.key(ImGuiKey_2); }
  void choose(const std::string& words) {
    h.click("Joint " + words);
    h.wait(0.5);
  }
  const Joint& its(const std::string& name) const {
    return h.document().skeleton.joints[std::size_t(joint(h, name))];
  }
  const Joint& before_its(const std::string& name) const {
    return was.skeleton.joints[std::size_t(was.skeleton.find(name))];
  }
  int size() const { return h.document().skeleton.size(); }
};

TEST_F(SkeletonMode, DragMovesAJointAndItsMirrorImage) {
  h.drag(h.middle("Joint Hand L"), {20, 15});
  EXPECT_GT((its("hand.L").offset - before_its("hand.L").offset).norm(), 0.01);
  Vec3 mirrored = its("hand.L").offset;
  mirrored.x() = -mirrored.x();
  EXPECT_LT((its("hand.R").offset - mirrored).norm(), 1e-9);
  expect_step("Move Hand L");
}

TEST_F(SkeletonMode, DragMovesOneSideAloneWhereSidesAreApart) {
  h.key(ImGuiKey_X);
  EXPECT_FALSE(h.active("Both sides alike"));
  h.drag(h.middle("Joint Hand L"), {20, 15});
  EXPECT_EQ(its("hand.R").offset, before_its("hand.R").offset);
  expect_step("Move Hand L");
}

TEST_F(SkeletonMode, ArrowKeysMoveTheChosenJointInOneStep) {
  choose("Hand L");
  const Vec2 from = h.middle("Joint Hand L");
  h.key(ImGuiKey_RightArrow);
  h.key(ImGuiKey_RightArrow);
  h.key(ImGuiKey_DownArrow, ImGuiMod_Shift);
  EXPECT_LT((h.middle("Joint Hand L") - from - zoom(h) * Vec2(2, 10)).norm(), 1);
  expect_step("Move Hand L");
}

TEST_F(SkeletonMode, TheRootMovesTheBodyInThisDrawingAlone) {
  h.drag(h.middle("Joint Hips"), {30, 0});
  EXPECT_NE(h.document().frames[0].pose.root_position, was.frames[0].pose.root_position);
  EXPECT_EQ(h.document().frames[1].pose.root_position, was.frames[1].pose.root_position);
  expect_step("Move body");
}

TEST_F(SkeletonMode, AClickBesideAChosenJointAddsAChild) {
  choose("Head tip");
  h.key(ImGuiKey_X);
  h.click(h.middle("Joint Head tip") + Vec2(60, -10));
  ASSERT_EQ(size(), was.skeleton.size() + 1);
  EXPECT_EQ(h.document().skeleton.joints.back().parent, was.skeleton.find("head.tip"));
  expect_step("Add joint");
}

TEST_F(SkeletonMode, ADragBesideAChosenJointAddsAWholeBone) {
  choose("Hips");
  const Vec2 from = h.middle("Joint Hips") + Vec2(90, 10);
  h.drag(from, {50, 20});
  ASSERT_EQ(size(), was.skeleton.size() + 4) << "on both sides";
  const Skeleton& skeleton = h.document().skeleton;
  const int start = was.skeleton.size(), end = start + 2;
  EXPECT_EQ(skeleton.joints[std::size_t(start)].parent, 0);
  EXPECT_EQ(skeleton.joints[std::size_t(end)].parent, start);
  const auto seen = [&](int j) {
    return h.middle("Joint " + joint_words(skeleton.joints[std::size_t(j)].name).whole());
  };
  EXPECT_LT((seen(start) - from).norm(), 1);
  EXPECT_LT((seen(end) - from - Vec2(50, 20)).norm(), 1);
  EXPECT_TRUE(h.active("Joint Hips")) << "the next limb may begin there";
  expect_step("Add joint");
}

TEST_F(SkeletonMode, AClickThatSlipsAddsAJointAlone) {
  choose("Head tip");
  h.drag(h.middle("Joint Head tip") + Vec2(60, -10), {8, 0});
  EXPECT_EQ(size(), was.skeleton.size() + 2);
  expect_step("Add joint");
}

TEST_F(SkeletonMode, AChildOfOneSideComesOnBoth) {
  choose("Hand tip L");
  h.click(h.middle("Joint Hand tip L") + Vec2(30, 20));
  EXPECT_EQ(size(), was.skeleton.size() + 2);
  expect_step("Add joint");
}

TEST_F(SkeletonMode, AClickOnNothingAddsNothingWhereNoneIsChosen) {
  h.click(h.on_screen(10, 10));
  expect_nothing_happened();
}

TEST_F(SkeletonMode, DeleteTakesAJointAndItsMirrorImage) {
  choose("Hand tip L");
  h.key(ImGuiKey_Delete);
  EXPECT_EQ(size(), was.skeleton.size() - 2);
  EXPECT_TRUE(h.active("Joint Hand L")) << "the one above is chosen";
  expect_step("Delete Hand tip L");
}

TEST_F(SkeletonMode, DeleteSaysThatAllHangOnTheRoot) {
  choose("Hips");
  h.key(ImGuiKey_Delete);
  EXPECT_TRUE(h.says("All others hang on Hips. Delete those first."));
  expect_nothing_happened();
}

TEST_F(SkeletonMode, WithoutAJointNothingIsDeletedOrNamed) {
  EXPECT_FALSE(h.enabled("Delete tool"));
  EXPECT_FALSE(h.enabled("Rename tool"));
  h.key(ImGuiKey_Delete);
  h.key(ImGuiKey_F2);
  expect_nothing_happened();
}

TEST_F(SkeletonMode, RenameTakesTheKeyboardToTheName) {
  choose("Hand L");
  h.key(ImGuiKey_F2);
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("paw");
  h.key(ImGuiKey_Enter);
  EXPECT_GE(joint(h, "paw.L"), 0);
  EXPECT_GE(joint(h, "paw.R"), 0) << "its mirror image follows";
  expect_step("Rename Hand L");
}

// As they come where a frame takes long: letters that are commands elsewhere, before the field is
// there.
TEST_F(SkeletonMode, LettersTypedRightAfterRenameGoToTheName) {
  choose("Hand L");
  h.keys_at_once({ImGuiKey_F2, ImGuiKey_W, ImGuiKey_X, ImGuiKey_L, ImGuiKey_Enter});
  h.frames(20);
  EXPECT_GE(joint(h, "wxl.L"), 0);
  expect_step("Rename Hand L");
}

TEST_F(SkeletonMode, KeysOfOneFrameActInTheirOrder) {
  choose("Hand L");
  h.keys_at_once({ImGuiKey_3, ImGuiKey_2, ImGuiKey_F2, ImGuiKey_P, ImGuiKey_Enter, ImGuiKey_3});
  h.frames(20);
  EXPECT_GE(joint(h, "p.L"), 0);
  EXPECT_EQ(h.state().mode, "pose");
}

TEST_F(SkeletonMode, AnEmptyNameChangesNothing) {
  choose("Hand L");
  h.key(ImGuiKey_F2);
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.key(ImGuiKey_Delete);
  h.key(ImGuiKey_Enter);
  expect_nothing_happened();
}

TEST_F(SkeletonMode, EqualiseMakesAPairAsLong) {
  h.key(ImGuiKey_X);
  h.drag(h.middle("Joint Hand L"), {25, 10});
  ASSERT_NE(its("hand.L").offset.norm(), its("hand.R").offset.norm());
  begin();
  h.key(ImGuiKey_L);
  EXPECT_NEAR(its("hand.L").offset.norm(), its("hand.R").offset.norm(), 1e-9);
  expect_step("Equalise Hand");
}

TEST_F(SkeletonMode, EqualiseWithoutAJointTakesAllPairs) {
  h.key(ImGuiKey_X);
  h.drag(h.middle("Joint Hand L"), {25, 10});
  h.drag(h.middle("Joint Foot L"), {5, 20});
  h.key(ImGuiKey_Escape);
  begin();
  h.key(ImGuiKey_L);
  EXPECT_NEAR(its("hand.L").offset.norm(), its("hand.R").offset.norm(), 1e-9);
  EXPECT_NEAR(its("foot.L").offset.norm(), its("foot.R").offset.norm(), 1e-9);
  expect_step("Equalise pairs");
}

TEST_F(SkeletonMode, SizeScalesTheWhole) {
  h.click("Larger skeleton");
  EXPECT_NEAR(its("hand.L").offset.norm(), 1.03 * before_its("hand.L").offset.norm(), 1e-9);
  expect_step("Scale skeleton");
  h.click("Smaller skeleton");
  EXPECT_NEAR(its("hand.L").offset.norm(), before_its("hand.L").offset.norm(), 1e-9);
}

TEST_F(SkeletonMode, EachTemplateTakesTheSkeletonsPlace) {
  for (const TemplateWords& words : all_templates()) {
    SCOPED_TRACE(words.name);
    h.open_example("hero");
    if (h.find("Don't save")) h.click("Don't save");
    h.click("Skeleton mode");
    begin();
    h.click(std::string("Template ") + words.name);
    EXPECT_EQ(size(), template_skeleton(words.kind).size());
    for (const Frame& frame : h.document().frames)
      for (const Contour& contour : frame.contours) EXPECT_LT(contour.joint, size());
    EXPECT_EQ(h.state().undo, std::string(words.name) + " skeleton");
    h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
    EXPECT_TRUE(text(h) == before);
  }
}

TEST_F(SkeletonMode, TheMenuOfAJointNamesIt) {
  h.right_click("Joint Hand L");
  ASSERT_NE(h.find("Equalise"), nullptr);
  h.click("Delete");
  EXPECT_LT(joint(h, "hand.L"), 0);
  expect_step("Delete Hand L");
}

}  // namespace
}  // namespace artisketch

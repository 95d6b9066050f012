// What one does in a mode is said where one is: at the first visit, until it is put away.
#include <gtest/gtest.h>

#include "editor/step.h"

namespace artisketch {
namespace {

class HintsShown : public WithDocument {
 protected:
  // All that is drawn of the card.
  static std::vector<float> painted() {
    std::vector<float> places;
    for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists)
      if (std::string(list->_OwnerName) == "Hints")
        for (const ImDrawVert& vertex : list->VtxBuffer)
          places.insert(places.end(), {vertex.pos.x, vertex.pos.y});
    return places;
  }
  bool shown() const { return h.find("Got it") != nullptr; }
};

TEST_F(HintsShown, EachModeOnceAtTheFirstVisit) {
  for (const ImGuiKey mode : {ImGuiKey_1, ImGuiKey_2, ImGuiKey_3, ImGuiKey_4}) {
    h.key(mode);
    ASSERT_TRUE(shown()) << h.state().mode;
    h.click("Got it");
    EXPECT_FALSE(shown());
  }
  for (const ImGuiKey mode : {ImGuiKey_1, ImGuiKey_2, ImGuiKey_3, ImGuiKey_4}) {
    h.key(mode);
    EXPECT_FALSE(shown()) << h.state().mode;
  }
  expect_nothing_happened();
}

TEST_F(HintsShown, TheyAreRememberedByTheNextSession) {
  ASSERT_TRUE(shown());
  h.key(ImGuiKey_2);  // who goes on has seen them, too
  h.click("Got it");
  Harness next({}, h.platform.kept);
  next.open_example("heart");
  next.settle();
  EXPECT_EQ(next.find("Got it"), nullptr);
  next.key(ImGuiKey_2);
  EXPECT_EQ(next.find("Got it"), nullptr);
  next.key(ImGuiKey_3);
  EXPECT_NE(next.find("Got it"), nullptr) << "nobody has been here";
}

TEST_F(HintsShown, TheyComeBackFromTheMenuAndFromTheShortcuts) {
  h.key(ImGuiKey_Escape);
  ASSERT_FALSE(shown());
  h.click("Menu");
  h.click("Menu How this mode works");
  EXPECT_TRUE(shown());
  h.click("Got it");
  h.click("Shortcuts");
  h.click("How this mode works");
  EXPECT_EQ(h.find("Close shortcuts"), nullptr);
  EXPECT_TRUE(shown());
  h.key(ImGuiKey_Escape);
  EXPECT_FALSE(shown());
  expect_nothing_happened();
}

TEST_F(HintsShown, TheShortcutsTheMenuAndAKeyLeadToTheGuide) {
  h.key(ImGuiKey_Escape);
  h.key(ImGuiKey_Slash, ImGuiMod_Shift);
  h.click("Guide");
  EXPECT_EQ(h.platform.guide_shown, 1);
  h.key(ImGuiKey_Escape);
  h.click("Menu");
  h.click("Menu Guide");
  EXPECT_EQ(h.platform.guide_shown, 2);
  h.key(ImGuiKey_F1);
  EXPECT_EQ(h.platform.guide_shown, 3);
  h.platform.guide = false;
  h.key(ImGuiKey_Slash, ImGuiMod_Shift);
  EXPECT_EQ(h.find("Guide"), nullptr) << "this copy came without it";
  expect_nothing_happened();
}

TEST_F(HintsShown, ThePictureMovesAndThenTheWindowRests) {
  h.wait(1);
  const std::vector<float> then = painted();
  ASSERT_FALSE(then.empty());
  h.wait(0.3);
  EXPECT_NE(painted(), then);
  EXPECT_LT(h.editor().next_frame_in(), 0.1);
  h.wait(20);
  const std::vector<float> at_rest = painted();
  h.wait(0.3);
  EXPECT_EQ(painted(), at_rest);
  EXPECT_GT(h.editor().next_frame_in(), 1) << "nothing is drawn for nothing";
}

TEST(HintsAlone, WaitForADrawing) {
  Harness h;
  h.start_over();
  EXPECT_EQ(h.find("Got it"), nullptr) << "the empty canvas says what to do";
  h.click("Blank paper");
  EXPECT_NE(h.find("Got it"), nullptr);
}

}  // namespace
}  // namespace artisketch

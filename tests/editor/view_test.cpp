// How one looks at the document: modes, drawings, layers, zoom, sheets, panels. Nothing here
// changes it.
#include <gtest/gtest.h>

#include "editor/step.h"
#include "editor/ui/theme.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

class Looking : public WithDocument {
 protected:
  ~Looking() override { expect_nothing_happened(); }
};

TEST_F(Looking, TheModesHaveKeysAndButtons) {
  const std::vector<std::pair<ImGuiKey, std::string>> modes = {{ImGuiKey_1, "outline"},
                                                               {ImGuiKey_2, "skeleton"},
                                                               {ImGuiKey_3, "pose"},
                                                               {ImGuiKey_4, "result"}};
  for (const auto& [key, mode] : modes) {
    h.key(key);
    EXPECT_EQ(h.state().mode, mode);
  }
  for (const std::string mode : {"Outline", "Skeleton", "Pose", "Result"}) {
    h.click(mode + " mode");
    EXPECT_TRUE(h.active(mode + " mode"));
  }
}

TEST_F(Looking, EscapeClosesAMenuAndNothingElse) {
  h.key(ImGuiKey_1);
  h.click("Hand R in 1");
  for (const auto& [opener, line] :
       {std::pair("Menu", "Menu New"), std::pair("Drawing card 1", "Crop by hand")}) {
    if (opener == std::string("Menu"))
      h.click(opener);
    else
      h.right_click(opener);
    h.frames(2);
    ASSERT_NE(h.find(line), nullptr) << line;
    h.key(ImGuiKey_3);  // is the menu's
    h.key(ImGuiKey_Escape);
    h.frames(2);
    EXPECT_EQ(h.find(line), nullptr) << line;
    EXPECT_EQ(h.state().mode, "outline");
    EXPECT_TRUE(h.enabled("Mirror tool")) << "what was chosen still is";
  }
}

TEST_F(Looking, CommaAndPeriodGoRoundTheDrawings) {
  h.key(ImGuiKey_Period);
  EXPECT_EQ(h.state().frame, 1);
  h.key(ImGuiKey_Comma);
  h.key(ImGuiKey_Comma);
  EXPECT_EQ(h.state().frame, 2);
  h.key(ImGuiKey_Period);
  EXPECT_EQ(h.state().frame, 0);
  h.click("Next drawing");
  EXPECT_EQ(h.state().frame, 1);
  h.click("Previous drawing");
  h.click("Drawing card 3");
  EXPECT_EQ(h.state().frame, 2);
  EXPECT_TRUE(h.active("Drawing card 3"));
  h.click("Drawing 1");  // the head of the matrix
  EXPECT_EQ(h.state().frame, 0);
}

TEST_F(Looking, HShowsAndHidesTheDrawing) {
  EXPECT_TRUE(h.opacity("Canvas").has_value());
  h.key(ImGuiKey_H);
  EXPECT_FALSE(h.active("Show drawing"));
  EXPECT_FALSE(h.opacity("Canvas").has_value());
  h.click("Show drawing");
  EXPECT_TRUE(h.opacity("Canvas").has_value());
}

TEST_F(Looking, SlashFadesTheDrawingAndBringsItBack) {
  const double full = *h.opacity("Canvas");
  h.key(ImGuiKey_Slash);
  EXPECT_LT(*h.opacity("Canvas"), 0.5 * full);
  h.key(ImGuiKey_Slash);
  EXPECT_NEAR(*h.opacity("Canvas"), full, 1e-6);
  h.drag(h.middle("Drawing opacity"), {-300, 0});
  EXPECT_LT(h.opacity("Canvas").value_or(0), 0.01);  // what is not seen is not drawn
}

TEST_F(Looking, BAndGShowBonesAndModel) {
  EXPECT_TRUE(h.active("Show bones"));
  h.key(ImGuiKey_B);
  EXPECT_FALSE(h.active("Show bones"));
  h.click("Show bones");
  EXPECT_TRUE(h.active("Show bones"));
  const int painted = h.graphics.painted;
  h.frame();
  EXPECT_EQ(h.graphics.painted, painted) << "a model that stands is not painted again";
  EXPECT_FALSE(h.active("Show model"));
  h.key(ImGuiKey_G);
  EXPECT_TRUE(h.active("Show model"));
  EXPECT_GT(h.graphics.painted, painted);
  h.drag(h.middle("Model opacity"), {-30, 0});
  h.click("Show model");
  EXPECT_FALSE(h.active("Show model"));
  h.click("Show outlines");
  EXPECT_FALSE(h.active("Show outlines"));
}

TEST_F(Looking, EachModeHasItsOwnLayers) {
  h.key(ImGuiKey_B);
  h.key(ImGuiKey_3);
  EXPECT_TRUE(h.active("Show bones"));
  h.key(ImGuiKey_1);
  EXPECT_FALSE(h.active("Show bones"));
}

TEST_F(Looking, TheWheelZoomsAtThePointer) {
  const Vec2 place = h.on_screen(300, 200);
  const double was_zoom = zoom(h);
  h.point_at(place);
  h.wheel(2);
  EXPECT_NEAR(zoom(h), 1.15 * 1.15 * was_zoom, 1e-3);
  EXPECT_LT((h.on_screen(300, 200) - place).norm(), 1) << "the pointer is on a whole point";
  h.wheel(-40);
  EXPECT_GT(zoom(h), 0.04) << "not to nothing";
  h.wheel(100);
  EXPECT_LE(zoom(h), 40.1);
}

TEST_F(Looking, PlusMinusAndFit) {
  const double fits = zoom(h);
  h.key(ImGuiKey_Equal);
  EXPECT_NEAR(zoom(h), 1.25 * fits, 1e-3);
  h.key(ImGuiKey_Equal, ImGuiMod_Shift);  // '+' on many keyboards
  h.key(ImGuiKey_Minus);
  h.click("Zoom out");
  EXPECT_NEAR(zoom(h), fits, 1e-3 * fits + 0.2 * fits);
  h.click("Zoom in");
  h.key(ImGuiKey_0);
  EXPECT_NEAR(zoom(h), fits, 1e-6);
  h.key(ImGuiKey_Minus);
  h.click("Fit");
  EXPECT_NEAR(zoom(h), fits, 1e-6);
}

TEST_F(Looking, TheMiddleButtonPans) {
  const Vec2 place = h.on_screen(300, 200);
  h.point_at(place);
  h.press(ImGuiMouseButton_Middle);
  h.point_at(place + Vec2(20, 10));
  h.point_at(place + Vec2(40, 30));
  h.release(ImGuiMouseButton_Middle);
  EXPECT_LT((h.on_screen(300, 200) - place - Vec2(40, 30)).norm(), 1);
}

TEST_F(Looking, TwoFingersPanAndPinch) {
  const Vec2 place = h.on_screen(300, 200);
  const double was_zoom = zoom(h);
  Fingers fingers;
  fingers.count = 2;
  fingers.at = {float(place.x()), float(place.y())};
  fingers.moved = {25, -15};
  h.touch(fingers);
  EXPECT_LT((h.on_screen(300, 200) - place - Vec2(25, -15)).norm(), 1);
  fingers.moved = {0, 0};
  fingers.spread = 1.5;
  h.touch(fingers);
  EXPECT_NEAR(zoom(h), 1.5 * was_zoom, 1e-3);
}

TEST_F(Looking, TheThemeIsKept) {
  h.click("Menu");
  h.click("Menu Light or dark");
  EXPECT_EQ(h.platform.kept["theme"], "light");
  h.click("Menu");
  h.click("Menu Light or dark");
  EXPECT_EQ(h.platform.kept["theme"], "dark");
}

TEST_F(Looking, TheShortcutsOpenAndClose) {
  h.key(ImGuiKey_Slash, ImGuiMod_Shift);
  ASSERT_NE(h.find("Close shortcuts"), nullptr);
  h.key(ImGuiKey_3);
  EXPECT_EQ(h.state().mode, "outline") << "nothing else happens meanwhile";
  h.click("Close shortcuts");
  EXPECT_EQ(h.find("Close shortcuts"), nullptr);
  h.click("Shortcuts");
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Close shortcuts"), nullptr);
  h.click("Shortcuts");
  h.click(Vec2(5, 5));  // beside the sheet
  EXPECT_EQ(h.find("Close shortcuts"), nullptr);
}

TEST_F(Looking, EdgesOfPanelsAreDraggedAndSpringBack) {
  for (const std::string edge : {"Inspector edge", "Model edge"}) {
    const Vec2 place = h.middle(edge);
    h.drag(place, {-60, 0});
    EXPECT_NEAR(h.middle(edge).x(), place.x() - 60, 2) << edge;
    h.double_click(h.middle(edge));
    EXPECT_NEAR(h.middle(edge).x(), place.x(), 1) << edge;
  }
  const Vec2 strip = h.middle("Strip edge");
  h.drag(strip, {0, -50});
  EXPECT_NEAR(h.middle("Strip edge").y(), strip.y() - 50, 2);
}

TEST_F(Looking, AControlThatRestsUnderThePointerIsExplained) {
  h.point_at(h.middle("Reconstruct"));
  h.wait(1);
  h.frames(2);
  bool shown = false;
  for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists)
    shown = shown || std::string(list->_OwnerName).starts_with("##Tooltip");
  EXPECT_TRUE(shown);
}

TEST_F(Looking, AToastGoesByItselfAndAnErrorStays) {
  h.key(ImGuiKey_4);
  h.click("Got it");
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  ASSERT_FALSE(h.said().empty());
  h.wait(7);
  EXPECT_TRUE(h.said().empty());
  EXPECT_GT(h.editor().next_frame_in(), 1) << "and the window rests";
}

TEST_F(Looking, UndoAndRedoWithoutSteps) {
  EXPECT_FALSE(h.enabled("Undo"));
  EXPECT_FALSE(h.enabled("Redo"));
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  h.key(ImGuiKey_Y, ImGuiMod_Ctrl);
}

TEST(Welcome, ItShowsHowItIsDoneAndOpens) {
  Harness h({"circles", "heart"});
  h.wait(0.2);
  EXPECT_NE(h.find("Choose files"), nullptr);
  h.click("Choose files");
  EXPECT_EQ(h.platform.asked.back(), Platform::Kind::drawings);
  h.click("Open document");
  EXPECT_EQ(h.platform.asked.back(), Platform::Kind::document);
  const int painted = h.graphics.painted;
  h.key(ImGuiKey_P);  // stops it
  h.frames(2);
  const int stopped = h.graphics.painted;
  EXPECT_GE(stopped, painted);
  h.drag(h.middle("Turn the model"), {40, 10});
  EXPECT_GT(h.graphics.painted, stopped);
  EXPECT_FALSE(h.editor().unsaved());
}

TEST(Welcome, AModeGoesOnWithACopyOfWhatGreets) {
  Harness h({"circles"});
  h.key(ImGuiKey_1);
  EXPECT_EQ(h.state().mode, "outline");
  EXPECT_EQ(h.document().name, "circles");
  EXPECT_TRUE(h.state().has_model);
  EXPECT_FALSE(h.editor().unsaved());
  EXPECT_EQ(h.platform.title, "circles – ArtiSketch");
}

// However long the example has played.
TEST(Welcome, AModeBeginsWithTheFirstDrawing) {
  Harness h({"hero"});
  h.wait(1.5);
  h.click("Outline mode");
  EXPECT_EQ(h.state().frame, 0);
}

TEST(Welcome, ReconstructThereGoesOnWithIt) {
  Harness h({"circles"});
  h.click("Reconstruct");
  EXPECT_EQ(h.state().mode, "result");
}

TEST(Welcome, TheKeptThemeComesBack) {
  for (const bool dark : {true, false}) {
    Harness h({}, {{"theme", dark ? "dark" : "light"}});
    h.click("Blank paper");
    h.click("Menu");
    h.click("Menu Light or dark");
    EXPECT_EQ(h.platform.kept["theme"], dark ? "light" : "dark");
  }
}

// ---------------------------------------------------------------- sizes

class InSize : public testing::TestWithParam<Harness::Size> {};
INSTANTIATE_TEST_SUITE_P(Sizes, InSize,
                         testing::Values(Harness::Size{1440, 900}, Harness::Size{1280, 720},
                                         Harness::Size{820, 1180}, Harness::Size{400, 600}),
                         [](const auto& info) {
                           return std::to_string(int(info.param.width)) + "x" +
                                  std::to_string(int(info.param.height));
                         });

// Labels name one control each, and what is enabled lies in the window.
TEST_P(InSize, ControlsAreToldApartAndReached) {
  Harness h({}, {}, GetParam());
  h.open_example("hero");
  h.settle();
  for (const std::string mode : {"Outline", "Skeleton", "Pose", "Result"}) {
    h.click(mode + " mode");
    h.frames(2);
    std::vector<std::string> labels = h.labels();
    std::sort(labels.begin(), labels.end());
    const auto twice = std::adjacent_find(labels.begin(), labels.end());
    EXPECT_EQ(twice, labels.end()) << mode << ": two controls are called " << *twice;
    for (const std::string tool : {"Undo", "Reconstruct", "Menu"})
      EXPECT_NE(h.find(tool), nullptr) << mode;
  }
}

TEST(Tablet, ANewOutlineIsKeptByAButton) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.settle();
  h.click("Draw tool");
  h.draw(circle(h.on_screen(250, 330), 40));
  h.click("Keep");
  EXPECT_TRUE(h.state().undo.starts_with("Draw "));
  EXPECT_NE(h.find("Other joint"), nullptr);
}

TEST(Tablet, ATapOnTheInsetSwapsModelAndDrawing) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.settle();
  const double was_zoom = zoom(h);
  h.click("Enlarge the model");
  EXPECT_NE(h.find("Enlarge the drawing"), nullptr);
  EXPECT_LT(zoom(h), was_zoom);
  h.click("Enlarge the drawing");
  EXPECT_NEAR(zoom(h), was_zoom, 1e-6);
}

TEST(Tablet, TheSheetOfPartsIsDrawnUp) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.settle();
  EXPECT_EQ(h.find("Hand R in 2"), nullptr);
  h.drag(h.middle("Parts sheet"), {0, -200});
  EXPECT_NE(h.find("Hand R in 2"), nullptr);
  h.click("All drawings");
  EXPECT_EQ(h.find("Hand R in 2"), nullptr);
  h.click("Hand R");
  EXPECT_TRUE(h.active("Hand R"));
}

TEST(Tablet, MissingPartsAreHiddenOrLeft) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.settle();
  h.click("Hand R");
  h.key(ImGuiKey_Delete);
  ASSERT_NE(h.find("Hide all missing"), nullptr);
  h.click("Leave missing");
  EXPECT_EQ(h.find("Hide all missing"), nullptr);
  h.key(ImGuiKey_Period);
  h.click("Hand L");
  h.key(ImGuiKey_Delete);
  h.click("Hide all missing");
  EXPECT_EQ(h.state().undo, "Hide 1 part");
  EXPECT_TRUE(is_hidden(h.document().frames[1], joint(h, "hand.L")));
}

TEST(Tablet, TheSheetHoldsWhatWaitsForAnAnswer) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.settle();
  h.click("Skeleton mode");
  EXPECT_NE(h.find("Template Human"), nullptr);
  h.click("Joint Hand L");
  EXPECT_NE(h.find("Joint name"), nullptr);
  h.click("Pose mode");
  h.click("Calibrate");
  h.settle();
  h.wait(1);
  h.click("Keep calibrated");
  EXPECT_EQ(h.state().undo, "Keep calibrated");
  h.key(ImGuiKey_R);
  h.settle();
  h.click("Export");
  EXPECT_NE(h.find("Format STL"), nullptr);
}

TEST(Tablet, TwoFingersTapUndoesAndThreeRedo) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.click("Hand R");
  h.key(ImGuiKey_Delete);
  const std::string after = text(h);
  Fingers tap;
  tap.tapped = 2;
  h.touch(tap);
  EXPECT_FALSE(h.state().can_undo);
  tap.tapped = 3;
  h.touch(tap);
  EXPECT_TRUE(text(h) == after);
}

// The first finger may have begun a stroke before the second came.
TEST(Tablet, ASecondFingerTakesBackWhatTheFirstBegan) {
  Harness h({}, {}, {820, 1180});
  h.open_example("hero");
  h.click("Pose mode");
  const std::string before = text(h);
  const Vec2 hand = h.middle("Joint Hand L");
  h.point_at(hand);
  h.frame();
  h.press();
  h.point_at(hand + Vec2(0, -20));
  h.point_at(hand + Vec2(0, -40));
  EXPECT_TRUE(h.state().can_undo);
  Fingers second;
  second.began = true;
  h.touch(second);
  h.release();
  EXPECT_TRUE(text(h) == before);
}

// ---------------------------------------------------------------- drawings of their own

// A figure of one grey on nothing, so far from the picture's edges.
std::string cut_out(std::uint8_t grey, int margin) {
  Image image(120, 160);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::uint8_t* c = &image.rgba[4 * std::size_t(y * image.width + x)];
      const bool inside = x >= margin && y >= margin && x < image.width - margin &&
                          y < image.height - margin && (x >= 20 || y >= 20);
      c[0] = c[1] = c[2] = grey;
      c[3] = inside ? 255 : 0;
    }
  return png_bytes(image);
}

// Whether anything of that colour was drawn last.
bool painted(ImU32 colour) {
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int list = 0; list < data.CmdListsCount; ++list)
    for (const ImDrawVert& vertex : data.CmdLists[list]->VtxBuffer)
      if (vertex.col == colour) return true;
  return false;
}

TEST(LookingAlone, APaleFigureOnNothingStandsOutFromItsGround) {
  for (const bool pale : {true, false}) {
    Harness h;
    h.open("ghost.png", cut_out(pale ? 250 : 90, 20));
    ASSERT_EQ(h.state().frames, 1);
    EXPECT_EQ(painted(theme().dark_ground), pale);
  }
}

TEST(LookingAlone, AFigureThatFillsItsPictureHasRoomAboutIt) {
  Vec2 corner[2];
  for (const int margin : {0, 20}) {
    Harness h;
    h.open("sprite.png", cut_out(90, margin));
    ASSERT_EQ(h.state().frames, 1);
    corner[margin > 0] = h.on_screen(0, 0);
  }
  EXPECT_GT(corner[0].y(), corner[1].y() + 24);
}

}  // namespace
}  // namespace artisketch

// Documents and drawings in and out, and what is kept for a crash.
#include <gtest/gtest.h>

#include "editor/step.h"
#include "files/document_file.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

// A dark figure on white paper; several stand side by side.
std::string drawn(int figures = 1) {
  Image image(120 * figures, 160);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = 255;
  for (int f = 0; f < figures; ++f)
    for (int y = 20; y < 140; ++y)
      for (int x = 120 * f + 30; x < 120 * f + 90; ++x)
        for (int c = 0; c < 3; ++c) image.rgba[4 * std::size_t(y * image.width + x) + c] = 40;
  return png_bytes(image);
}

class Files : public WithDocument {
 protected:
  void edit() {
    h.key(ImGuiKey_1);
    h.click("Hand R in 1");
    h.key(ImGuiKey_Delete);
    ASSERT_TRUE(h.editor().unsaved());
  }
};

// ---------------------------------------------------------------- saving

TEST_F(Files, SaveAsksWhereOnceAndThenNoMore) {
  edit();
  EXPECT_TRUE(h.platform.unsaved_shown);
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  ASSERT_TRUE(h.platform.files.contains("/kept/hero.artisketch"));
  EXPECT_FALSE(h.editor().unsaved());
  EXPECT_FALSE(h.platform.unsaved_shown);
  h.platform.files.clear();
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.editor().unsaved()) << "undone is another state than the saved one";
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.platform.files.contains("/kept/hero.artisketch"));
}

TEST_F(Files, WhatWasSavedOpensAsItWas) {
  edit();
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  const std::string saved = h.platform.files["/kept/hero.artisketch"];
  Harness other;
  other.open("hero.artisketch", saved);
  EXPECT_EQ(other.document().frames.size(), 3u);
  EXPECT_TRUE(outlines(other, "hand.R").empty());
  EXPECT_FALSE(other.editor().unsaved());
  EXPECT_NE(saved.find("data:image/png"), std::string::npos) << "drawings go along";
}

// Half done as it is: the editor shows where it crosses, and mends it.
TEST_F(Files, AnOutlineThatCrossesItselfIsSavedAndOpened) {
  h.key(ImGuiKey_D);
  std::vector<Vec2> eight;
  for (int i = 0; i <= 64; ++i) {
    const double a = 2 * M_PI * i / 64 + 0.3;
    eight.push_back(h.on_screen(250, 330) + 60 * Vec2(std::sin(a), std::sin(2 * a) / 1.5));
  }
  h.draw(eight);
  h.key(ImGuiKey_Enter);
  ASSERT_TRUE(h.enabled("Mend"));
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  Harness other;
  other.open("hero.artisketch", h.platform.files["/kept/hero.artisketch"]);
  EXPECT_EQ(other.said(), "");
  ASSERT_EQ(other.document().frames.size(), 3u);
  EXPECT_EQ(contours(other).size(), was.frames[0].contours.size() + 1);
}

TEST(FilesAlone, ADocumentWithoutDrawingsIsSavedAndOpened) {
  Harness h;
  h.start_over();
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  ASSERT_EQ(h.platform.files.size(), 1u);
  Harness other;
  other.open("untitled.artisketch", h.platform.files.begin()->second);
  EXPECT_EQ(other.said(), "");
  EXPECT_EQ(other.state().mode, "outline");
  EXPECT_EQ(other.document().skeleton.size(), h.document().skeleton.size());
}

TEST_F(Files, SaveAsKeepsBoth) {
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  h.platform.files["/kept/hero.artisketch"] = "the old one";
  h.platform.dialogs = false;
  h.key(ImGuiKey_S, ImGuiMod_Ctrl | ImGuiMod_Shift);
  ASSERT_NE(h.find("Path"), nullptr);
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("/tmp/other.artisketch");
  h.click("Save");
  EXPECT_TRUE(h.platform.files.contains("/tmp/other.artisketch"));
  EXPECT_EQ(h.platform.files["/kept/hero.artisketch"], "the old one");
}

TEST_F(Files, WhatCantBeSavedStaysUnsaved) {
  edit();
  h.platform.no_saving = io_error("the disk is full");
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.says("the disk is full"));
  EXPECT_TRUE(h.editor().unsaved());
}

TEST(FilesAlone, TheWelcomeHasNothingToSave) {
  Harness h;
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  h.key(ImGuiKey_S, ImGuiMod_Ctrl | ImGuiMod_Shift);
  EXPECT_TRUE(h.platform.files.empty());
}

// ---------------------------------------------------------------- unsaved work

TEST_F(Files, NewAsksAboutUnsavedWork) {
  edit();
  begin();
  h.key(ImGuiKey_N, ImGuiMod_Ctrl);
  ASSERT_NE(h.find("Don't save"), nullptr);
  h.click("Cancel");
  expect_nothing_happened();
  h.key(ImGuiKey_N, ImGuiMod_Ctrl);
  h.key(ImGuiKey_Escape);
  expect_nothing_happened();
  h.key(ImGuiKey_N, ImGuiMod_Ctrl);
  h.click("Save");
  EXPECT_TRUE(h.platform.files.contains("/kept/hero.artisketch"));
  EXPECT_TRUE(h.document().frames.empty());
  EXPECT_FALSE(h.state().can_undo);
}

TEST_F(Files, DontSaveLosesItAsAsked) {
  edit();
  h.key(ImGuiKey_N, ImGuiMod_Ctrl);
  h.click("Don't save");
  EXPECT_TRUE(h.platform.files.empty());
  EXPECT_TRUE(h.document().frames.empty());
}

TEST_F(Files, WhileAQuestionStandsNothingElseIsDone) {
  edit();
  begin();
  h.key(ImGuiKey_N, ImGuiMod_Ctrl);
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  h.key(ImGuiKey_3);
  expect_nothing_happened();
  EXPECT_EQ(h.state().mode, "outline");
}

TEST_F(Files, ClosingAsksToo) {
  EXPECT_TRUE(h.editor().close()) << "nothing would be lost";
  Harness other;
  other.open_example("hero");
  other.click("Hand R in 1");
  other.key(ImGuiKey_Delete);
  EXPECT_FALSE(other.editor().close());
  other.frame();
  other.click("Cancel");
  EXPECT_FALSE(other.editor().closed());
  EXPECT_FALSE(other.editor().close());
  other.frame();
  other.click("Don't save");
  EXPECT_TRUE(other.editor().closed());
}

// ---------------------------------------------------------------- opening

TEST_F(Files, OpenAsksTheDialog) {
  h.platform.to_open.push_back(
      std::vector<NamedBytes>{{"circles.artisketch", example_document("circles"), "/a/circles"}});
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  EXPECT_EQ(h.platform.asked, std::vector<Platform::Kind>{Platform::Kind::document});
  EXPECT_EQ(h.document().name, "circles");
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.platform.files.contains("/a/circles")) << "it goes back where it came from";
}

TEST_F(Files, OpenAsksOnceAboutUnsavedWorkAndOnlyForADocument) {
  edit();
  begin();
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);  // and the dialog is cancelled
  expect_nothing_happened();
  h.platform.to_open.push_back(
      std::vector<NamedBytes>{{"circles.artisketch", example_document("circles"), "/a/circles"}});
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  h.click("Don't save");
  EXPECT_EQ(h.find("Don't save"), nullptr);
  EXPECT_EQ(h.document().name, "circles");
}

TEST_F(Files, ACancelledDialogChangesNothing) {
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  expect_nothing_happened();
}

TEST_F(Files, WithoutDialogsThePathIsTyped) {
  h.platform.dialogs = false;
  h.platform.files["/a/circles.artisketch"] = example_document("circles");
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  h.frames(3);
  h.type("/a/circles.artisketch");
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(h.document().name, "circles");
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  h.frames(3);
  h.type("/a/none");
  h.click("Open");
  EXPECT_TRUE(h.says("There is no /a/none"));
}

TEST_F(Files, RecentOnesAreInTheMenu) {
  h.platform.files["/a/circles.artisketch"] = example_document("circles");
  h.platform.recent = {{"circles", "/a/circles.artisketch"}};
  h.click("Menu");
  h.click("Menu circles");
  EXPECT_EQ(h.document().name, "circles");
}

TEST_F(Files, WhatIsNoDocumentIsSaidAndLeavesTheOldOne) {
  h.open("broken.artisketch", "{\"artisketch\": 1, \"skeleton\": 3}");
  EXPECT_FALSE(h.said().empty());
  h.open("noise.png", "no picture at all");
  EXPECT_TRUE(h.says("noise.png"));
  expect_nothing_happened();
}

TEST_F(Files, AnErrorOfThePlatformIsSaid) {
  h.editor().open(io_error("the tablet was pulled out"));
  h.frame();
  EXPECT_TRUE(h.says("the tablet was pulled out"));
  h.editor().open(Error{Error::Kind::cancelled, {"never mind"}});
  h.frame();
  EXPECT_FALSE(h.says("never mind"));
}

TEST(FilesAlone, AnExampleWithoutAModelIsReconstructed) {
  Harness h({"circles", "heart"});
  h.platform.with_models = false;
  h.click("Example Heart");
  h.settle();
  EXPECT_EQ(h.document().name, "heart");
  EXPECT_TRUE(h.state().has_model);
}

TEST(FilesAlone, AnExampleComesWithItsModel) {
  Harness h({"circles", "heart"});
  h.click("Example Heart");
  EXPECT_EQ(h.document().name, "heart");
  EXPECT_TRUE(h.state().has_model);
  EXPECT_EQ(h.state().mode, "outline");
}

TEST(FilesAlone, AnExampleThatIsMissingIsSaid) {
  Harness h({"circles", "heart"});
  h.platform.no_example = io_error("no connection");
  h.click("Example Heart");
  EXPECT_TRUE(h.says("no connection"));
}

// ---------------------------------------------------------------- drawings

TEST(FilesAlone, ADroppedDrawingBeginsADocument) {
  Harness h;
  h.open("ann.png", drawn());
  EXPECT_EQ(h.state().frames, 1);
  EXPECT_EQ(h.document().frames[0].name, "ann");
  EXPECT_EQ(h.document().frames[0].width, 120);
  EXPECT_EQ(h.state().undo, "Add ann");
  EXPECT_TRUE(h.says("A person's skeleton lies over the drawing."));
  // As tall as the figure.
  const double head = h.middle("Sketch").y() * 0;
  (void)head;
  h.click("Choose another");
  EXPECT_EQ(h.state().mode, "skeleton");
}

TEST_F(Files, AddDrawingsPutsThemAtTheEnd) {
  h.platform.to_open.push_back(std::vector<NamedBytes>{{"back.png", drawn(), ""}});
  h.click("Add drawing");
  EXPECT_EQ(h.platform.asked.back(), Platform::Kind::drawings);
  EXPECT_EQ(h.state().frames, 4);
  EXPECT_EQ(h.state().frame, 3);
  expect_step("Add back");
}

TEST_F(Files, AmongSeveralThatComeTheFirstIsShown) {
  h.platform.to_open.push_back(
      std::vector<NamedBytes>{{"left.png", drawn(), ""}, {"back.png", drawn(), ""}});
  h.click("Add drawing");
  EXPECT_EQ(h.state().frames, 5);
  EXPECT_EQ(h.state().frame, 3);
}

TEST_F(Files, WithoutDialogsADrawingsPathIsTyped) {
  h.platform.dialogs = false;
  h.platform.files["/a/back.png"] = drawn();
  h.click("Add drawing");
  h.frames(3);
  h.type("/a/back.png");
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(h.state().frames, 4);
}

TEST(FilesAlone, ASheetIsCutUpOrTakenWhole) {
  for (const bool cut : {true, false}) {
    Harness h;
    h.open("sheet.png", drawn(3));
    ASSERT_NE(h.find("Cut it up"), nullptr);
    h.click(cut ? "Cut it up" : "One drawing");
    EXPECT_EQ(h.state().frames, cut ? 3 : 1);
    EXPECT_EQ(h.state().undo, cut ? "Add 3 drawings" : "Add sheet");
  }
}

TEST(FilesAlone, ASheetIsCutAsThePersonSays) {
  Harness h;
  h.open("sheet.png", drawn(4));
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("2 x 1");
  h.key(ImGuiKey_Enter);
  EXPECT_EQ(h.state().frames, 2);
  EXPECT_EQ(h.document().frames[0].width, 240);
  h.open("sheet.png", drawn(4));
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("many");
  h.key(ImGuiKey_Enter);
  EXPECT_TRUE(h.says("say 4 × 2"));
  EXPECT_EQ(h.state().frames, 2);
}

TEST_F(Files, BlankPaperIsAsLargeAsTheOthers) {
  h.click("Menu");
  h.click("Menu Blank paper");
  EXPECT_EQ(h.state().frames, 4);
  EXPECT_EQ(h.document().frames[3].width, h.document().frames[0].width);
  EXPECT_TRUE(h.active("Draw tool"));
  expect_step("Add Drawing 4");
}

// ---------------------------------------------------------------- the strip

TEST_F(Files, ADrawingIsRenamed) {
  h.right_click("Drawing card 2");
  h.click("Rename drawing");
  h.frames(2);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("running");
  h.click("Rename");
  h.frames(2);
  EXPECT_EQ(h.document().frames[1].name, "running");
  expect_step("Rename drawing");
}

// Where the skeleton's joints stand in a drawing.
std::vector<Vec2> joints_drawn(const Document& document, int frame) {
  std::vector<Vec2> pixels;
  for (const Transform& joint :
       posed_joints(document.skeleton, document.frames[std::size_t(frame)].pose))
    pixels.push_back(frame_camera(document, frame).project(joint.translation()));
  return pixels;
}

TEST_F(Files, ADrawingIsTurnedFlippedAndCroppedWithAllThatLiesOnIt) {
  const Document before = h.document();
  const Frame& was = before.frames[1];
  const auto picture = [&] {
    h.key(ImGuiKey_S, ImGuiMod_Ctrl);
    const std::string& saved = h.platform.files["/kept/hero.artisketch"];
    return *load_frame_image(parse_document(saved, "saved")->frames[1], "saved");
  };
  const Image old = picture();
  const std::vector<Vec2> joints = joints_drawn(before, 1);
  constexpr double kRead = 1e-3;  // pixels: a file's rotations are of unit length to six digits
  const auto expect_moved = [&](const char* undo, const auto& map, bool sides_change) {
    const Document& now = h.document();
    const std::vector<Vec2> moved = joints_drawn(now, 1);
    for (std::size_t c = 0; c < was.contours.size(); ++c) {
      const Contour &a = was.contours[c], &b = now.frames[1].contours[c];
      const int mirror = before.skeleton.joints[std::size_t(a.joint)].mirror;
      EXPECT_EQ(b.joint, sides_change && mirror >= 0 ? mirror : a.joint);
      EXPECT_LT((b.line.points[0] - map(a.line.points[0])).norm(), 1e-9) << undo;
    }
    for (std::size_t j = 0; j < joints.size() && !sides_change; ++j)
      EXPECT_LT((moved[j] - map(joints[j])).norm(), kRead) << undo << " " << j;
    // The pixels that were there lie where they went.
    const Image image = picture();
    EXPECT_EQ(image.width, now.frames[1].width);
    EXPECT_EQ(image.height, now.frames[1].height);
    for (int y = 300; y < 500; y += 20)
      for (int x = 240; x < 400; x += 20) {
        const Vec2 to = map(Vec2(x + 0.5, y + 0.5));
        for (int k = 0; k < 4; ++k)
          EXPECT_EQ(old.at(x, y)[k], image.at(int(to.x()), int(to.y()))[k]) << undo;
      }
    expect_step(undo);
    h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
    EXPECT_EQ(h.document().frames[1].image, was.image);
  };
  const double w = was.width, height = was.height;
  h.right_click("Drawing card 2");
  h.click("Turn right");
  expect_moved(
      "Turn drawing", [&](const Vec2& p) { return Vec2(height - p.y(), p.x()); }, false);
  h.right_click("Drawing card 2");
  h.click("Turn left");
  expect_moved(
      "Turn drawing", [&](const Vec2& p) { return Vec2(p.y(), w - p.x()); }, false);
  h.right_click("Drawing card 2");
  h.click("Flip left to right");
  expect_moved(
      "Flip drawing", [&](const Vec2& p) { return Vec2(w - p.x(), p.y()); }, true);
  h.right_click("Drawing card 2");
  h.click("Crop to the figure");
  const Vec2 by =
      was.contours[0].line.points[0] - h.document().frames[1].contours[0].line.points[0];
  EXPECT_LT(h.document().frames[1].width, was.width);
  EXPECT_LE(h.document().frames[1].height, was.height);
  expect_moved(
      "Crop drawing", [&](const Vec2& p) { return Vec2(p - by); }, false);
  // What is cropped has nothing to cut away.
  h.key(ImGuiKey_Y, ImGuiMod_Ctrl);
  const Document cropped = h.document();
  h.right_click("Drawing card 2");
  h.click("Crop to the figure");
  EXPECT_EQ(h.document().frames[1].width, cropped.frames[1].width);
  EXPECT_NE(h.said().find("fills its drawing"), std::string::npos);
}

TEST_F(Files, APictureIsReplacedUnderItsOutlines) {
  const Document before = h.document();
  const Frame& was = before.frames[1];
  Image other(was.width, was.height);
  h.platform.to_open.push_back(std::vector<NamedBytes>{{"again.png", png_bytes(other), ""}});
  h.right_click("Drawing card 2");
  h.click("Replace picture");
  h.frames(2);
  EXPECT_NE(h.document().frames[1].image, was.image);
  EXPECT_EQ(h.document().frames[1].contours.size(), was.contours.size());
  EXPECT_TRUE(same_pose(h.document().frames[1].pose, was.pose));
  expect_step("Replace picture");
  begin();
  // Twice as fine: the same place for all that lies on it.
  const std::vector<Vec2> joints = joints_drawn(h.document(), 1);
  const double scale = h.document().camera.type == Camera::Type::orthographic ? 2 : 1;
  h.platform.to_open.push_back(
      std::vector<NamedBytes>{{"finer.png", png_bytes(Image(2 * was.width, 2 * was.height)), ""}});
  h.right_click("Drawing card 2");
  h.click("Replace picture");
  h.frames(2);
  EXPECT_EQ(h.document().frames[1].width, int(scale * was.width));
  EXPECT_LT((joints_drawn(h.document(), 1)[3] - scale * joints[3]).norm(), 1e-6);
  begin();
  // Another shape is another drawing.
  const std::string finer = h.document().frames[1].image;
  h.platform.to_open.push_back(
      std::vector<NamedBytes>{{"wide.png", png_bytes(Image(900, 300)), ""}});
  h.right_click("Drawing card 2");
  h.click("Replace picture");
  h.frames(2);
  EXPECT_EQ(h.document().frames[1].image, finer);
  EXPECT_NE(h.said().find("900 × 300"), std::string::npos) << h.said();
}

TEST_F(Files, TheStripsMenuCopiesMovesAndRemoves) {
  h.right_click("Drawing card 1");
  h.click("Duplicate drawing");
  EXPECT_EQ(h.state().frames, 4);
  EXPECT_EQ(h.state().frame, 1);
  expect_step("Duplicate drawing");
  begin();
  h.right_click("Drawing card 2");
  h.click("Move right");
  EXPECT_EQ(h.state().frame, 2);
  expect_step("Move drawing");
  begin();
  h.right_click("Drawing card 3");
  h.click("Move left");
  expect_step("Move drawing");
  begin();
  h.right_click("Drawing card 2");
  h.click("Remove drawing");
  EXPECT_EQ(h.state().frames, 3);
  expect_step("Remove drawing");
}

TEST_F(Files, ACardIsDraggedToItsPlace) {
  const Vec2 first = h.middle("Drawing card 1"), second = h.middle("Drawing card 2");
  h.drag(first, {1.1 * (second.x() - first.x()), 0}, 12);
  EXPECT_EQ(h.document().frames[1].name, was.frames[0].name);
  EXPECT_EQ(h.state().frame, 1);
  expect_step("Move drawing");
}

TEST_F(Files, TheCameraIsOneForAll) {
  h.click("Perspective");
  EXPECT_EQ(h.document().camera.type, Camera::Type::orthographic);
  expect_step("Orthographic camera");
  h.click("Orthographic");
  EXPECT_EQ(h.document().camera.type, Camera::Type::perspective);
}

// ---------------------------------------------------------------- for a crash

TEST_F(Files, WorkIsKeptSoonAfterAChange) {
  EXPECT_FALSE(h.platform.kept.contains("autosave"));
  edit();
  h.wait(2);
  ASSERT_TRUE(h.platform.kept.contains("autosave"));
  h.key(ImGuiKey_S, ImGuiMod_Ctrl);
  EXPECT_FALSE(h.platform.kept.contains("autosave"));
}

TEST_F(Files, WorkIsKeptWhileChangesGoOn) {
  edit();
  h.click("Hand L in 1");
  for (int i = 0; i < 16; ++i) {
    h.key(i % 2 ? ImGuiKey_RightBracket : ImGuiKey_LeftBracket);
    h.wait(0.2);
  }
  EXPECT_TRUE(h.platform.kept.contains("autosave"));
}

TEST(FilesAlone, WhatACrashLeftIsOffered) {
  Harness first;
  first.open_example("hero");
  first.click("Hand R in 1");
  first.key(ImGuiKey_Delete);
  first.wait(2);
  const std::string left = first.platform.kept["autosave"];
  ASSERT_FALSE(left.empty());
  for (const bool keep : {true, false}) {
    Harness next({}, {{"left", left}});
    EXPECT_TRUE(next.says("Work from last time was not saved."));
    // Until that is answered, other work is kept elsewhere.
    next.open_example("heart");
    next.click("Heart in 1");
    next.key(ImGuiKey_Delete);
    next.wait(2);
    ASSERT_TRUE(next.platform.kept.contains("autosave"));
    EXPECT_NE(next.platform.kept["autosave"], left);
    EXPECT_EQ(next.platform.kept["left"], left);
    next.click(keep ? "Keep" : "Discard");
    EXPECT_EQ(next.document().frames.size(), keep ? 3u : 2u);
    EXPECT_TRUE(next.editor().unsaved());
    EXPECT_FALSE(next.platform.kept.contains("left"));
    EXPECT_EQ(next.platform.kept["autosave"] == left, keep);
  }
}

}  // namespace
}  // namespace artisketch

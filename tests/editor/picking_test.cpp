// Figures picked on a sheet, and a drawing cropped, by hand.
#include <gtest/gtest.h>

#include "document/sprite_sheet.h"
#include "editor/step.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

void fill(Image& image, int x0, int y0, int width, int height, std::uint8_t grey) {
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x)
      for (int c = 0; c < 3; ++c) image.rgba[4 * std::size_t(y * image.width + x) + c] = grey;
}

Image white_sheet(int width, int height) {
  Image image(width, height);
  for (std::uint8_t& byte : image.rgba) byte = 255;
  return image;
}

// A title of letters, three figures, and below them two more, the second of another width.
Image titled_sheet() {
  Image image = white_sheet(480, 400);
  for (int letter = 0; letter < 9; ++letter) fill(image, 40 + 22 * letter, 12, 12, 16, 20);
  for (int column = 0; column < 3; ++column) fill(image, 40 + 140 * column, 60, 70, 130, 90);
  fill(image, 60, 230, 70, 130, 140);
  fill(image, 220, 230, 110, 130, 140);
  return image;
}

// The place in the window of a pixel of the sheet, told by a figure's frame.
Vec2 on_sheet(const Harness& h, const std::string& figure, const PixelBox& box, const Vec2& pixel) {
  const Widget& w = h.widget(figure);
  const double zoom = double(w.width) / box.width;
  return Vec2(w.x, w.y) + zoom * (pixel - Vec2(box.x, box.y));
}

TEST(Picking, ASheetWithATitleAndUnevenRowsIsCut) {
  Harness h;
  h.open("walk.png", png_bytes(titled_sheet()));
  for (const char* figure : {"Figure A1", "Figure A2", "Figure A3", "Figure B1", "Figure B2"})
    EXPECT_TRUE(h.active(figure)) << figure;
  EXPECT_EQ(h.find("Figure B3"), nullptr);
  h.click("Cut it up");
  ASSERT_EQ(h.state().frames, 5);
  EXPECT_EQ(h.document().frames[0].name, "walk A1") << "named by file and cell";
  EXPECT_EQ(h.document().frames[4].name, "walk B2");
  EXPECT_EQ(h.state().undo, "Add 5 drawings");
}

TEST(Picking, AClickLeavesAFigureOutAndADragAddsOne) {
  Harness h;
  h.open("walk.png", png_bytes(titled_sheet()));
  h.click("Figure A2");
  EXPECT_FALSE(h.active("Figure A2"));
  h.click("Figure B1");
  h.click("Figure B1");
  EXPECT_TRUE(h.active("Figure B1"));
  // The title, by hand.
  const PixelBox first{40, 60, 70, 130};
  const Vec2 from = on_sheet(h, "Figure A1", first, {36, 8});
  const Vec2 to = on_sheet(h, "Figure A1", first, {236, 32});
  h.drag(from, to - from);
  ASSERT_NE(h.find("Figure C2"), nullptr) << "a row of its own, above the others";
  EXPECT_TRUE(h.active("Figure A1"));
  h.click("Cut it up");
  ASSERT_EQ(h.state().frames, 5);
  EXPECT_EQ(h.document().frames[0].name, "walk A1");
  EXPECT_NEAR(h.document().frames[0].width, 200, 3);
  EXPECT_NEAR(h.document().frames[0].height, 24, 3);
  EXPECT_EQ(h.document().frames[2].name, "walk B3") << "B2 was left out";
}

TEST(Picking, ATypedGridShowsAtOnce) {
  Harness h;
  h.open("walk.png", png_bytes(titled_sheet()));
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("4 x 2");
  EXPECT_NE(h.find("Figure B4"), nullptr);
  h.click("Figure A4");
  h.click("Cut it up");
  EXPECT_EQ(h.state().frames, 7);
  EXPECT_EQ(h.document().frames[0].width, 120);
}

TEST(Picking, EscapeAddsNothingAndEachSheetIsAskedAbout) {
  Harness h;
  h.open("walk.png", png_bytes(titled_sheet()));
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Cut it up"), nullptr);
  EXPECT_EQ(h.state().frames, 0);
  h.open("walk.png", png_bytes(titled_sheet()));
  h.open("run.png", png_bytes(titled_sheet()));
  h.click("Cut it up");
  EXPECT_EQ(h.state().frames, 5);
  h.click("One drawing");
  EXPECT_EQ(h.state().frames, 6);
  EXPECT_EQ(h.document().frames[5].name, "run");
}

TEST(Picking, ADrawingThatIsASheetIsCutLater) {
  Harness h;
  // Figures that touch: no gap tells them.
  Image image = white_sheet(300, 160);
  fill(image, 20, 20, 260, 120, 60);
  h.open("strip.png", png_bytes(image));
  ASSERT_EQ(h.state().frames, 1);
  const std::string before = text(h);
  h.right_click("Drawing card 1");
  h.click("Cut into drawings");
  EXPECT_FALSE(h.enabled("Cut it up")) << "nothing is picked yet";
  h.frames(3);
  h.type("2 x 1");
  h.click("Cut it up");
  EXPECT_EQ(h.state().frames, 2);
  EXPECT_EQ(h.document().frames[1].name, "Strip 2");
  EXPECT_EQ(h.state().undo, "Cut up Strip");
  h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
  EXPECT_EQ(text(h), before);
}

class Cropping : public WithDocument {};

TEST_F(Cropping, ABoxDrawnByHandKeepsOutlinesAndPoseInPlace) {
  const Frame& frame = was.frames[0];
  h.right_click("Drawing card 1");
  h.click("Crop by hand");
  EXPECT_FALSE(h.enabled("Crop to the box"));
  const Widget& ground = h.widget("Picture to pick on");
  const Vec2 middle(ground.x + ground.width / 2, ground.y + ground.height / 2);
  h.drag(middle + Vec2(-60, -50), {40, 20});
  h.drag(middle + Vec2(-90, -120), {200, 230});  // another: the first goes
  ASSERT_TRUE(h.enabled("Crop to the box"));
  h.click("Crop to the box");
  const Frame& cropped = h.document().frames[0];
  EXPECT_LT(cropped.width, frame.width);
  EXPECT_NEAR(double(cropped.width) / cropped.height, 200.0 / 230, 0.02);
  ASSERT_EQ(cropped.contours.size(), frame.contours.size());
  const Vec2 by = frame.contours[0].line.points[0] - cropped.contours[0].line.points[0];
  EXPECT_GT(by.norm(), 1);
  for (std::size_t c = 0; c < frame.contours.size(); ++c)
    EXPECT_TRUE(
        cropped.contours[c].line.points.back().isApprox(frame.contours[c].line.points.back() - by));
  EXPECT_TRUE(same_pose(cropped.pose, frame.pose));
  EXPECT_LT((frame_camera(h.document(), 0).project(Vec3::Zero()) + by -
             frame_camera(was, 0).project(Vec3::Zero()))
                .norm(),
            1e-6);
  expect_step("Crop drawing");
}

}  // namespace
}  // namespace artisketch

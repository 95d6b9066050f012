// What stands where on screens of every size: nothing lies on a control, no words are cut short.
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "editor/harness.h"
#include "editor/reading.h"
#include "editor/ui/ui.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

struct Screen {
  const char* name;
  Harness::Size size;
};

struct Manner {
  const char *name, *language, *theme;
  float pixel_ratio;
};

// All that come with the program.
const std::vector<std::string> kExamples = {"hero",   "fox",         "robot",  "heart",   "circles",
                                            "alien",  "ballerina",   "bear",   "climber", "gnome",
                                            "horse",  "horse-three", "knight", "legs",    "monster",
                                            "parrot", "prince"};

class Screens : public testing::TestWithParam<std::tuple<Screen, Manner>> {
 protected:
  Screens()
      : h(kExamples, {{"language", manner().language}, {"theme", manner().theme}},
          std::get<Screen>(GetParam()).size) {
    h.pixel_ratio = manner().pixel_ratio;
  }
  static const Manner& manner() { return std::get<Manner>(GetParam()); }
  Harness h;
};

bool begins(const std::string& label, std::initializer_list<const char*> words) {
  for (const char* word : words)
    if (label.rfind(word, 0) == 0) return true;
  return false;
}

// What lies over a drawing goes with it, and edges are taken where panels meet.
bool may_be_covered(const Widget& widget) {
  constexpr float kGround = 15'000;  // a canvas, a model; square points
  return widget.width * widget.height > kGround ||
         widget.label.find(" edge") != std::string::npos ||
         widget.label.find("from the side") != std::string::npos ||
         begins(widget.label, {"Joint ", "Point ", "Parts sheet", "Key ", "Clip "});
}

float common(float a, float a_size, float b, float b_size) {
  return std::min(a + a_size, b + b_size) - std::max(a, b);
}

// from: the first control of the sheet that lies over all else.
void expect_clear(Harness& h, const std::string& where, const std::string& from = "") {
  std::vector<Widget> all = h.editor().widgets();
  if (!from.empty())
    all.erase(all.begin(), std::find_if(all.begin(), all.end(), [&](const Widget& widget) {
                return widget.label == from;
              }));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Widget& a = all[i];
    if (a.width <= 0 || a.height <= 0) continue;  // scrolled away
    EXPECT_GE(a.x, -1) << where << ": " << a.label;
    EXPECT_LE(a.x + a.width, h.size.width + 1) << where << ": " << a.label;
    EXPECT_LE(a.y + a.height, h.size.height + 1) << where << ": " << a.label;
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const Widget& b = all[k];
      if (may_be_covered(a) || may_be_covered(b)) continue;
      EXPECT_FALSE(common(a.x, a.width, b.x, b.width) > 1 &&
                   common(a.y, a.height, b.y, b.height) > 1)
          << where << ": " << a.label << " and " << b.label;
    }
  }
  EXPECT_EQ(words_cut_short(), std::vector<std::string>{}) << where;
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, Screens,
    testing::Combine(testing::Values(Screen{"desktop", {1440, 900}}, Screen{"laptop", {1280, 720}},
                                     Screen{"small", {1024, 768}}, Screen{"zoomed", {960, 600}},
                                     Screen{"tablet", {820, 1180}}, Screen{"phone", {390, 844}}),
                     testing::Values(Manner{"English", "en", "dark", 1},
                                     Manner{"LightEnglish", "en", "light", 2},
                                     Manner{"German", "de", "light", 1},
                                     Manner{"DarkGerman", "de", "dark", 2},
                                     Manner{"Spanish", "es", "dark", 1})),
    [](const auto& info) {
      return std::string(std::get<Screen>(info.param).name) + std::get<Manner>(info.param).name;
    });

TEST_P(Screens, TheFirstScreenHoldsItsWordsAndControls) {
  h.settle();
  expect_clear(h, "welcome");
}

TEST_P(Screens, TheGalleryHoldsItsWordsAndControls) {
  h.settle();
  h.click("Gallery");
  h.frames(2);
  expect_clear(h, "gallery");
}

TEST_P(Screens, EachModeHoldsItsWordsAndControls) {
  h.open_example("hero");
  h.settle();
  for (const ImGuiKey key : {ImGuiKey_1, ImGuiKey_2, ImGuiKey_3, ImGuiKey_4}) {
    h.key(key);
    h.settle();
    expect_clear(h, h.state().mode);
  }
}

TEST_P(Screens, TheExportSheetHoldsItsWordsAndControls) {
  h.open_example("hero");
  h.settle();
  h.key(ImGuiKey_R);
  h.settle();
  h.key(ImGuiKey_4);
  h.key(ImGuiKey_O);  // without the model's joints
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.wait(10);  // until nothing more is said
  for (const char* format : {"GLB", "VRM", "PNG", "Sprites"}) {
    h.click(std::string("Format ") + format);
    h.frames(2);
    expect_clear(h, std::string("export, ") + format);
  }
}

// Three figures in a row, and a title over them.
Image sheet_of_figures() {
  Image image;
  image.width = 480, image.height = 240;
  image.rgba.assign(std::size_t(image.width * image.height) * 4, 255);
  const auto fill = [&](int x, int y, int width, int height) {
    for (int row = y; row < y + height; ++row)
      for (int column = x; column < x + width; ++column)
        for (int c = 0; c < 3; ++c)
          image.rgba[std::size_t(row * image.width + column) * 4 + std::size_t(c)] = 60;
  };
  for (int letter = 0; letter < 9; ++letter) fill(40 + 22 * letter, 12, 12, 16);
  for (int column = 0; column < 3; ++column) fill(40 + 140 * column, 70, 70, 130);
  return image;
}

TEST_P(Screens, TheSheetsOfFiguresAndOfTheCropHoldTheirWordsAndControls) {
  h.open("walk.png", png_bytes(sheet_of_figures()));
  h.frames(3);
  ASSERT_NE(h.find("Figure 1"), nullptr);
  expect_clear(h, "figures on a sheet", "Close picking");
  h.click("Figure 2");
  h.frames(2);
  expect_clear(h, "a figure left out", "Close picking");
  h.key(ImGuiKey_Escape);
  h.open_example("hero");
  h.settle();
  h.key(ImGuiKey_Escape);  // the hints
  h.right_click("Drawing card 1");
  h.click("Crop by hand");
  h.frames(3);
  ASSERT_NE(h.find("Crop to the box"), nullptr);
  expect_clear(h, "the crop", "Close picking");
}

TEST_P(Screens, TheMotionsHoldTheirWordsAndControls) {
  h.open_example("hero");
  h.settle();
  h.key(ImGuiKey_R);
  h.settle();
  h.key(ImGuiKey_4);
  h.key(ImGuiKey_O);        // without the model's joints
  if (h.find("Library")) {  // not on phones
    h.click("Library");
    h.frames(2);
    h.click("Add walk");
  }
  h.wait(10);  // until nothing more is said
  expect_clear(h, "a clip");
  h.open("hello.bvh", waving());
  h.click("Change");  // of what it says that moves what
  h.frames(3);
  ASSERT_NE(h.find("In place"), nullptr);
  expect_clear(h, "what a motion moves");
}

}  // namespace
}  // namespace artisketch

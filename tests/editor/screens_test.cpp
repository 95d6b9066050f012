// What stands where on screens of every size: nothing lies on a control, no words are cut short.
#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

#include "editor/harness.h"
#include "editor/ui/ui.h"

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

class Screens : public testing::TestWithParam<std::tuple<Screen, Manner>> {
 protected:
  Screens()
      : h({"hero"}, {{"language", manner().language}, {"theme", manner().theme}},
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
         begins(widget.label, {"Joint ", "Point ", "Parts sheet"});
}

float common(float a, float a_size, float b, float b_size) {
  return std::min(a + a_size, b + b_size) - std::max(a, b);
}

void expect_clear(Harness& h, const std::string& where) {
  const std::vector<Widget> all = h.editor().widgets();
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

}  // namespace
}  // namespace artisketch

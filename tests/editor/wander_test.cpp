// Whoever presses whatever comes to hand, in whatever order, breaks nothing: what is drawn can be
// drawn (the harness looks each frame), the document can be saved and opened, and undo and redo
// lead back to where they were.
#include <gtest/gtest.h>

#include "editor/reading.h"
#include "figures/random.h"

namespace artisketch {
namespace {

constexpr ImGuiKey kKeys[] = {ImGuiKey_A,           ImGuiKey_B,
                              ImGuiKey_C,           ImGuiKey_D,
                              ImGuiKey_F,           ImGuiKey_G,
                              ImGuiKey_H,           ImGuiKey_I,
                              ImGuiKey_J,           ImGuiKey_K,
                              ImGuiKey_L,           ImGuiKey_M,
                              ImGuiKey_O,           ImGuiKey_P,
                              ImGuiKey_R,           ImGuiKey_S,
                              ImGuiKey_T,           ImGuiKey_V,
                              ImGuiKey_W,           ImGuiKey_X,
                              ImGuiKey_0,           ImGuiKey_1,
                              ImGuiKey_2,           ImGuiKey_3,
                              ImGuiKey_4,           ImGuiKey_Comma,
                              ImGuiKey_Period,      ImGuiKey_Slash,
                              ImGuiKey_LeftBracket, ImGuiKey_RightBracket,
                              ImGuiKey_Backspace,   ImGuiKey_Delete,
                              ImGuiKey_Enter,       ImGuiKey_Tab,
                              ImGuiKey_Escape,      ImGuiKey_Space,
                              ImGuiKey_Home,        ImGuiKey_F2,
                              ImGuiKey_Equal,       ImGuiKey_Minus,
                              ImGuiKey_LeftArrow,   ImGuiKey_DownArrow,
                              ImGuiKey_E,           ImGuiKey_Z};

// What a saved document holds is read again, the same.
void expect_sound(const Harness& h) {
  static std::string sound;  // the last that was
  const std::string written = text(h);
  if (written == sound) return;
  const Result<Document> read = parse_document(written, "what was wandered to");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(document_text(*read) == written);
  sound = written;
}

// All the way back, and all the way on again.
void expect_undo_leads_back(Harness& h) {
  h.key(ImGuiKey_Escape);
  h.key(ImGuiKey_Escape);
  h.key(ImGuiKey_Escape);
  if (h.state().mode == "welcome") return;
  const std::string here = text(h);
  int steps = 0;
  for (; h.state().can_undo; ++steps) {
    const std::string before = text(h);
    h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
    if (text(h) == before && h.state().can_undo && steps > 2000) FAIL() << "undo does not end";
  }
  for (int i = 0; i < steps; ++i) h.key(ImGuiKey_Z, ImGuiMod_Ctrl | ImGuiMod_Shift);
  EXPECT_TRUE(text(h) == here) << "redone it is another";
}

struct Way {
  std::string example;
  int seed;
  Harness::Size size;
};

class Wander : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(Ways, Wander,
                         testing::Values(Way{"circles", 1, {1440, 900}},
                                         Way{"circles", 2, {820, 1180}},
                                         Way{"heart", 3, {1280, 720}}, Way{"hero", 4, {1440, 900}}),
                         [](const auto& info) {
                           return info.param.example + std::to_string(info.param.seed);
                         });

TEST_P(Wander, AnywhereIsSafe) {
  Harness h({}, {}, GetParam().size);
  h.open_example(GetParam().example);
  figures::Random random(std::uint64_t(GetParam().seed));
  const auto below = [&](std::size_t n) {
    return std::min(n - 1, std::size_t(random.between(0, double(n))));
  };
  const auto somewhere = [&] {
    const Widget* sketch = h.find("Sketch");
    if (!sketch || random.chance(0.3))
      return Vec2(random.between(0, h.size.width), random.between(0, h.size.height));
    return Vec2(sketch->x + random.between(0, sketch->width),
                sketch->y + random.between(0, sketch->height));
  };
  std::string trail;
  for (int step = 0; step < 120; ++step) {
    const double what = random.uniform();
    if (what < 0.35) {
      const std::vector<Widget> widgets = h.editor().widgets();
      const Widget& widget = widgets[below(widgets.size())];
      trail += "\nclick " + widget.label;
      h.click(Vec2(widget.x + widget.width / 2, widget.y + widget.height / 2),
              random.chance(0.15) ? ImGuiMouseButton_Right : ImGuiMouseButton_Left);
    } else if (what < 0.6) {
      const std::size_t k = below(std::size(kKeys));
      const int modifiers = random.chance(0.25)   ? int(ImGuiMod_Shift)
                            : random.chance(0.25) ? int(ImGuiMod_Ctrl)
                                                  : 0;
      trail += std::string("\nkey ") +
               (modifiers == ImGuiMod_Ctrl    ? "Ctrl+"
                : modifiers == ImGuiMod_Shift ? "Shift+"
                                              : "") +
               ImGui::GetKeyName(kKeys[k]);
      h.key(kKeys[k], modifiers);
    } else if (what < 0.9) {
      std::vector<Vec2> places = {somewhere()};
      for (std::size_t i = 0; i < 2 + below(8); ++i)
        places.push_back(places.back() + Vec2(random.between(-80, 80), random.between(-80, 80)));
      if (random.chance(0.4)) places.back() = places.front();
      trail += "\ndrag";
      h.draw(places);
    } else if (what < 0.96) {
      trail += "\nwheel";
      h.point_at(somewhere());
      h.wheel(float(random.between(-3, 3)));
    } else {
      trail += "\nundo";
      h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
    }
    SCOPED_TRACE(trail);
    ASSERT_NO_FATAL_FAILURE(expect_sound(h));
    if (HasFailure()) return;
  }
  expect_undo_leads_back(h);
}

// Each key with each modifier, where there is nothing to work on, and in the midst of a gesture.
TEST(Keys, NoneBreaksAnything) {
  for (const std::string start : {"welcome", "new", "blank", "pressed"}) {
    for (const int modifiers : {0, int(ImGuiMod_Shift), int(ImGuiMod_Ctrl)})
      for (const std::string mode : {"Outline", "Skeleton", "Pose", "Result"}) {
        if (start == "welcome" && mode != "Outline") continue;  // it knows no modes
        Harness h(start == "welcome" ? std::vector<std::string>{"circles"}
                                     : std::vector<std::string>{});
        h.platform.dialogs = start != "new";
        if (start == "new") h.start_over();
        if (start == "blank") h.click("Blank paper");
        if (start == "pressed") h.open_example("heart");
        if (start != "welcome") h.click(mode + " mode");
        for (const ImGuiKey key : kKeys) {
          SCOPED_TRACE(start + ", " + mode + ", " + ImGui::GetKeyName(key));
          if (start == "pressed" && h.find("Sketch")) {
            h.point_at(h.middle("Sketch"));
            h.press();
            h.point_at(h.middle("Sketch") + Vec2(30, 10));
          }
          h.key(key, modifiers);
          if (start == "pressed") h.release();
          ASSERT_NO_FATAL_FAILURE(expect_sound(h));
        }
      }
  }
}

}  // namespace
}  // namespace artisketch

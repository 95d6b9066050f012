#include "editor/gl/damage.h"

#include <gtest/gtest.h>

#include "editor/harness.h"

namespace artisketch {
namespace {

double area(const std::vector<Rect>& places) {
  double sum = 0;
  for (const Rect& r : places) sum += double(r.w) * double(r.h);
  return sum;
}

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

unsigned triangles(const ImDrawData& data) {
  unsigned count = 0;
  for (const ImDrawList* list : data.CmdLists)
    for (const ImDrawCmd& command : list->CmdBuffer) count += command.ElemCount / 3;
  return count;
}

class Painted : public testing::Test {
 protected:
  Painted() {
    h.open_example("circles");
    h.settle();
    next(true);
  }
  // Draws a frame; the places that look otherwise.
  std::vector<Rect> next(bool afresh = false, std::vector<unsigned> painted = {}) {
    h.frame();
    return damage.narrow(*ImGui::GetDrawData(), painted, afresh);
  }
  Harness h;
  Damage damage;
};

TEST_F(Painted, NothingIsDrawnWhereNothingChanged) {
  EXPECT_EQ(area(next()), 0);
  EXPECT_EQ(triangles(*ImGui::GetDrawData()), 0u);
}

TEST_F(Painted, AfreshIsAll) {
  const std::vector<Rect> all = next(true);
  EXPECT_GT(area(all), 0.95 * 1440 * 900);
  EXPECT_GT(triangles(*ImGui::GetDrawData()), 500u);
}

TEST_F(Painted, AButtonUnderThePointerIsAllThatChanges) {
  const Widget menu = h.widget("Menu");
  ImGui::GetIO().AddMousePosEvent(menu.x + 5, menu.y + 5);
  h.frame();
  std::vector<Rect> changed = damage.narrow(*ImGui::GetDrawData(), {}, false);
  for (const Rect& more : next()) changed.push_back(more);
  ASSERT_FALSE(changed.empty());
  EXPECT_LT(area(changed), 4 * double(menu.width) * double(menu.height));
  EXPECT_TRUE(overlap(changed[0], {menu.x, menu.y, menu.width, menu.height}));
}

TEST_F(Painted, APaintedTextureIsDrawnAgainWhereItShows) {
  unsigned texture = 0;
  h.frame();
  for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists)
    for (const ImDrawCmd& command : list->CmdBuffer) {
      const auto of = unsigned(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
      if (!command.UserCallback && command.ElemCount > 0 &&
          std::string(list->_OwnerName) == "Model" && h.graphics.textures.contains(of))
        texture = of;
    }
  ASSERT_NE(texture, 0u);
  damage.narrow(*ImGui::GetDrawData(), {}, false);
  const std::vector<Rect> changed = next(false, {texture});
  ASSERT_EQ(changed.size(), 1u);
  const Widget model = h.widget("Turn the model");
  EXPECT_TRUE(overlap(changed[0], {model.x, model.y, model.width, model.height}));
  EXPECT_LT(area(changed), 0.4 * 1440 * 900);
}

// What is drawn lies within the places, which don't overlap.
TEST_F(Painted, WhatChangesIsToldInPlacesApart) {
  for (const ImGuiKey key : {ImGuiKey_3, ImGuiKey_B, ImGuiKey_Period, ImGuiKey_2, ImGuiKey_4}) {
    ImGui::GetIO().AddKeyEvent(key, true);
    for (int i = 0; i < 4; ++i) {
      const std::vector<Rect> changed = next();
      for (std::size_t a = 0; a < changed.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(overlap(changed[a], changed[b]));
      for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists)
        for (const ImDrawCmd& command : list->CmdBuffer) {
          if (command.UserCallback) continue;
          const ImVec4& c = command.ClipRect;
          EXPECT_TRUE(std::any_of(changed.begin(), changed.end(), [&](const Rect& r) {
            return c.x >= r.x - 0.01f && c.y >= r.y - 0.01f && c.z <= r.right() + 0.01f &&
                   c.w <= r.bottom() + 0.01f;
          }));
        }
      ImGui::GetIO().AddKeyEvent(key, false);
    }
  }
}

}  // namespace
}  // namespace artisketch

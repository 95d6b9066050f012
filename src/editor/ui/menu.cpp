#include "editor/ui/menu.h"

#include <imgui.h>

#include "editor/ui/ui.h"

namespace artisketch {

bool long_press() {
  constexpr float kLong = 0.5f;  // seconds
  constexpr float kStill = 8;    // points that a finger may slip meanwhile
  const ImGuiIO& io = ImGui::GetIO();
  const float held = io.MouseDownDuration[ImGuiMouseButton_Left];
  return io.MouseSource != ImGuiMouseSource_Mouse && held >= kLong && held - io.DeltaTime < kLong &&
         io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < kStill * kStill;
}

Menu::Menu() {
  if (ImGui::IsItemActive() && long_press()) ImGui::OpenPopup(ImGui::GetItemID());
  begin(ImGui::BeginPopupContextItem());
}

Menu::Menu(const char* name, bool open) {
  if (open) ImGui::OpenPopup(name);
  begin(ImGui::BeginPopup(name));
}

void Menu::begin(bool open) {
  open_ = open;
  if (!open_) return;
  if (ImGui::IsKeyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {10, 12});  // lines for fingers
  ImGui::Dummy({0, 2});
}

Menu::~Menu() {
  if (!open_) return;
  ImGui::Dummy({0, 2});
  ImGui::PopStyleVar();
  ImGui::EndPopup();
}

bool Menu::line(const std::string& label, const std::string& key, bool enabled) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string words = tr(label), key_words = tr(key);
  record(label, {at.x, at.y, ImGui::CalcTextSize(words.c_str()).x + 20, ImGui::GetTextLineHeight()},
         enabled);
  // ImGui knows it by the English.
  return ImGui::MenuItem(("  " + words + "  ##" + label).c_str(),
                         key.empty() ? nullptr : key_words.c_str(), false, enabled);
}

}  // namespace artisketch

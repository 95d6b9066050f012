#include "editor/ui/keys.h"

#include <algorithm>

#include <imgui.h>
#include <imgui_internal.h>

namespace artisketch {
namespace {

// One frame shows the field, the next makes it active, and one is spare.
constexpr int kFramesOfPatience = 3;
int patience = 0;

bool is_press(const ImGuiInputEvent& event) {
  if (event.Type != ImGuiInputEventType_Key || !event.Key.Down) return false;
  const ImGuiKey key = event.Key.Key;
  const bool modifier =
      (key >= ImGuiKey_LeftCtrl && key <= ImGuiKey_RightSuper) || (key & ImGuiMod_Mask_) != 0;
  return !modifier;
}

bool is_text(const ImGuiInputEvent& event) {
  return event.Type == ImGuiInputEventType_Text;
}

}  // namespace

void begin_frame() {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImVector<ImGuiInputEvent>& queue = g.InputEventsQueue;
  const bool typing = g.WantTextInputNextFrame == 1;
  patience = typing ? 0 : std::max(0, patience - 1);
  const auto held_from = [&] {
    int presses = 0, i = 0;
    for (; i < queue.Size; ++i) {
      if (patience > 0 && (is_press(queue[i]) || is_text(queue[i]))) break;
      presses += is_press(queue[i]);
      if (presses > 1) break;
    }
    return i;
  }();
  // ImGui knows only by its queue which keys will be up: what is held back goes there again at
  // once.
  ImVector<ImGuiInputEvent> held;
  for (int i = held_from; i < queue.Size; ++i) held.push_back(queue[i]);
  queue.resize(held_from);
  ImGui::NewFrame();
  for (const ImGuiInputEvent& event : held) queue.push_back(event);
}

void await_text_field() {
  patience = kFramesOfPatience;
}

}  // namespace artisketch

// What can be done to the outline or joint under the pointer, by right click, or by a finger that
// rests.
#include "editor/canvas/pointer.h"
#include "editor/shell/panels.h"
#include "editor/ui/menu.h"

namespace artisketch {
namespace {

constexpr float kFinger = 14;  // points round a joint

std::vector<Command> commands_of(Mode mode) {
  switch (mode) {
    case Mode::outline:
      return {Command::redraw,      Command::other_joint, Command::join,   Command::mend,
              Command::mirror,      Command::copy_to,     Command::behind, Command::in_front,
              Command::hidden_here, Command::remove};
    case Mode::skeleton:
      return {Command::rename, Command::equalise, Command::remove};
    case Mode::pose:
      return {Command::flip, Command::lock, Command::suggest, Command::copy_pose, Command::reset};
    case Mode::result:
      break;
  }
  return {};
}

// Chooses what lies under the pointer; whether anything does.
bool choose(Work& work, const OnScreen& on) {
  View& view = work.view;
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (view.mode == Mode::outline) {
    const int under = contour_at(work, on, at);
    if (under >= 0) view.contour = under, view.joint = work.frame().contours[under].joint;
    return under >= 0;
  }
  const int under = joint_at(posed_joints(work.document().skeleton, work.drawn_pose()),
                             frame_camera(work.document(), view.frame), on, at, kFinger);
  if (under >= 0) view.joint = under;
  return under >= 0;
}

}  // namespace

void canvas_menu(Work& work, const Rect& place, const OnScreen& on) {
  const bool rests = long_press();
  const bool here = place.holds(ImGui::GetIO().MousePos) &&
                    ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const bool opens = here && !work.outline && work.fingers.count == 0 &&
                     (rests || ImGui::IsMouseClicked(ImGuiMouseButton_Right)) && choose(work, on);
  if (opens && rests) work.drop_gesture();  // the finger may have begun to draw
  Menu menu("canvas menu", opens);
  if (!menu) return;
  for (const Command command : commands_of(work.view.mode)) {
    if (!available(work, command)) continue;
    const CommandWords& words = words_of(command);
    if (menu.line(words.name, key_words(words, work.platform.mac_keys()))) work.ask(command);
  }
}

}  // namespace artisketch

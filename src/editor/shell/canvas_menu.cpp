// What can be done to the outline or joint under the pointer, by right click, or by a finger that
// rests.
#include "editor/canvas/pointer.h"
#include "editor/shell/panels.h"
#include "editor/ui/menu.h"

namespace artisketch {
namespace {

constexpr float kFinger = 14;  // points round a joint

// Chooses what lies under the pointer; whether anything does.
bool choose(App& app, const OnScreen& on) {
  View& view = app.view;
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (view.mode == Mode::outline) {
    const int under = contour_at(app, on, at);
    if (under >= 0)
      app.session.selection.contour = under,
      app.session.selection.joint = app.frame().contours[under].joint;
    return under >= 0;
  }
  const int under =
      joint_at(posed_joints(app.document().skeleton, app.drawn_pose()),
               frame_camera(app.document(), app.session.selection.frame), on, at, kFinger);
  if (under >= 0) app.session.selection.joint = under;
  return under >= 0;
}

}  // namespace

void canvas_menu(App& app, const Rect& place, const OnScreen& on) {
  const bool rests = long_press();
  const bool here = place.holds(ImGui::GetIO().MousePos) &&
                    ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const bool opens = here && !app.session.new_outline && app.fingers.count == 0 &&
                     (rests || ImGui::IsMouseClicked(ImGuiMouseButton_Right)) && choose(app, on);
  if (opens) app.session.menu_over = on.back(ImGui::GetIO().MousePos);
  if (opens && rests) app.drop_gesture();  // the finger may have begun to draw
  Menu menu("canvas menu", opens);
  if (!menu) return app.session.menu_over.reset();
  for (const Command& command : app.commands) {
    if (!command.in_menu || !available(app, command)) continue;
    if (menu.line(command.name, key_words(command, app.services.platform.mac_keys())))
      app.ask(command.id);
  }
}

}  // namespace artisketch

#include "editor/modes/nudging.h"

#include <imgui.h>

namespace artisketch {

std::function<void(App&)> held_down(std::function<void(App&)> change) {
  return [change = std::move(change)](App& app) {
    Session& session = app.session;
    Nudging& nudging = session.nudging;
    if (!session.goes_on(nudging.gesture) || nudging.revision != session.history.revision())
      nudging.gesture = session.begin_gesture();
    change(app);
    nudging.revision = session.history.revision();
  };
}

std::vector<Command> nudge_commands(const std::string& id, bool (*available)(const App&),
                                    void (*move)(App&, const Vec2&)) {
  struct Way {
    const char *id, *name;
    ImGuiKey key;
    Vec2 by;
  };
  const Way ways[] = {{"left", "Left by 1 px, with Shift 10", ImGuiKey_LeftArrow, {-1, 0}},
                      {"right", "Right", ImGuiKey_RightArrow, {1, 0}},
                      {"up", "Up", ImGuiKey_UpArrow, {0, -1}},
                      {"down", "Down", ImGuiKey_DownArrow, {0, 1}}};
  std::vector<Command> rows;
  for (const Way& way : ways) {
    Command row;
    row.id = id + "_" + way.id;
    row.name = way.name;
    row.key = way.key;
    row.any_shift = row.repeats = true;
    row.available = available;
    row.run = held_down(
        [move, by = way.by](App& app) { move(app, (ImGui::GetIO().KeyShift ? 10 : 1) * by); });
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace artisketch

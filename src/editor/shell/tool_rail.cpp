// What a mode offers: its tools, and beside them what acts at once.
#include <algorithm>

#include "editor/canvas/controls.h"
#include "editor/shell/panels.h"

namespace artisketch {
namespace {

constexpr float kGap = 13;      // between what is taken up and what is done at once
constexpr float kFingers = 60;  // a tool's height on tablets

struct Rail {
  std::vector<const Command*> tools, actions;
  std::size_t size() const { return tools.size() + actions.size(); }
  float gap() const { return tools.empty() || actions.empty() ? 0 : kGap; }
};

Rail rail_of(const App& app) {
  Rail rail;
  for (const Command& command : app.commands) {
    if (command.mode != app.view.mode) continue;
    if (command.is_tool) rail.tools.push_back(&command);
    if (command.in_rail) rail.actions.push_back(&command);
  }
  return rail;
}

}  // namespace

Rect rail_place(const App& app, const Layout& layout) {
  Rect place = layout.rail;
  if (!layout.tablet) return place;
  const Rail rail = rail_of(app);
  const float ends = 8 + rail.gap(), high = kFingers * float(rail.size()) + ends;
  constexpr float kMargin = 12;
  // Where a phone's canvas is too low for all: from its top on, and lower.
  if (place.y + high > layout.canvas.bottom() - kMargin) place.y = layout.canvas.y + kMargin;
  place.h = std::min(high, layout.canvas.bottom() - kMargin - place.y);
  return place;
}

void tool_rail(App& app, const Layout& layout) {
  const Theme& t = theme();
  const Rail rail = rail_of(app);
  const Rect place = rail_place(app, layout);
  const float share = (place.h - 8 - rail.gap()) / std::max(1.0f, float(rail.size()));
  const float height = layout.tablet ? std::min(kFingers, share) : layout.compact ? 40 : 52;
  const float step = height + (layout.tablet ? 0 : 2);
  const bool with_words = layout.tablet ? height > 48 : !layout.compact;
  const Panel panel("Tools", place, t.panel,
                    layout.tablet ? Panel::Layer::floating : Panel::Layer::base,
                    layout.tablet ? kRadiusPanel : 0);
  if (!layout.tablet) hairline({place.right() - 1, place.y}, {place.right(), place.bottom()});
  Rect column = place.inset(4, layout.tablet ? 4 : 8);
  const auto entry = [&](const Command& command) {
    Look look = command_look(app, command);
    look.quiet = true;
    look.id = std::string(command.name) + " tool";
    const Rect cell = column.cut_top(step);
    if (tool_button(command.name, {cell.x, cell.y, cell.w, height}, look, with_words))
      app.ask(command.id);
  };
  for (const Command* tool : rail.tools) entry(*tool);
  if (rail.gap() > 0) {
    const Rect line = column.cut_top(kGap);
    hairline({line.x + 10, line.centre().y}, {line.right() - 10, line.centre().y + 1});
  }
  for (const Command* action : rail.actions) entry(*action);
}

}  // namespace artisketch

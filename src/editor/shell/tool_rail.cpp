#include <algorithm>

#include "editor/shell/panels.h"

namespace artisketch {

std::vector<RailEntry> tools_of(Mode mode) {
  switch (mode) {
    case Mode::outline:
      return {{Command::tool_edit, Tool::edit},     {Command::tool_draw, Tool::draw},
              {Command::tool_points, Tool::points}, {Command::tool_trace, Tool::trace},
              {Command::tool_cut, Tool::cut},       {Command::mirror, std::nullopt},
              {Command::copy_to, std::nullopt},     {Command::behind, std::nullopt},
              {Command::remove, std::nullopt}};
    case Mode::skeleton:
      return {{Command::tool_edit, Tool::edit},
              {Command::both_sides, std::nullopt},
              {Command::equalise, std::nullopt},
              {Command::rename, std::nullopt},
              {Command::remove, std::nullopt}};
    case Mode::pose:
      return {{Command::tool_pose, Tool::pose},   {Command::tool_turn, Tool::turn},
              {Command::tool_twist, Tool::twist}, {Command::flip, std::nullopt},
              {Command::lock, std::nullopt},      {Command::suggest, std::nullopt},
              {Command::copy_pose, std::nullopt}, {Command::reset, std::nullopt}};
    case Mode::result:
      return {{Command::tool_orbit, Tool::orbit},   {Command::tool_pose, Tool::pose},
              {Command::tool_joints, Tool::joints}, {Command::tool_fatness, Tool::fatness},
              {Command::set_key, std::nullopt},     {Command::reset, std::nullopt}};
  }
  return {};
}

namespace {

constexpr float kGap = 13;      // between what is taken up and what is done at once
constexpr float kFingers = 60;  // a tool's height on tablets

bool has_gap(const std::vector<RailEntry>& entries) {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const RailEntry& entry) { return !entry.tool && entries[0].tool; });
}

}  // namespace

Rect rail_place(const Work& work, const Layout& layout) {
  Rect place = layout.rail;
  const std::vector<RailEntry> entries = tools_of(work.view.mode);
  if (layout.tablet) place.h = kFingers * float(entries.size()) + 8 + (has_gap(entries) ? kGap : 0);
  return place;
}

void tool_rail(Work& work, const Layout& layout) {
  const Theme& t = theme();
  const std::vector<RailEntry> entries = tools_of(work.view.mode);
  const bool words = !layout.compact;
  const float height = layout.tablet    ? kFingers
                       : layout.compact ? 40
                                        : 52,
              step = height + (layout.tablet ? 0 : 2);
  const Rect place = rail_place(work, layout);
  const bool gap = has_gap(entries);
  const Panel panel("Tools", place, t.panel,
                    layout.tablet ? Panel::Layer::floating : Panel::Layer::base,
                    layout.tablet ? kRadiusPanel : 0);
  if (!layout.tablet) hairline({place.right() - 1, place.y}, {place.right(), place.bottom()});
  Rect column = place.inset(4, layout.tablet ? 4 : 8);
  bool acting = false;
  for (const RailEntry& entry : entries) {
    if (!entry.tool && !acting && gap) {
      const Rect line = column.cut_top(kGap);
      hairline({line.x + 10, line.centre().y}, {line.right() - 10, line.centre().y + 1});
      acting = true;
    }
    const CommandWords& about = words_of(entry.command);
    Look look;
    look.icon = about.icon;
    look.quiet = true;
    look.on = (entry.tool && work.view.tool() == *entry.tool) ||
              (entry.command == Command::both_sides && work.view.both_sides);
    look.hint = about.hint ? about.hint : about.name;
    look.key = key_words(about, work.platform.mac_keys());
    look.enabled = available(work, entry.command);
    look.id = std::string(about.name) + " tool";
    const Rect cell = column.cut_top(step);
    if (tool_button(about.name, {cell.x, cell.y, cell.w, height}, look, words))
      work.ask(entry.command);
  }
}

}  // namespace artisketch

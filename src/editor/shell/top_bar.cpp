#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "editor/shell/panels.h"

namespace artisketch {

namespace {

Look command_look(const Work& work, Command command, Look look) {
  const CommandWords& words = words_of(command);
  look.icon = words.icon;
  if (look.hint.empty()) look.hint = words.hint ? words.hint : words.name;
  if (const std::string lacks = what_it_lacks(work, command); !lacks.empty()) look.hint = lacks;
  look.key = key_words(words, work.platform.mac_keys());
  look.enabled = look.enabled && available(work, command);
  return look;
}

}  // namespace

void command_button(Work& work, Command command, const Rect& place, Look look) {
  if (button(words_of(command).name, place, command_look(work, command, std::move(look))))
    work.ask(command);
}

void command_icon(Work& work, Command command, const Rect& place, Look look) {
  look.quiet = true;
  if (icon_button(words_of(command).name, place, command_look(work, command, std::move(look))))
    work.ask(command);
}

namespace {

std::string stage_in_words(const Work& work) {
  const Progress progress = work.jobs.progress();
  std::string words = progress.stage;
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
  if (progress.parts > 1)
    words = "Part " + std::to_string(progress.part + 1) + " of " + std::to_string(progress.parts);
  if (!progress.item.empty()) words += ", " + joint_words(progress.item).whole();
  return words.empty() ? "Starting" : words;
}

// What takes the place of Reconstruct while it runs: how far it is, and a way out.
void progress_button(Work& work, const Rect& place) {
  const Theme& t = theme();
  const Press press = press_area("Cancel", place);
  const float done = float(std::clamp(work.jobs.progress().fraction, 0.0, 1.0));
  draw().AddRectFilled(place.min(), place.max(), t.control, kRadius);
  draw().PushClipRect(place.min(), {place.x + place.w * done, place.bottom()}, true);
  draw().AddRectFilled(place.min(), place.max(), t.selection, kRadius);
  draw().PopClipRect();
  draw().AddRectFilled({place.x + 2, place.bottom() - 3},
                       {place.x + 2 + (place.w - 4) * done, place.bottom() - 1}, t.accent, 1);
  // A glint runs along: it goes on, also where a stage takes long.
  constexpr double kGlintSeconds = 1.4;
  constexpr float kGlint = 0.2f;  // of the bar
  const float at = float(std::fmod(ImGui::GetTime() / kGlintSeconds, 1.0)) * (1 + kGlint);
  const Rect bar{place.x + 2, place.bottom() - 3, place.w - 4, 2};
  draw().AddRectFilled({bar.x + bar.w * std::max(0.0f, at - kGlint), bar.y},
                       {bar.x + bar.w * std::min(1.0f, at), bar.bottom()}, t.text, 1);
  Rect row = place.inset(12, 0);
  const std::string cancel = "Cancel";
  write(row.cut_right(text_width(Font::body_bold, cancel)), Font::body_bold,
        press.hovered ? t.text : t.accent, cancel);
  row.cut_right(10);
  write(row, Font::body, t.text, stage_in_words(work));
  if (press.hovered) tooltip("Stop; the old model stays", "Esc");
  if (press.clicked) work.ask(Command::cancel_job);
}

void mode_switch(Work& work, const Rect& place) {
  constexpr Command kMode[kModes] = {Command::mode_outline, Command::mode_skeleton,
                                     Command::mode_pose, Command::mode_result};
  std::vector<std::pair<std::string, Look>> choices;
  for (int m = 0; m < kModes; ++m) {
    const CommandWords& words = words_of(kMode[m]);
    Look look;
    look.icon = words.icon;
    look.hint = words.hint;
    look.key = key_words(words, false);
    look.on = work.view.welcome ? Mode(m) == Mode::result : work.view.mode == Mode(m);
    look.id = std::string(words.name) + " mode";
    choices.emplace_back(words.name, look);
  }
  const int clicked = segments(choices, place);
  if (clicked >= 0) work.ask(kMode[clicked]);
}

std::string state_of_file(const Work& work) {
  if (work.view.welcome) return "";
  if (work.unsaved()) return "Edited";
  return work.place.empty() ? "" : "Saved";
}

void name_and_state(const Work& work, Rect row) {
  const Theme& t = theme();
  const std::string title = work.view.welcome              ? "ArtiSketch"
                            : work.document().name.empty() ? "Untitled"
                                                           : work.document().name;
  const float width = std::min(text_width(Font::title, title) + 1, row.w);
  write(row.cut_left(width), Font::title, t.text, title);
  row.cut_left(12);
  const std::string state = state_of_file(work);
  if (state == "Saved")
    write_icon({row.x + 6, row.y + row.h / 2}, IconSize::small, t.muted, icon::kCheck);
  if (state == "Saved") row.cut_left(18);
  if (row.w > 40) write(row, Font::caption, t.muted, state);
}

}  // namespace

void top_bar(Work& work, const Layout& layout) {
  const Theme& t = theme();
  {
    const Panel panel("Top", layout.top, t.panel);
    const bool touch = layout.tablet;
    Rect row = layout.top.inset(touch ? 8 : 10, 0);
    const float size = touch ? 44 : 32;
    const Rect menu = row.cut_left(size).middle(size, size);
    Look look;
    look.icon = icon::kMenu;
    look.quiet = true;
    if (icon_button("Menu", menu, look)) ImGui::OpenPopup("main menu");
    main_menu(work, menu);
    row.cut_left(touch ? 8 : 12);

    row.cut_right(touch ? 0 : 4);
    command_icon(work, Command::help, row.cut_right(size).middle(size, size), {});
    row.cut_right(touch ? 4 : 8);
    const float high = touch ? 40 : 34;
    Look exporting;
    exporting.on = work.view.exporting;
    command_button(work, Command::export_model, row.cut_right(92).middle(92, high), exporting);
    row.cut_right(8);
    const bool busy = work.busy();
    const float make_width = busy            ? (layout.tablet ? 220.0f : 232.0f)
                             : layout.tablet ? 136.0f
                                             : 124.0f;
    const Rect make = row.cut_right(make_width).middle(make_width, high);
    if (busy) {
      progress_button(work, make);
    } else {
      Look primary;
      primary.primary = work.view.mode != Mode::result && !work.view.welcome;
      command_button(work, Command::reconstruct, make, primary);
    }
    row.cut_right(16);
    Look redo, undo;
    if (work.history.can_redo()) redo.hint = "Redo " + work.history.redo_name();
    if (work.history.can_undo()) undo.hint = "Undo " + work.history.undo_name();
    command_icon(work, Command::redo, row.cut_right(size).middle(size, size), redo);
    row.cut_right(6);
    command_icon(work, Command::undo, row.cut_right(size).middle(size, size), undo);

    if (!layout.tablet) {
      const float width = layout.compact ? 420 : 476;
      Rect modes = layout.top.middle(width, 34);
      // A long progress line pushes the modes aside rather than under itself.
      modes.x = std::min(modes.x, row.right() - width - 12);
      mode_switch(work, modes);
      row.w = std::max(0.0f, modes.x - row.x - 16);
    }
    name_and_state(work, row);
    if (!layout.tablet)
      hairline({0, layout.top.bottom() - 1}, {layout.top.right(), layout.top.bottom()});
  }
  if (!layout.tablet) return;
  const Panel panel("Modes", layout.modes, t.panel);
  mode_switch(work, layout.modes.inset(12, 4));
  hairline({0, layout.modes.bottom() - 1}, {layout.modes.right(), layout.modes.bottom()});
}

}  // namespace artisketch

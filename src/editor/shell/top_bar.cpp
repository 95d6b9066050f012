#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/shell/panels.h"

namespace artisketch {

namespace {

std::string stage_in_words(const App& app) {
  const Progress progress = app.services.jobs.progress();
  std::string words = progress.stage;
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
  if (progress.parts > 1)
    words = "Part " + std::to_string(progress.part + 1) + " of " + std::to_string(progress.parts);
  if (!progress.item.empty()) words += ", " + joint_words(progress.item).whole();
  return words.empty() ? "Starting" : words;
}

// What takes the place of Reconstruct while it runs: how far it is, and a way out.
void progress_button(App& app, const Rect& place) {
  const Theme& t = theme();
  const Press press = press_area("Cancel", place);
  const float done = float(std::clamp(app.services.jobs.progress().fraction, 0.0, 1.0));
  draw().AddRectFilled(place.min(), place.max(), t.control, kRadius);
  draw().PushClipRect(place.min(), {place.x + place.w * done, place.bottom()}, true);
  draw().AddRectFilled(place.min(), place.max(), t.selection, kRadius);
  draw().PopClipRect();
  draw().AddRectFilled({place.x + 2, place.bottom() - 3},
                       {place.x + 2 + (place.w - 4) * done, place.bottom() - 1}, t.accent, 1);
  // A glint runs along: it goes on, also where a stage takes long.
  constexpr double kGlintSeconds = 1.4;
  constexpr float kGlint = 0.2f;  // of the bar
  const float at = float(std::fmod(app.services.now / kGlintSeconds, 1.0)) * (1 + kGlint);
  const Rect bar{place.x + 2, place.bottom() - 3, place.w - 4, 2};
  draw().AddRectFilled({bar.x + bar.w * std::max(0.0f, at - kGlint), bar.y},
                       {bar.x + bar.w * std::min(1.0f, at), bar.bottom()}, t.text, 1);
  Rect row = place.inset(12, 0);
  const std::string cancel = "Cancel";
  write(row.cut_right(text_width(Font::body_bold, cancel)), Font::body_bold,
        press.hovered ? t.text : t.accent, cancel);
  row.cut_right(10);
  write(row, Font::body, t.text, stage_in_words(app));
  if (press.hovered) tooltip("Stop; the old model stays", "Esc");
  if (press.clicked) app.ask("step_back");
}

void mode_switch(App& app, const Rect& place) {
  constexpr const char* kMode[kModes] = {"mode_outline", "mode_skeleton", "mode_pose",
                                         "mode_result"};
  std::vector<std::pair<std::string, Look>> choices;
  for (int m = 0; m < kModes; ++m) {
    const Command& words = command(app, kMode[m]);
    Look look;
    look.icon = words.icon;
    look.hint = words.about;
    look.key = key_words(words, false);
    look.on = app.view.welcome ? Mode(m) == Mode::result : app.view.mode == Mode(m);
    look.id = std::string(words.name) + " mode";
    choices.emplace_back(words.name, look);
  }
  const int clicked = segments(choices, place);
  if (clicked >= 0) app.ask(kMode[clicked]);
}

std::string state_of_file(const App& app) {
  if (app.view.welcome) return "";
  if (app.session.unsaved()) return "Edited";
  return app.session.file.place.empty() ? "" : "Saved";
}

void name_and_state(const App& app, Rect row) {
  const Theme& t = theme();
  const std::string title = app.view.welcome              ? "ArtiSketch"
                            : app.document().name.empty() ? "Untitled"
                                                          : app.document().name;
  const bool named = !app.view.welcome && title != "Untitled";
  if (!named && text_width(Font::title, title) > row.w) return;  // on phones
  const std::string shown = named ? title : tr(title);
  const float width = std::min(name_width(Font::title, shown) + 1, row.w);
  write_name(row.cut_left(width), Font::title, t.text, shown);
  row.cut_left(12);
  const std::string state = state_of_file(app);
  if (state == "Saved" && row.w > 12)
    write_icon({row.cut_left(18).x + 6, row.y + row.h / 2}, IconSize::small, t.muted, icon::kCheck);
  if (text_width(Font::caption, state) <= row.w) write(row, Font::caption, t.muted, state);
}

}  // namespace

void top_bar(App& app, const Layout& layout) {
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
    main_menu(app, menu);
    row.cut_left(touch ? 8 : 12);

    row.cut_right(touch ? 0 : 4);
    command_icon(app, "help", row.cut_right(size).middle(size, size), {});
    row.cut_right(touch ? 4 : 8);
    const float high = touch ? 40 : 34;
    // On a phone the icons say it: undo has its place too.
    const bool narrow = layout.top.w < 480;
    const auto act = [&](std::string_view id, float wide, Look as) {
      const Rect place = row.cut_right(narrow ? size : wide).middle(narrow ? size : wide, high);
      if (narrow)
        command_icon(app, id, place, as);
      else
        command_button(app, id, place, as);
    };
    act("export", 92, {});
    row.cut_right(8);
    const bool busy = app.busy();
    const float make_width = busy            ? (layout.tablet ? 220.0f : 232.0f)
                             : layout.tablet ? 136.0f
                                             : 124.0f;
    if (busy) {
      const float free = std::min(make_width, row.w - 2 * size - 6);
      progress_button(app, row.cut_right(free).middle(free, high));
    } else {
      Look primary;
      primary.primary = app.view.mode != Mode::result && !app.view.welcome;
      act("reconstruct", make_width, primary);
    }
    row.cut_right(16);
    Look redo, undo;
    if (app.session.can_redo()) redo.hint = "Redo " + app.session.redo_name();
    if (app.session.can_undo()) undo.hint = "Undo " + app.session.undo_name();
    command_icon(app, "redo", row.cut_right(size).middle(size, size), redo);
    row.cut_right(6);
    command_icon(app, "undo", row.cut_right(size).middle(size, size), undo);

    if (!layout.tablet) {
      const float width = layout.compact ? 420 : 476;
      Rect modes = layout.top.middle(width, 34);
      // A long progress line pushes the modes aside rather than under itself.
      modes.x = std::min(modes.x, row.right() - width - 12);
      mode_switch(app, modes);
      row.w = std::max(0.0f, modes.x - row.x - 16);
    }
    name_and_state(app, row);
    if (!layout.tablet)
      hairline({0, layout.top.bottom() - 1}, {layout.top.right(), layout.top.bottom()});
  }
  if (!layout.tablet) return;
  const Panel panel("Modes", layout.modes, t.panel);
  mode_switch(app, layout.modes.inset(12, 4));
  hairline({0, layout.modes.bottom() - 1}, {layout.modes.right(), layout.modes.bottom()});
}

}  // namespace artisketch

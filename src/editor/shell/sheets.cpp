// What lies over the window for a moment: menu, questions, shortcuts, toasts; and the status line.
#include <algorithm>
#include <cmath>
#include <optional>

#include "editor/canvas/controls.h"
#include "editor/session/files.h"
#include "editor/session/language.h"
#include "editor/shell/panels.h"

namespace artisketch {

namespace {
void choose_language_in(App& app, const Rect& place) {
  std::vector<std::pair<std::string, Look>> choices;
  for (const Language& language : kLanguages) {
    Look look;
    look.on = app.view.language == std::string(language.code);
    look.names = true;
    choices.emplace_back(language.name, look);
  }
  const int chosen = segments(choices, place, Font::caption);
  if (chosen >= 0) choose_language(app, kLanguages[std::size_t(chosen)].code);
}
}  // namespace

void main_menu(App& app, const Rect& button) {
  const Theme& t = theme();
  ImGui::SetNextWindowPos({button.x, button.bottom() + 4});
  if (!ImGui::BeginPopup("main menu", ImGuiWindowFlags_NoMove)) return;
  if (ImGui::IsKeyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  constexpr float kWidth = 248, kRow = 32;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  Rect column{corner.x, corner.y + 6, kWidth, 1000};
  const auto row = [&](const std::string& label, const char* icon, const std::string& key,
                       bool enabled, bool names = false) {
    const Rect place = column.cut_top(kRow).inset(6, 0);
    const Press press = press_area("Menu " + label, place, enabled);
    if (press.hovered && enabled) draw().AddRectFilled(place.min(), place.max(), t.hover, kRadius);
    const ImU32 ink = enabled ? t.text : t.disabled;
    if (icon)
      write_icon({place.x + 18, place.centre().y}, IconSize::small, enabled ? t.muted : t.disabled,
                 icon);
    Rect line = place.inset(10, 0);
    line.cut_left(26);
    if (!key.empty())
      write(line.cut_right(text_width(Font::small, key) + 8), Font::small, t.muted, key,
            Align::right);
    write_name(line, Font::body, ink, names ? label : tr(label));
    if (press.clicked) ImGui::CloseCurrentPopup();
    return press.clicked;
  };
  const auto command = [&](std::string_view id) {
    const Command& which = artisketch::command(app, id);
    if (row(which.name, which.icon, key_words(which, app.services.platform.mac_keys()),
            available(app, which)))
      app.ask(which.id);
  };
  const auto gap = [&] {
    const Rect line = column.cut_top(11);
    hairline({line.x + 12, line.centre().y}, {line.right() - 12, line.centre().y + 1});
  };
  command("new");
  command("open");
  command("save");
  command("save_as");
  gap();
  command("add_drawings");
  command("blank_drawing");
  gap();
  const std::vector<Platform::Recent> recents = app.services.platform.recents();
  for (std::size_t i = 0; i < recents.size() && i < 5; ++i)
    if (row(recents[i].name, icon::kHistory, "", true, true)) {
      app.services.platform.open_recent(recents[i].place,
                                        [&app](auto files) { open_files(app, std::move(files)); });
    }
  if (!recents.empty()) gap();
  command("theme");
  command("hints");
  command("guide");
  command("help");
  gap();
  choose_language_in(app, column.cut_top(kRow).inset(10, 0));
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({kWidth, column.y - corner.y + 6});
  ImGui::EndPopup();
}

bool over_all(const Rect& place, float width, float height) {
  const Panel veil("Veil", {0, 0, width, height}, rgb(0x000000, 0.45f), Panel::Layer::floating);
  const bool beside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !place.holds(ImGui::GetIO().MousePos);
  return !beside && !ImGui::IsKeyPressed(ImGuiKey_Escape);
}

void question_sheet(App& app, float width, float height) {
  if (!app.question) return;
  const Theme& t = theme();
  const Rect place = Rect{0, 0, width, height}.middle(std::min(440.0f, width - 24),
                                                      app.question->asks_path ? 188 : 164);
  const bool open = over_all(place, width, height);
  const Panel panel("Question", place, t.raised, Panel::Layer::floating, kRadiusPanel);
  Rect column = place.inset(20);
  write(column.cut_top(24), Font::title, t.text, app.question->title);
  column.cut_top(4);
  std::function<void()> act;
  bool answered = !open;
  if (app.question->asks_path) {
    write(column.cut_top(22), Font::body, t.muted, app.question->words);
    column.cut_top(6);
    if (text_field(app.question->field, column.cut_top(34), app.question->path,
                   ImGui::IsWindowAppearing())) {
      act = [with = app.question->with_path, path = app.question->path] { with(path); };
      answered = true;
    }
  } else {
    write_lines(column, Font::body, t.muted, app.question->words, 20);
  }
  Rect row = Rect{place.x + 20, place.bottom() - 56, place.w - 40, 36};
  for (const Question::Answer& answer : app.question->answers) {
    Look look;
    look.primary = answer.primary;
    const float wide = std::max(88.0f, text_width(Font::body_bold, answer.words) + 32);
    if (button(answer.words, row.cut_right(wide), look)) {
      act = answer.act;
      if (app.question->asks_path && answer.primary)
        act = [with = app.question->with_path, path = app.question->path] { with(path); };
      answered = true;
    }
    row.cut_right(8);
  }
  if (!answered) return;
  app.question.reset();
  if (act) act();
}

namespace {

struct Shortcut {
  std::string words, key;  // without a key: a heading
};

// Of one mode, or of all: a heading and a line for each key.
std::vector<Shortcut> shortcuts(const App& app, std::optional<Mode> mode, const char* heading) {
  std::vector<Shortcut> lines{{heading, ""}};
  for (const Command& command : app.commands) {
    const std::string key = key_words(command, app.services.platform.mac_keys());
    if (!key.empty() && command.mode == mode) lines.push_back({command.name, key});
  }
  if (mode == Mode::pose) lines.push_back({"Your own pose, while held", "P"});
  if (mode) return lines;
  lines.push_back({"Zoom", "Wheel"});
  lines.push_back({"Pan", "Space drag"});
  return lines;
}

// In columns of about one height, a mode's lines together.
std::vector<std::vector<Shortcut>> shortcut_columns(const App& app, int columns) {
  struct Group {
    std::optional<Mode> mode;
    const char* heading;
  };
  constexpr Group kGroups[] = {{std::nullopt, "Everywhere"},
                               {Mode::outline, "Outline"},
                               {Mode::skeleton, "Skeleton"},
                               {Mode::pose, "Pose"},
                               {Mode::result, "Result"}};
  std::vector<std::vector<Shortcut>> all(static_cast<std::size_t>(columns));
  for (const Group& group : kGroups) {
    // Where there is room for little, that is what can be done here.
    if (columns == 1 && group.mode && group.mode != app.view.mode) continue;
    const std::vector<Shortcut> lines = shortcuts(app, group.mode, group.heading);
    auto shortest = std::min_element(
        all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    shortest->insert(shortest->end(), lines.begin(), lines.end());
  }
  return all;
}

}  // namespace

void shortcut_sheet(App& app, float width, float height) {
  if (!app.view.help) return;
  const Theme& t = theme();
  const int columns = width < 760 ? 1 : 3;
  const Command& guide = command(app, "guide");
  const float around = 92 + (available(app, guide) ? 44.0f : 0);
  const std::vector<std::vector<Shortcut>> all = shortcut_columns(app, columns);
  std::size_t rows = 0;
  for (const std::vector<Shortcut>& lines : all) rows = std::max(rows, lines.size());
  const float line = std::clamp((height - 24 - around) / float(rows), 16.0f, 26.0f);
  const Rect place =
      Rect{0, 0, width, height}.middle(std::min(290.0f * float(columns) + 40, width - 24),
                                       std::min(line * float(rows) + around, height - 16));
  if (!over_all(place, width, height)) {
    app.view.help = false;
    return;
  }
  const Panel panel("Shortcuts", place, t.raised, Panel::Layer::floating, kRadiusPanel);
  const Rect head{place.x + 24, place.y + 12, place.w - 36, 44};
  if (sheet_head(head, "Shortcuts", "Close shortcuts")) app.view.help = false;
  const Command& hints = command(app, "hints");
  if (available(app, hints)) {
    const float wide = text_width(Font::body, hints.name) + 24 + 32;
    const Rect there{head.right() - 40 - wide, head.y + 6, wide, 32};
    if (button(hints.name, there, command_look(app, hints))) hints.run(app);
  }
  if (available(app, guide)) {
    const float wide = text_width(Font::body_bold, guide.name) + 88;
    const Rect there{place.x + 24, place.bottom() - 52, wide, 36};
    if (button(guide.name, there, command_look(app, guide))) guide.run(app);
  }
  const float column = (place.w - 48) / float(columns);
  for (std::size_t c = 0; c < all.size(); ++c)
    for (std::size_t i = 0; i < all[c].size(); ++i) {
      const Shortcut& shortcut = all[c][i];
      Rect row{place.x + 24 + column * float(c), place.y + 64 + line * float(i), column - 24, line};
      if (shortcut.key.empty()) {
        write(row, Font::body_bold, t.muted, shortcut.words);
        continue;
      }
      const float wide = text_width(Font::small, shortcut.key) + 14;
      key_cap(row.cut_right(wide).middle(wide, std::min(20.0f, line - 2)), shortcut.key);
      write(row, Font::body, t.text, shortcut.words);
    }
}

void toasts(App& app, const Layout& layout) {
  const Theme& t = theme();
  const double now = app.services.now;
  // Over the band below the drawing, or the head of a tablet's sheet: the figure stays in view. A
  // sheet that is to be answered keeps its head.
  constexpr float kBand = 44, kSheetHead = 52;
  const bool answered = app.view.exporting || app.view.mapping;
  float bottom =
      layout.tablet ? layout.inspector.y + (answered ? 0 : kSheetHead) - 4 : layout.strip.y - 2;
  for (std::size_t i = 0; i < app.toasts.size();) {
    Toast& toast = app.toasts[i];
    if (toast.since < 0) toast.since = now;
    if (!toast.error && now - toast.since > kToastSeconds) {
      app.toasts.erase(app.toasts.begin() + std::ptrdiff_t(i));
      continue;
    }
    const auto wide = [](const std::string& words) {
      return words.empty() ? 0 : text_width(Font::body_bold, words) + 28;
    };
    const float actions = wide(toast.action) + wide(toast.other_action);
    const float most = layout.canvas.w - 24 - actions - 60;
    const float text = std::min(text_width(Font::body, toast.words), std::max(120.0f, most));
    const int lines =
        std::max(1, int(std::ceil(text_width(Font::body, toast.words) / text - 0.02f)));
    const float high = kBand - 4 + 20 * float(lines - 1);
    const Rect place{layout.rail.w > 0 && !layout.tablet ? layout.rail.right() + 12 : 12,
                     bottom - high, 24 + 22 + text + 12 + actions + 34, high};
    bottom = place.y - 8;
    bool dismissed = false;
    std::function<void()> act;
    {
      const FloatingCard card(("Toast " + std::to_string(i)).c_str(), place);
      Rect row = place.inset(12, 0);
      write_icon({row.x + 8, row.centre().y}, IconSize::small, toast.error ? t.error : t.accent,
                 toast.error ? icon::kAlert : icon::kCheckCircle);
      row.cut_left(26);
      Look close;
      close.icon = icon::kClose;
      close.quiet = true;
      close.id = "Dismiss";
      dismissed = icon_button("Dismiss", row.cut_right(26).middle(26, 26), close);
      row.cut_right(8);
      Look quiet;
      quiet.quiet = true;
      quiet.on = true;
      if (!toast.other_action.empty()) {
        Look other;
        if (button(toast.other_action,
                   row.cut_right(wide(toast.other_action) - 6)
                       .middle(wide(toast.other_action) - 6, 30),
                   other))
          act = toast.other_act, dismissed = true;
        row.cut_right(6);
      }
      if (!toast.action.empty() &&
          button(toast.action,
                 row.cut_right(wide(toast.action) - 6).middle(wide(toast.action) - 6, 30), quiet))
        act = toast.act, dismissed = true;
      write_lines({row.x, row.centre().y - 10 * float(lines), text + 1, row.h}, Font::body, t.text,
                  toast.words, 20);
    }
    if (dismissed) app.toasts.erase(app.toasts.begin() + std::ptrdiff_t(i));
    if (act) act();
    if (!dismissed) ++i;
  }
}

void status_line(const App& app, const Layout& layout) {
  const Theme& t = theme();
  const Panel panel("Status", layout.status, t.panel);
  hairline({0, layout.status.y}, {layout.status.right(), layout.status.y + 1});
  Rect row = layout.status.inset(12, 0);
  const View& view = app.view;
  std::string where = "Welcome";
  std::string what = "Turn the model, or open an example and change anything: it is a copy.";
  if (!view.welcome) {
    where = view.mode == Mode::skeleton ? "Skeleton"
                                        : app.tools[view.armed[std::size_t(view.mode)]].name;
    what = app.tool().hint(app);
  }
  std::string right;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!view.welcome && app.has_frame() && layout.canvas.holds(mouse)) {
    const OnScreen on = app.view.sketch.on();
    const Vec2 p = on.back(mouse);
    right = "x " + std::to_string(int(p.x())) + "  y " + std::to_string(int(p.y()));
  }
  write(row.cut_right(160), Font::small, t.muted, right, Align::right);
  write(row.cut_left(text_width(Font::caption_bold, where) + 12), Font::caption_bold, t.text,
        where);
  write(row, Font::caption, t.muted, what);
}

}  // namespace artisketch

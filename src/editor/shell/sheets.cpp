// What lies over the window for a moment: menu, questions, shortcuts, toasts; and the status line.
#include <cmath>

#include "editor/session/actions.h"
#include "editor/shell/panels.h"

namespace artisketch {

void main_menu(Work& work, const Rect& button) {
  const Theme& t = theme();
  ImGui::SetNextWindowPos({button.x, button.bottom() + 4});
  if (!ImGui::BeginPopup("main menu", ImGuiWindowFlags_NoMove)) return;
  constexpr float kWidth = 248, kRow = 32;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  Rect column{corner.x, corner.y + 6, kWidth, 1000};
  const auto row = [&](const std::string& label, const char* icon, const std::string& key,
                       bool enabled) {
    const Rect place = column.cut_top(kRow).inset(6, 0);
    const Press press = press_area("Menu " + label, place, enabled);
    if (press.hovered && enabled) draw().AddRectFilled(place.min(), place.max(), t.hover, kRadius);
    const ImU32 ink = enabled ? t.text : t.disabled;
    if (icon)
      write_icon({place.x + 18, place.centre().y}, IconSize::small, enabled ? t.muted : t.disabled,
                 icon);
    Rect line = place.inset(10, 0);
    line.cut_left(26);
    write(line.cut_right(80), Font::small, t.muted, key, Align::right);
    write(line, Font::body, ink, label);
    if (press.clicked) ImGui::CloseCurrentPopup();
    return press.clicked;
  };
  const auto command = [&](Command which) {
    const CommandWords& words = words_of(which);
    if (row(words.name, words.icon, key_words(words, work.platform.mac_keys()),
            available(work, which)))
      work.ask(which);
  };
  const auto gap = [&] {
    const Rect line = column.cut_top(11);
    hairline({line.x + 12, line.centre().y}, {line.right() - 12, line.centre().y + 1});
  };
  command(Command::new_document);
  command(Command::open);
  command(Command::save);
  command(Command::save_as);
  gap();
  command(Command::add_drawings);
  command(Command::blank_drawing);
  gap();
  const std::vector<Platform::Recent> recents = work.platform.recents();
  for (std::size_t i = 0; i < recents.size() && i < 5; ++i)
    if (row(recents[i].name, icon::kHistory, "", true)) {
      const std::string place = recents[i].place;
      unless_unsaved(work, [&work, place] {
        work.platform.open_recent(place,
                                  [&work](auto files) { open_files(work, std::move(files)); });
      });
    }
  if (!recents.empty()) gap();
  command(Command::theme);
  command(Command::help);
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({kWidth, column.y - corner.y + 6});
  ImGui::EndPopup();
}

namespace {

// Darkens the window; false once what stands at `place` over it is dismissed.
bool over_all(const Rect& place, float width, float height) {
  const Panel veil("Veil", {0, 0, width, height}, rgb(0x000000, 0.45f), Panel::Layer::floating);
  const bool beside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !place.holds(ImGui::GetIO().MousePos);
  return !beside && !ImGui::IsKeyPressed(ImGuiKey_Escape);
}

}  // namespace

void question_sheet(Work& work, float width, float height) {
  if (!work.question) return;
  const Theme& t = theme();
  const Rect place = Rect{0, 0, width, height}.middle(std::min(440.0f, width - 24),
                                                      work.question->asks_path ? 188 : 164);
  const bool open = over_all(place, width, height);
  const Panel panel("Question", place, t.raised, Panel::Layer::floating, kRadiusPanel);
  Rect column = place.inset(20);
  write(column.cut_top(24), Font::title, t.text, work.question->title);
  column.cut_top(4);
  std::function<void()> act;
  bool answered = !open;
  if (work.question->asks_path) {
    write(column.cut_top(22), Font::body, t.muted, work.question->words);
    column.cut_top(6);
    if (text_field("Path", column.cut_top(34), work.question->path, ImGui::IsWindowAppearing())) {
      act = [with = work.question->with_path, path = work.question->path] { with(path); };
      answered = true;
    }
  } else {
    write_lines(column, Font::body, t.muted, work.question->words, 20);
  }
  Rect row = Rect{place.x + 20, place.bottom() - 56, place.w - 40, 36};
  for (const Question::Answer& answer : work.question->answers) {
    Look look;
    look.primary = answer.primary;
    const float wide = std::max(88.0f, text_width(Font::body_bold, answer.words) + 32);
    if (button(answer.words, row.cut_right(wide), look)) {
      act = answer.act;
      if (work.question->asks_path && answer.primary)
        act = [with = work.question->with_path, path = work.question->path] { with(path); };
      answered = true;
    }
    row.cut_right(8);
  }
  if (!answered) return;
  work.question.reset();
  if (act) act();
}

void shortcut_sheet(Work& work, float width, float height) {
  if (!work.view.help) return;
  const Theme& t = theme();
  struct Line {
    std::string words, key;
  };
  std::vector<Line> lines;
  for (const CommandWords& words : all_commands()) {
    const std::string key = key_words(words, work.platform.mac_keys());
    if (!key.empty() && words.command != Command::cancel_job) lines.push_back({words.name, key});
  }
  lines.push_back({"Step back, stop", "Esc"});
  lines.push_back({"Zoom", "Wheel"});
  lines.push_back({"Pan", "Middle drag"});
  const int columns = width < 760 ? 1 : 3;
  const int rows = (int(lines.size()) + columns - 1) / columns;
  constexpr float kRow = 28;
  const Rect place = Rect{0, 0, width, height}.middle(
      std::min(260.0f * float(columns) + 40, width - 24), kRow * float(rows) + 92);
  if (!over_all(place, width, height)) {
    work.view.help = false;
    return;
  }
  const Panel panel("Shortcuts", place, t.raised, Panel::Layer::floating, kRadiusPanel);
  Rect head = Rect{place.x + 24, place.y + 12, place.w - 36, 44};
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.key = "Esc";
  close.id = "Close shortcuts";
  if (icon_button("Close", head.cut_right(28).middle(28, 28), close)) work.view.help = false;
  write(head, Font::title, t.text, "Shortcuts");
  const float column = (place.w - 48) / float(columns);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Rect row{place.x + 24 + column * float(int(i) / rows),
             place.y + 64 + kRow * float(int(i) % rows), column - 24, kRow};
    const float wide = text_width(Font::small, lines[i].key) + 14;
    key_cap(row.cut_right(wide).middle(wide, 20), lines[i].key);
    write(row, Font::body, t.text, lines[i].words);
  }
}

void toasts(Work& work, const Layout& layout) {
  const Theme& t = theme();
  const double now = ImGui::GetTime();
  // Over the band below the drawing, or the head of a tablet's sheet: the figure stays in view.
  constexpr float kBand = 44, kSheetHead = 52;
  float bottom = layout.tablet ? layout.inspector.y + kSheetHead - 4 : layout.strip.y - 2;
  for (std::size_t i = 0; i < work.toasts.size();) {
    Toast& toast = work.toasts[i];
    if (toast.since < 0) toast.since = now;
    if (!toast.error && now - toast.since > kToastSeconds) {
      work.toasts.erase(work.toasts.begin() + std::ptrdiff_t(i));
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
      const Panel under(("Toast shade " + std::to_string(i)).c_str(), place.inset(-8), 0,
                        Panel::Layer::floating);
      shadow(place, kRadiusPanel);
    }
    {
      const Panel panel(("Toast " + std::to_string(i)).c_str(), place, t.raised,
                        Panel::Layer::floating, kRadiusPanel);
      draw().AddRect(place.min(), place.max(), t.line, kRadiusPanel);
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
    if (dismissed) work.toasts.erase(work.toasts.begin() + std::ptrdiff_t(i));
    if (act) act();
    if (!dismissed) ++i;
  }
}

void status_line(const Work& work, const Layout& layout) {
  const Theme& t = theme();
  const Panel panel("Status", layout.status, t.panel);
  hairline({0, layout.status.y}, {layout.status.right(), layout.status.y + 1});
  Rect row = layout.status.inset(12, 0);
  const View& view = work.view;
  std::string where, what;
  if (view.welcome) {
    where = "Welcome";
    what = "Turn the model, or open an example and change anything: it is a copy.";
  } else {
    switch (view.mode) {
      case Mode::outline:
        where = view.tool() == Tool::draw     ? "Draw"
                : view.tool() == Tool::cut    ? "Cut"
                : view.tool() == Tool::trace  ? "Trace"
                : view.tool() == Tool::points ? "Points"
                                              : "Edit";
        what = view.tool() == Tool::draw ? "Drag around a part; let go near the start to close.  "
                                           "Start on the chosen outline to redraw that piece."
               : view.tool() == Tool::cut
                   ? "Drag a line across a part: it becomes two that overlap."
               : view.tool() == Tool::trace
                   ? "Click a shape; drag sideways to take in more or less, far right for all."
               : view.tool() == Tool::points
                   ? "Click point by point; Enter or a click on the first closes."
                   : "Click an outline, drag its points.  Double-click adds a point, Delete "
                     "removes it.";
        break;
      case Mode::skeleton:
        where = "Skeleton";
        what = view.joint >= 0
                   ? "Click beside the joint to add the next one, or drag it.  F2 names, "
                     "Delete removes, Esc lets go."
                   : "Drag joints to where they belong; every drawing follows.";
        break;
      case Mode::pose:
        where = view.tool() == Tool::twist ? "Twist" : view.tool() == Tool::turn ? "Turn" : "Pose";
        what = view.tool() == Tool::twist
                   ? "Choose a joint, then drag sideways or turn the wheel: the part twists."
               : view.tool() == Tool::turn ? "Drag: the whole body turns like a ball."
               : work.proposal
                   ? "Hold Space to see your own pose."
                   : "Drag a joint: the limb follows.  The wheel on a joint twists it, F flips it "
                     "toward you or away.";
        break;
      case Mode::result:
        where = view.tool() == Tool::orbit     ? "Orbit"
                : view.tool() == Tool::joints  ? "Joints"
                : view.tool() == Tool::fatness ? "Fatness"
                                               : "Pose";
        what = view.tool() == Tool::orbit ? "Drag to look around the model.  Space plays."
               : view.tool() == Tool::joints
                   ? "Drag a sphere's rim for its size, its middle to move it; then Reconstruct."
               : view.tool() == Tool::fatness
                   ? "Drag a part sideways: thinner or fatter.  Reconstruct joins it again."
                   : "Drag a joint on the model.  I sets a key at the playhead, Space plays.";
        break;
    }
  }
  std::string right;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!view.welcome && work.has_frame() && layout.canvas.holds(mouse)) {
    const OnScreen on{view.origin, view.zoom};
    const Vec2 p = on.back(mouse);
    right = "x " + std::to_string(int(p.x())) + "  y " + std::to_string(int(p.y()));
  }
  write(row.cut_right(160), Font::small, t.muted, right, Align::right);
  write(row.cut_left(text_width(Font::caption_bold, where) + 12), Font::caption_bold, t.text,
        where);
  write(row, Font::caption, t.muted, what);
}

}  // namespace artisketch

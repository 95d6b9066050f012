// Outline: whose the new or chosen outline is, and what can be done with it.
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/session/part_fit.h"

namespace artisketch {
namespace {

void candidate_card(App& app, int i, const Rect& card) {
  const Theme& t = theme();
  NewOutline& fresh = *app.session.new_outline;
  const int joint = fresh.joints[std::size_t(i)];
  const std::string& name = app.document().skeleton.joints[std::size_t(joint)].name;
  const bool on = i == fresh.choice;
  const Press press = press_area("Assign " + joint_words(name).whole(), card, true, on);
  if (on || press.hovered)
    draw().AddRectFilled(card.min(), card.max(), on ? t.selection : t.control, kRadius);
  if (on) draw().AddRect(card.min(), card.max(), t.accent, kRadius, 0, 1.5f);
  draw().AddCircleFilled({card.x + 18, card.centre().y}, 7, joint_tint(joint));
  if (on) key_cap({card.right() - 48, card.y + 6, 40, 18}, "Enter");
  part_name({card.x + 34, card.y + 4, card.w - 84, 18}, name, true);
  write({card.x + 34, card.y + 22, card.w - 40, 18}, Font::caption, t.muted,
        fresh.reasons[std::size_t(i)]);
  if (press.clicked) fresh.choice = i;
}

// A slider with its name before it and its value in words behind.
bool value_row(const char* name, Rect row, float& value, float low, float high,
               const std::string& words) {
  write(row.cut_left(76), Font::caption, theme().muted, name);
  write(row.cut_right(48), Font::caption, theme().text, words, Align::right);
  row.cut_right(8);
  return slider(name, row, value, low, high);
}

// How the pending line was made can still be changed.
void making_row(App& app, Rect& place) {
  NewOutline& fresh = *app.session.new_outline;
  if (fresh.tracing) {
    float root = float(std::sqrt(app.view.tolerance));
    const std::string words = std::to_string(int(std::lround(100 * app.view.tolerance))) + " %";
    if (value_row("Tolerance", place.cut_top(32).inset(16, 0), root, 0.1f, 1, words))
      trace_again(app, double(root) * root);
  } else if (!fresh.stroke.empty()) {
    float smooth = float(fresh.options.smooth);
    const std::string words = std::to_string(int(std::lround(smooth))) + " px";
    if (!value_row("Smooth", place.cut_top(32).inset(16, 0), smooth, 0, 12, words)) return;
    fresh.options.smooth = smooth;
    if (std::optional<Polyline> line = outline_of_stroke(fresh.stroke, fresh.options))
      fresh.line = std::move(*line);
  }
}

std::string about(const Polyline& line) {
  return std::string(line.closed ? "closed, " : "open, ") + std::to_string(line.points.size()) +
         " points";
}

// How the part fits here, and what to expect of it elsewhere.
void fit_lines(const App& app, Rect& place, int joint) {
  for (const std::string& words :
       {fit_in_words(app, joint, app.session.selection.frame), trust_in_words(app, joint)}) {
    if (words.empty()) continue;
    const Rect row = place.cut_top(22).inset(16, 0);
    record(words, row);
    write(row, Font::caption, theme().muted, words);
  }
}

// The chosen part has no outline in this drawing: it may not be there to be outlined.
void without_outline(App& app, Rect place) {
  const Theme& t = theme();
  hairline({place.x + 16, place.y}, {place.right() - 16, place.y + 1});
  place.cut_top(10);
  write(place.cut_top(28).inset(16, 0), Font::title, t.text,
        part_words(app, app.session.selection.joint));
  fit_lines(app, place, app.session.selection.joint);
  place.cut_top(6);
  command_button(app, "hidden_here", place.cut_top(34).inset(12, 0));
  place.cut_top(8);
  command_button(app, "outline_all", place.cut_top(34).inset(12, 0));
}

}  // namespace

void new_outline_sheet(App& app, Rect place) {
  const Theme& t = theme();
  NewOutline& fresh = *app.session.new_outline;
  Rect head = place.cut_top(56).inset(16, 6);
  Look keep;
  keep.primary = true;
  if (button("Keep", head.cut_right(104), keep)) return app.session.keep_new_outline();
  for (const std::string_view command : {"other_joint", "redraw"}) {
    head.cut_right(8);
    command_button(app, command, head.cut_right(command == "redraw" ? 108.0f : 136.0f));
  }
  write(head.cut_left(text_width(Font::title, "New outline") + 12), Font::title, t.text,
        "New outline");
  write(head, Font::caption, t.muted, about(fresh.line));
  Rect row = place.cut_top(46).inset(12, 1);
  const int shown = std::min(4, int(fresh.joints.size()));
  const float width = (row.w - 8 * float(shown - 1)) / float(shown);
  for (int i = 0; i < shown; ++i) {
    candidate_card(app, i, row.cut_left(width));
    row.cut_left(8);
  }
  place.cut_top(4);
  making_row(app, place);
}

void outline_panel(App& app, Rect place) {
  const Theme& t = theme();
  const bool fresh = app.session.new_outline.has_value();
  if (available(app, "hidden_here")) return without_outline(app, place);
  if (!fresh && (app.session.selection.contour < 0 || !app.has_frame())) {
    if (available(app, "outline_all"))
      command_button(app, "outline_all", place.cut_top(34).inset(12, 0));
    return;
  }
  hairline({place.x + 16, place.y}, {place.right() - 16, place.y + 1});
  place.cut_top(10);
  const Polyline& line =
      fresh ? app.session.new_outline->line
            : app.frame().contours[std::size_t(app.session.selection.contour)].line;
  Rect row = place.cut_top(28).inset(16, 0);
  const std::string points = about(line);
  write(row.cut_right(text_width(Font::caption, points) + 1), Font::caption, t.muted, points);
  write(row, Font::title, t.text, fresh ? "New outline" : "Outline");
  if (!fresh)
    fit_lines(app, place, app.frame().contours[std::size_t(app.session.selection.contour)].joint);
  place.cut_top(6);
  for (int i = 0; fresh && i < int(app.session.new_outline->joints.size()); ++i) {
    candidate_card(app, i, place.cut_top(44).inset(12, 0));
    place.cut_top(i + 1 < int(app.session.new_outline->joints.size()) ? 8 : 10);
  }
  Rect buttons = place.cut_top(34).inset(12, 0);
  command_button(app, "redraw", buttons.cut_left(buttons.w / 2 - 4));
  buttons.cut_left(8);
  command_button(app, "other_joint", buttons);
  place.cut_top(6);
  if (app.session.next.picks_joint) {
    write(place.cut_top(24).inset(16, 0), Font::caption, t.muted,
          "Click a joint, or a part in the list.");
    return;
  }
  if (fresh) return making_row(app, place);
  Rect more = place.cut_top(34).inset(12, 0);
  command_button(app, "join", more.cut_left(more.w / 2 - 4));
  more.cut_left(8);
  command_button(app, "mend", more);
  place.cut_top(8);
  Rect whose = place.cut_top(34).inset(12, 0);
  command_button(app, "held", whose.cut_left(whose.w / 2 - 4));
  whose.cut_left(8);
  command_button(app, "apart", whose);
}

}  // namespace artisketch

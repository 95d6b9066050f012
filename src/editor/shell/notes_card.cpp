// What was noticed on the way, in a card over the model: a press leads to the drawing and the part.
#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/outline/split_part.h"
#include "editor/session/command.h"
#include "editor/session/notes.h"
#include "editor/shell/panels.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

constexpr float kPad = 12, kHead = 34, kLine = 18, kBetween = 10, kDot = 20, kButton = 28;
constexpr float kIndent = 20;

// Over the model, or at the foot of the drawing where that is small.
Rect room_for_notes(const Layout& layout) {
  const Rect& at = layout.inset || layout.tablet ? layout.canvas : layout.view;
  const float width = std::min(at.w - 2 * kPad, 420.0f);
  return {at.right() - kPad - width, at.y + 48, width, at.h - 48 - kPad};
}

std::string percent_of(double scale) {
  return std::to_string(std::lround(100 * scale)) + " %";
}

// As the drawing seems to show the figure, against the first.
void take_offer(App& app, const ScaleOffer& offer) {
  app.session.proposal.reset();
  app.session.commit("Size of " + drawing_words(app.document(), offer.frame),
                     with_frame_scale(app.document(), offer.frame, offer.scale));
  app.session.show_frame(offer.frame);
}

void go_to(App& app, const PlacedWords& note) {
  if (note.frame >= 0) app.session.show_frame(note.frame);
  if (note.joint >= 0) app.session.selection.joint = note.joint;
  if (app.view.mode == Mode::result && note.frame >= 0) app.ask("mode_pose");
}

// What stands in the list: a note, or the line that unfolds what follows from the one before.
struct Row {
  PlacedWords note;
  float indent = 0;
  bool unfolds = false;
};

std::vector<Row> rows_of(const App& app) {
  std::vector<Row> rows;
  for (const Note& note : notes_of(app)) {
    rows.push_back({note});
    if (note.follow.empty()) continue;
    const std::string words = std::to_string(note.follow.size()) + " more that may follow from it";
    rows.push_back({{words, note.frame, -1}, kIndent, true});
    if (!app.session.notes_unfolded.contains(note.frame)) continue;
    for (const PlacedWords& one : note.follow) rows.push_back({one, kIndent});
  }
  return rows;
}

void fold_or_unfold(App& app, int frame) {
  std::set<int>& unfolded = app.session.notes_unfolded;
  if (unfolded.erase(frame) == 0) unfolded.insert(frame);
}

// Gives its height.
float note_row(App& app, const Row& line, Rect place) {
  const Theme& t = theme();
  const PlacedWords& note = line.note;
  place.cut_left(line.indent);
  const float tall = lines_height(Font::caption, note.words, place.w - kDot, kLine);
  place.h = tall;
  const bool leads = line.unfolds || note.frame >= 0 || note.joint >= 0;
  const bool open = line.unfolds && app.session.notes_unfolded.contains(note.frame);
  const Press press = press_area(note.words, place, leads, open);
  if (press.hovered && leads)
    draw().AddRectFilled(place.inset(-4).min(), place.inset(-4).max(), faded(t.hover, 0.5f),
                         kRadius);
  const Rect dot = place.cut_left(kDot);
  if (line.unfolds)
    write_icon({dot.x + 6, dot.y + kLine / 2}, IconSize::small, t.muted,
               open ? icon::kChevronDown : icon::kChevronRight);
  else
    draw().AddCircleFilled({dot.x + 6, dot.y + kLine / 2}, 4,
                           note.joint >= 0 ? joint_tint(note.joint) : t.warning);
  write_lines(place, Font::caption, line.unfolds ? t.muted : t.text, note.words, kLine);
  if (press.clicked && line.unfolds)
    fold_or_unfold(app, note.frame);
  else if (press.clicked)
    go_to(app, note);
  return tall;
}

}  // namespace

void notes_card(App& app, const Layout& layout) {
  if (!app.session.notes_shown) return;
  const std::vector<Row> rows = rows_of(app);
  if (rows.empty()) {
    app.session.notes_shown = false;
    return;
  }
  const Theme& t = theme();
  const Rect room = room_for_notes(layout);
  const float width = room.w - 2 * kPad - kDot;
  float needed = kPad - kBetween;
  for (const Row& row : rows)
    needed += lines_height(Font::caption, row.note.words, width - row.indent, kLine) + kBetween;
  const std::vector<ScaleOffer> offers = scale_offers(app);
  const std::vector<int> splits = split_offers(app);
  needed += float(offers.size() + splits.size()) * (kButton + kBetween);
  const float high = std::min(room.h, kHead + needed);
  const Rect place{room.x, room.bottom() - high, room.w, high};
  const FloatingCard card("Notes", place);
  Rect column = place;
  Rect head = column.cut_top(kHead).inset(kPad, 0);
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.id = "Close notes";
  if (icon_button("Close notes", head.cut_right(28).middle(28, 28), close)) app.ask("notes");
  write(head, Font::body_bold, t.text, "Notes");

  float& scroll = app.session.notes_scroll;
  if (ImGui::IsWindowHovered()) scroll -= 60 * ImGui::GetIO().MouseWheel;
  scroll = std::clamp(scroll, 0.0f, std::max(0.0f, needed - column.h));
  draw().PushClipRect(column.min(), column.max(), true);
  float y = column.y - scroll;
  // What can be mended at once comes first.
  for (const ScaleOffer& offer : offers) {
    const std::string words = "Set size in " + drawing_words(app.document(), offer.frame) + " to " +
                              percent_of(offer.scale);
    if (button(words, {column.x + kPad + kDot, y, width, kButton})) {
      take_offer(app, offer);
      break;
    }
    y += kButton + kBetween;
  }
  for (const int joint : splits) {
    if (button("Split " + part_words(app, joint) + " at a joint",
               {column.x + kPad + kDot, y, width, kButton})) {
      split_part(app, joint);
      break;
    }
    y += kButton + kBetween;
  }
  for (const Row& row : rows)
    y += note_row(app, row, {column.x + kPad, y, kDot + width, 0}) + kBetween;
  draw().PopClipRect();
}

}  // namespace artisketch

#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/templates.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/modes/outline/outline_panel.h"
#include "editor/modes/pose/pose_panel.h"
#include "editor/modes/result/export_sheet.h"
#include "editor/modes/result/motion_sheet.h"
#include "editor/modes/skeleton/skeleton_panel.h"
#include "editor/session/part_fit.h"
#include "editor/shell/panels.h"

namespace artisketch {

namespace {

// A part's colour: a disc where it is outlined, a ring where it is missing, a dash where it is
// hidden, with a triangle where it does not fit.
void paint_mark(ImVec2 at, int joint, Fit fit) {
  const Theme& t = theme();
  if (fit == Fit::hidden) {
    draw().AddLine({at.x - 4, at.y}, {at.x + 4, at.y}, t.disabled, 1.5f);
    return;
  }
  if (fit == Fit::missing) {
    draw().AddCircle(at, 4, t.disabled, 0, 1.25f);
    return;
  }
  const bool off = fit == Fit::off;
  draw().AddCircleFilled(off ? ImVec2{at.x - 1, at.y - 1} : at, off ? 4.0f : 5.0f,
                         joint_tint(joint));
  if (!off && t.dark) draw().AddCircle(at, 4.6f, rgb(0xFFFFFF, 0.18f), 0, 1);
  if (off)
    draw().AddTriangleFilled({at.x + 4.5f, at.y}, {at.x + 0.5f, at.y + 7}, {at.x + 8.5f, at.y + 7},
                             t.warning);
}

void choose(App& app, int joint, int frame) {
  if (app.session.next.picks_joint && app.has_frame()) return reassign(app, joint);
  app.session.selection.joint = joint;
  app.session.show_frame(frame);
  app.session.selection.contour = -1;
  if (!app.has_frame()) return;
  const std::vector<Contour>& contours = app.frame().contours;
  for (int i = 0; i < int(contours.size()); ++i)
    if (contours[std::size_t(i)].joint == joint) app.session.selection.contour = i;
}

void legend(Rect row, bool hidden) {
  const Theme& t = theme();
  const float gap = hidden ? 8 : 14;
  const auto entry = [&](const char* words) {
    write(row.cut_left(text_width(Font::small, words) + 1), Font::small, t.muted, words);
    row.cut_left(gap);
  };
  draw().AddCircleFilled({row.x + 5, row.centre().y}, 4, t.muted);
  row.cut_left(14);
  entry("outlined");
  draw().AddCircle({row.x + 5, row.centre().y}, 4, t.muted, 0, 1.25f);
  row.cut_left(14);
  entry("missing");
  if (hidden) {
    draw().AddLine({row.x + 1, row.centre().y}, {row.x + 9, row.centre().y}, t.muted, 1.5f);
    row.cut_left(14);
    entry("hidden");
  }
  draw().AddTriangleFilled({row.x + 5, row.centre().y - 4}, {row.x + 0.5f, row.centre().y + 4},
                           {row.x + 9.5f, row.centre().y + 4}, t.warning);
  row.cut_left(14);
  const std::string off = "does not fit";
  entry(text_width(Font::small, off) + 1 < row.w ? off.c_str() : "off");
}

// Parts by drawings: what is outlined, missing, off; a click goes there.
void matrix(App& app, Rect& place) {
  const Theme& t = theme();
  const Document& document = app.document();
  const std::vector<int> parts = parts_to_draw(document);
  const int frames = std::min(int(document.frames.size()), 8);
  constexpr float kColumn = 24, kRow = 26;
  const float first = place.right() - 14 - kColumn * float(frames);
  const float height = 24 + kRow * float(parts.size());
  if (app.has_frame() && app.session.selection.frame < frames)
    draw().AddRectFilled(
        {first + kColumn * float(app.session.selection.frame), place.y},
        {first + kColumn * float(app.session.selection.frame + 1), place.y + height},
        t.dark ? t.control : t.selection, kRadius);
  Rect heads = place.cut_top(24);
  for (int f = 0; f < frames; ++f) {
    const Rect cell{first + kColumn * float(f), heads.y, kColumn, heads.h};
    const Press press = press_area("Drawing " + std::to_string(f + 1), cell);
    const bool here = f == app.session.selection.frame;
    write(cell, here ? Font::caption_bold : Font::caption,
          here            ? t.accent
          : press.hovered ? t.text
                          : t.muted,
          std::to_string(f + 1), Align::centre);
    if (press.clicked) app.session.show_frame(f);
  }
  for (int joint : parts) {
    const Rect row = place.cut_top(kRow);
    const std::string name = document.skeleton.joints[joint].name;
    const bool chosen = joint == app.session.selection.joint;
    if (chosen)
      draw().AddRectFilled({row.x + 8, row.y}, {row.right() - 6, row.bottom()}, t.selection,
                           kRadius);
    const Press press = press_area(joint_words(name).whole(),
                                   {row.x + 8, row.y, first - row.x - 12, row.h}, true, chosen);
    if (press.hovered && !chosen)
      draw().AddRectFilled({row.x + 8, row.y}, {row.right() - 6, row.bottom()},
                           faded(t.hover, 0.5f), kRadius);
    if (press.clicked) choose(app, joint, app.session.selection.frame);
    const ImVec2 disc{row.x + 22, row.centre().y};
    draw().AddCircleFilled(disc, 6, joint_tint(joint));
    if (t.dark) draw().AddCircle(disc, 5.6f, rgb(0xFFFFFF, 0.18f), 0, 1);
    part_name({row.x + 37, row.y, first - row.x - 40, row.h}, name, chosen);
    for (int f = 0; f < frames; ++f) {
      const Rect cell{first + kColumn * float(f), row.y, kColumn, row.h};
      const Press there =
          press_area(joint_words(name).whole() + " in " + std::to_string(f + 1), cell);
      paint_mark(cell.centre(), joint, fit_of(app, joint, f));
      if (chosen && f == app.session.selection.frame)
        draw().AddCircle(cell.centre(), 6.5f, t.text, 0, 1.5f);
      if (there.hovered) tooltip(fit_in_words(app, joint, f), "");
      if (there.clicked) choose(app, joint, f);
    }
  }
}

// One drawing's parts as chips for fingers (tablets).
void part_chips(App& app, Rect place) {
  const Theme& t = theme();
  const Document& document = app.document();
  // Dragged up, the sheet shows all drawings.
  const Rect grip{place.centre().x - 60, place.y, 120, 14};
  press_area("Parts sheet", grip);
  draw().AddRectFilled({grip.centre().x - 18, grip.y + 5}, {grip.centre().x + 18, grip.y + 9},
                       t.disabled, 2);
  constexpr float kFar = 24;  // points
  if (item_dragged()) {
    const float way = ImGui::GetIO().MousePos.y - ImGui::GetIO().MouseClickedPos[0].y;
    if (std::abs(way) > kFar) app.view.all_drawings = way < 0;
  }
  Rect head = place.cut_top(52).inset(16, 8);
  Look all;
  all.icon = icon::kGrid;
  all.on = app.view.all_drawings;
  if (button("All drawings", head.cut_right(126), all))
    app.view.all_drawings = !app.view.all_drawings;
  const auto action = [&](std::string_view command, float width) {
    head.cut_right(8);
    command_button(app, command, head.cut_right(width));
  };
  if (available(app, "hidden_here")) action("hidden_here", 132);
  if (app.view.mode == Mode::outline && app.session.selection.contour >= 0) {
    action("join", 84);
    action("other_joint", 128);
    action("redraw", 104);
  }
  if (app.view.mode == Mode::pose) action("calibrate", 120);
  const std::vector<int> parts = parts_to_draw(document);
  const PartCount count =
      app.has_frame() ? count_parts(app, app.session.selection.frame) : PartCount();
  const std::string title =
      "Parts" +
      (app.has_frame() ? " in " + drawing_words(document, app.session.selection.frame) : "");
  write(head.cut_left(text_width(Font::title, title) + 12), Font::title, t.text, title);
  const std::string counted = std::to_string(count.outlined) + " of " + std::to_string(count.all);
  if (text_width(Font::caption, counted) < head.w) write(head, Font::caption, t.muted, counted);
  if (app.view.all_drawings) {
    matrix(app, place);
    return;
  }
  Rect line = place.inset(12, 4);
  float x = line.x, y = line.y;
  for (int joint : parts) {
    const std::string name = joint_words(document.skeleton.joints[joint].name).whole();
    const float width = text_width(Font::body, name) + 42;
    if (x + width > line.right()) x = line.x, y += 44;
    const Rect chip{x, y, width, 38};
    x += width + 6;
    const bool chosen = joint == app.session.selection.joint;
    const Fit fit =
        app.has_frame() ? fit_of(app, joint, app.session.selection.frame) : Fit::missing;
    const bool missing = fit == Fit::missing || fit == Fit::hidden;
    const Press press = press_area(name, chip, true, chosen);
    draw().AddRectFilled(chip.min(), chip.max(),
                         chosen          ? t.selection
                         : press.hovered ? t.hover
                                         : t.control,
                         19);
    if (chosen) draw().AddRect(chip.min(), chip.max(), t.accent, 19, 0, 1.5f);
    if (fit == Fit::hidden)
      draw().AddLine({chip.x + 13, chip.centre().y}, {chip.x + 25, chip.centre().y}, t.disabled, 2);
    else if (missing)
      draw().AddCircle({chip.x + 19, chip.centre().y}, 6, t.disabled, 0, 1.5f);
    else
      draw().AddCircleFilled({chip.x + 19, chip.centre().y}, 7, joint_tint(joint));
    write({chip.x + 32, chip.y, width - 34, chip.h}, chosen ? Font::body_bold : Font::body,
          missing ? t.muted : t.text, name);
    if (press.clicked) choose(app, joint, app.session.selection.frame);
  }
}

}  // namespace

void parts_panel(App& app, Rect place) {
  const Theme& t = theme();
  const Document& document = app.document();
  const std::vector<int> parts = parts_to_draw(document);
  int outlined = 0, all = 0;
  for (int f = 0; f < int(document.frames.size()); ++f) {
    const PartCount count = count_parts(app, f);
    outlined += count.outlined;
    all += count.all;
  }
  Rect head = place.cut_top(48).inset(16, 0);
  write(head.cut_left(text_width(Font::title, "Parts") + 8), Font::title, t.text, "Parts");
  write(head, Font::caption, t.muted,
        std::to_string(outlined) + " of " + std::to_string(all) + " outlined");
  if (parts.empty()) {
    place.cut_top(write_lines(place.inset(16, 0), Font::body, t.muted,
                              "Parts appear here with the skeleton's joints.", 20) +
                  14);
  } else {
    matrix(app, place);
    place.cut_top(10);
    const auto hides = [](const Frame& frame) { return !frame.hidden.empty(); };
    legend(place.cut_top(20).inset(16, 0),
           std::any_of(document.frames.begin(), document.frames.end(), hides));
    place.cut_top(14);
  }
  outline_panel(app, place);
}

void inspector(App& app, const Layout& layout) {
  const Theme& t = theme();
  const Panel panel("Inspector", layout.inspector, t.panel);
  if (layout.tablet) {
    hairline({layout.inspector.x, layout.inspector.y},
             {layout.inspector.right(), layout.inspector.y + 1});
    if (app.view.mapping)
      motion_sheet(app, layout.inspector);
    else if (app.view.exporting)
      export_sheet(app, layout.inspector);
    else if (app.view.mode == Mode::skeleton)
      skeleton_sheet(app, layout.inspector);
    else if (app.view.mode == Mode::pose && app.session.proposal && app.has_frame())
      proposal_sheet(app, layout.inspector);
    else if (app.view.mode == Mode::outline && app.session.new_outline)
      new_outline_sheet(app, layout.inspector);
    else
      part_chips(app, layout.inspector);
    return;
  }
  hairline({layout.inspector.x, layout.inspector.y},
           {layout.inspector.x + 1, layout.inspector.bottom()});
  if (app.view.mapping)
    motion_sheet(app, layout.inspector);
  else if (app.view.exporting)
    export_sheet(app, layout.inspector);
  else if (app.view.mode == Mode::skeleton)
    skeleton_panel(app, layout.inspector);
  else if (app.view.mode == Mode::pose)
    pose_panel(app, layout.inspector);
  else
    parts_panel(app, layout.inspector);
}

}  // namespace artisketch

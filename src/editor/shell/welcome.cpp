// The first screen: the hero moves, its drawings light up in step; how it is done; what to open.
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/session/files.h"
#include "editor/shell/panels.h"

namespace artisketch {
namespace {

void drawings_beside(App& app, Rect column) {
  const Theme& t = theme();
  const int frames = int(app.document().frames.size());
  const double duration = 1;  // seconds per key of the clip
  const float size = std::min(132.0f, (column.h + 12) / float(std::max(1, frames)) - 12);
  const int lit = int(std::lround(app.session.playback.time / duration));
  for (int f = 0; f < frames; ++f) {
    const Frame& frame = app.document().frames[std::size_t(f)];
    const Rect card = Rect{column.x, column.y, size, size};
    column.cut_top(size + 12);
    thumbnail(app, frame, card);
    draw().AddRect(card.min(), card.max(), f == lit ? t.accent : t.line, kRadius, 0,
                   f == lit ? 2.5f : 1.0f);
    constexpr float kNamed = 64;  // smaller ones show no more than the figure
    if (size < kNamed) continue;
    const std::string name = drawing_words(app.document(), f);
    const Rect label{card.x + 6, card.bottom() - 20, card.w - 9, 16};
    draw().AddRectFilled(  // legible over feet
        {label.x - 3, label.y},
        {label.x + std::min(label.w, text_width(Font::small, name)) + 3, label.bottom()},
        faded(t.paper_tint, 0.75f), kRadiusSmall);
    write(label, Font::small, rgb(0x1C2025), name);
  }
}

void step_card(App& app, const Rect& card, int number, const char* title, const char* words) {
  const Theme& t = theme();
  draw().AddRectFilled(card.min(), card.max(), t.control, kRadiusCard);
  const Rect picture = Rect{card.x + 8, card.y + 8, card.h - 16, card.h - 16};
  if (app.has_frame()) {
    const Frame& frame = app.document().frames[0];
    thumbnail(app, frame, picture, number == 2);
    if (number == 3) {
      const float zoom = std::min(picture.w / float(frame.width), picture.h / float(frame.height));
      const OnScreen on{{picture.x + (picture.w - zoom * float(frame.width)) / 2, picture.y}, zoom};
      paint_bones(draw(), app.document().skeleton, frame.pose, frame_camera(app.document(), 0), on,
                  {});
    }
  }
  Rect text = card.inset(0, 14);
  text.cut_left(card.h + 4);
  text.cut_right(12);
  Rect head = text.cut_top(24);
  draw().AddCircleFilled({head.x + 10, head.centre().y}, 10, t.accent);
  write(head.cut_left(20), Font::caption_bold, t.on_accent, std::to_string(number), Align::centre);
  head.cut_left(8);
  write(head, Font::body_bold, t.text, title);
  text.cut_top(4);
  write_lines(text, Font::caption, t.muted, words, 19);
}

// Where there is no room for cards.
void step_line(Rect row, int number, const char* title) {
  const Theme& t = theme();
  draw().AddCircleFilled({row.x + 10, row.centre().y}, 10, t.accent);
  write(row.cut_left(20), Font::caption_bold, t.on_accent, std::to_string(number), Align::centre);
  row.cut_left(8);
  write(row, Font::body_bold, t.text, title);
}

void the_steps(App& app, Rect& column, bool low) {
  struct Step {
    const char *title, *words;
  };
  constexpr Step kSteps[] = {
      {"Drop two to four drawings",
       "Any pose, any side. Sprites and scans work; so does blank paper."},
      {"Outline each part",
       "One colour per part. Trace finds the edge; Cut splits an arm at the elbow."},
      {"Pose the skeleton",
       "Drag joints until they match. Calibrate does the last bit; the model appears."}};
  constexpr float kCards = 560;  // that the column must be high for them
  if (column.h < kCards) {
    for (int i = 0; i < 3; ++i) step_line(column.cut_top(30), i + 1, kSteps[i].title);
    return;
  }
  for (int i = 0; i < 3; ++i) {
    if (i > 0) column.cut_top(12);
    step_card(app, column.cut_top(low ? 92 : 114), i + 1, kSteps[i].title, kSteps[i].words);
  }
}

void how_it_is_done(App& app, Rect column) {
  const Theme& t = theme();
  column = column.inset(30, 24);
  column.cut_top(8);
  const bool low = column.h < 720;
  const std::string last = "Get it in 3D, ready to move.";
  const Font large = text_width(Font::headline, last) < column.w ? Font::headline : Font::title;
  write(column.cut_top(32), large, t.text, "Draw it from a few sides.");
  write(column.cut_top(32), large, t.text, last);
  column.cut_top(low ? 12 : 20);
  the_steps(app, column, low);
  column.cut_top(low ? 12 : 18);
  const Rect drop = column.cut_top(low ? 92 : 110);
  draw().AddRectFilled(drop.min(), drop.max(), t.selection, kRadiusCard);
  dashed_frame(drop, kRadiusCard, t.accent);
  Rect inside = drop.inset(12, low ? 6 : 12);
  write_icon(inside.cut_top(22).centre(), IconSize::large, t.accent, icon::kImageMultiple);
  write(inside.cut_top(26), Font::body_bold, t.text, "Drop drawings anywhere", Align::centre);
  Look choose;
  choose.primary = true;
  choose.icon = icon::kFolderImage;
  if (button("Choose files", inside.middle(148, 34), choose)) app.ask("add_drawings");
  column.cut_top(14);
  Rect row = column.cut_top(38);
  const float half = (row.w - 12) / 2;
  command_button(app, "blank_drawing", row.cut_left(half));
  Look open;
  open.icon = icon::kFolderOutline;
  if (button("Open document", row.cut_right(half), open)) app.ask("open");
  if (column.h < 30) return;
  Rect foot = column.cut_bottom(24);
  write_icon({foot.x + 8, foot.centre().y}, IconSize::small, t.muted, icon::kLockOutline);
  foot.cut_left(22);
  const std::string promise = "Works offline. Your drawings never leave this computer.";
  const bool whole = text_width(Font::caption, promise) < foot.w;
  write(foot, Font::caption, t.muted, whole ? promise : "Your drawings never leave this computer.");
}

// The model that greets, and what else to open.
void hero_and_examples(App& app, const Layout& layout, Rect all, float pixel_ratio) {
  const Theme& t = theme();
  const Rect examples = all.cut_bottom(all.w < 400                      ? 124
                                       : layout.inset || layout.compact ? 100
                                                                        : 168);
  {
    const Panel panel("Hero", all, t.canvas);
    const ImU32 top = t.dark ? rgb(0x23262C) : rgb(0xEDEFF2);
    draw().AddRectFilledMultiColor(all.min(), all.max(), top, top, t.canvas, t.canvas);
    if (app.session.built) {
      Rect stage = all;
      if (layout.tablet) stage.cut_top(44);  // below its name
      const ViewProjection projection = orbit_projection(app.view.orbit, stage);
      app.session.built->picture->pose(app.shown_pose(), app.shown_footing());
      PaintOptions options;
      options.ground = true;
      options.dark = t.dark;
      show_model(*app.session.built, projection, options, app.services.model_seen, 1, pixel_ratio);
      const Press press = press_area("Turn the model", stage);
      if (press.held) {
        app.view.orbit.yaw -= 0.01 * ImGui::GetIO().MouseDelta.x;
        app.view.orbit.pitch =
            std::clamp(app.view.orbit.pitch + 0.01 * ImGui::GetIO().MouseDelta.y, -1.5, 1.5);
      }
      Rect head = all.inset(24, 0).cut_top(60);
      const std::string name = capitalised(app.document().name);
      write(head.cut_left(text_width(Font::title, name) + 10), Font::title, t.text, name);
      const int count = int(app.document().frames.size());
      const char* numbers[] = {"no", "one drawing", "two drawings", "three drawings",
                               "four drawings"};
      const std::string made =
          std::string("made from these ") + (count < 5 ? numbers[count] : "drawings");
      const std::string more = made + ". Drag to turn it, P stops it.";
      write(head, Font::caption, t.muted, text_width(Font::caption, more) < head.w ? more : made);
      drawings_beside(app, Rect{all.x + 24, all.y + 60, 132, all.h - 72});
    }
  }
  {
    const Panel panel("Examples", examples, t.panel);
    hairline({examples.x, examples.y}, {examples.right(), examples.y + 1});
    examples_row(app, examples);
  }
}

}  // namespace

void welcome(App& app, const Layout& layout, float pixel_ratio) {
  const Theme& t = theme();
  Rect all{0, layout.top.bottom(), layout.top.w,
           (layout.tablet ? layout.strip.bottom() : layout.status.y) - layout.top.bottom()};
  if (layout.tablet) all.cut_top(layout.modes.h);
  if (app.view.gallery && layout.tablet) return gallery(app, all);
  const Rect steps = layout.tablet ? all.cut_bottom(std::min(616.0f, all.h * 0.6f))
                                   : all.cut_right(layout.inset     ? 336
                                                   : layout.compact ? 400
                                                                    : 448);
  if (app.view.gallery)
    gallery(app, all);
  else
    hero_and_examples(app, layout, all, pixel_ratio);
  const Panel panel("Steps", steps, t.panel);
  hairline({steps.x, steps.y}, {steps.x + 1, steps.bottom()});
  how_it_is_done(app, steps);
}

}  // namespace artisketch

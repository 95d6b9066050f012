// The drawings in a row.
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/session/drawing_edits.h"
#include "editor/session/files.h"
#include "editor/session/part_fit.h"
#include "editor/shell/panels.h"
#include "editor/ui/menu.h"

namespace artisketch {

namespace {

void rename_drawing(App& app, int f) {
  Question question;
  question.title = "Rename drawing";
  question.words = "A name for it, or none:";
  question.asks_path = true;
  question.path = app.document().frames[std::size_t(f)].name;
  question.with_path = [&app, f](const std::string& name) {
    if (f >= int(app.document().frames.size()) ||
        name == app.document().frames[std::size_t(f)].name)
      return;
    Document next = app.document();
    next.frames[std::size_t(f)].name = name;
    app.session.commit("Rename drawing", std::move(next));
  };
  question.answers = {{"Rename", {}, true}, {"Cancel", {}}};
  app.question = std::move(question);
}

void drawing_menu(App& app, int f) {
  Menu menu;
  if (!menu) return;
  const Document& document = app.document();
  const auto move_to = [&](int to) {
    app.session.commit("Move drawing", with_frame_moved(document, f, to));
    app.session.show_frame(to);
  };
  if (menu.line("Rename drawing")) {
    rename_drawing(app, f);
  } else if (menu.line("Duplicate drawing")) {
    app.session.commit("Duplicate drawing", with_frame_copied(document, f));
    app.session.show_frame(f + 1);
  } else if (menu.line("Move left", "", f > 0)) {
    move_to(f - 1);
  } else if (menu.line("Move right", "", f + 1 < int(document.frames.size()))) {
    move_to(f + 1);
  } else if (menu.line("Replace picture")) {
    replace_picture(app, f);
  } else if (menu.line("Crop to the figure")) {
    crop_drawing(app, f);
  } else if (menu.line("Crop by hand")) {
    crop_by_hand(app, f);
  } else if (menu.line("Cut into drawings", "", app.services.drawings.of(document.frames[f]))) {
    cut_up_drawing(app, f);
  } else if (menu.line("Flip left to right")) {
    flip_drawing(app, f);
  } else if (menu.line("Turn left")) {
    turn_drawing(app, f, -1);
  } else if (menu.line("Turn right")) {
    turn_drawing(app, f, 1);
  } else if (menu.line("Remove drawing")) {
    app.session.commit("Remove drawing", without_frame(document, f));
    app.session.selection.contour = -1;
  }
}

// A card that is dragged goes where the line between two others shows.
void move_drawing(App& app, int f, const Rect& place, float step, const Press& press) {
  std::optional<int>& moving = app.session.moving_drawing;
  constexpr float kFar = 10;  // points
  if (press.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kFar)) moving = f;
  if (moving != f) return;
  const int frames = int(app.document().frames.size());
  const float by = ImGui::GetIO().MousePos.x - place.centre().x;
  const int to = std::clamp(f + int(std::lround(by / step)), 0, frames - 1);
  if (press.held) {
    const float x = place.x + float(to - f) * step + (to > f ? place.w + 4 : -4);
    if (to != f)
      draw().AddRectFilled({x - 1.5f, place.y}, {x + 1.5f, place.bottom()}, theme().accent, 1.5f);
    return;
  }
  moving.reset();
  if (to == f) return;
  app.session.commit("Move drawing", with_frame_moved(app.document(), f, to));
  app.session.show_frame(to);
}

// The document's one camera.
void camera_choice(App& app, Rect place, bool slim) {
  const bool flat = app.document().camera.type == Camera::Type::orthographic;
  if (!slim) write(place.cut_top(24), Font::caption, theme().muted, "Camera");
  Look look;
  look.hint = flat ? "Seen from afar: sizes don't change with depth. Click for perspective"
                   : "Seen from near: what is closer is larger. Click for orthographic";
  if (button(flat ? "Orthographic" : "Perspective", place.cut_top(30), look))
    app.session.commit(flat ? "Perspective camera" : "Orthographic camera",
                       with_camera_type(app.document(), flat ? Camera::Type::perspective
                                                             : Camera::Type::orthographic));
}

void card(App& app, int f, const Rect& place, bool slim, bool narrow) {
  const Theme& t = theme();
  const bool on = f == app.session.selection.frame;
  const std::string number = std::to_string(f + 1);
  const std::string name = drawing_words(app.document(), f);
  const Press press = press_area("Drawing card " + number, place, true, on);
  if (press.clicked) {
    app.session.show_frame(f);
    app.session.selection.contour = -1;
  }
  drawing_menu(app, f);
  if (!app.has_frame() || f >= int(app.document().frames.size())) return;
  move_drawing(app, f, place, place.w + 8, press);
  draw().AddRectFilled(place.min(), place.max(),
                       on              ? t.selection
                       : press.hovered ? t.hover
                                       : t.control,
                       kRadiusCard);
  if (on) draw().AddRect(place.min(), place.max(), t.accent, kRadiusCard, 0, 2);
  Rect row = place.inset(6);
  thumbnail(app, app.document().frames[std::size_t(f)], row.cut_left(row.h));
  row.cut_left(11);
  const PartCount c = count_parts(app, f);
  const float line = slim ? row.h / 2 : row.h / 3;
  Rect title = row.cut_top(line);
  if (!slim && !narrow)
    write(title.cut_left(text_width(Font::body, number) + 7), Font::body, on ? t.accent : t.muted,
          number);
  write(title, Font::body_bold, t.text, name);
  const std::string parts = std::to_string(c.outlined) + " of " + std::to_string(c.all) +
                            (slim || narrow ? "" : " parts");
  write(row.cut_top(line), Font::caption, t.muted, parts);
  if (slim) return;
  Rect mark = row.cut_top(line);
  const ImVec2 at{mark.x + 6, mark.centre().y};
  if (!is_posed(app.document(), f)) {
    write_icon(at, IconSize::small, t.warning, icon::kAlert);
    mark.cut_left(18);
    write(mark, Font::caption, t.warning, narrow ? "no pose" : "not posed yet");
  } else if (c.off > 0) {
    write_icon(at, IconSize::small, t.warning, icon::kAlert);
    mark.cut_left(18);
    write(mark, Font::caption, t.warning,
          std::to_string(c.off) + (narrow       ? " off"
                                   : c.off == 1 ? " part off"
                                                : " parts off"));
  } else if (f == 0) {
    write_icon(at, IconSize::small, t.muted, icon::kCheck);
    mark.cut_left(18);
    write(mark, Font::caption, t.muted, narrow ? "reference" : "reference pose");
  } else if (c.outlined == 0) {
    // Nothing is compared.
  } else if (f < int(app.session.live.model ? app.session.live.fits.size()
                     : app.session.built    ? app.session.built->fits.size()
                                            : 0)) {
    write_icon(at, IconSize::small, t.muted, icon::kCheck);
    mark.cut_left(18);
    write(mark, Font::caption, t.muted, "fits");
  }
}

}  // namespace

void drawing_strip(App& app, const Layout& layout) {
  const Theme& t = theme();
  const Rect place = layout.strip;
  const Panel panel("Strip", place, t.panel);
  hairline({place.x, place.y}, {place.right(), place.y + 1});
  const bool slim = place.h < 100;
  Rect row = place.inset(12, slim ? 8 : 10);
  const int frames = int(app.document().frames.size());
  float width = layout.tablet ? 168 : slim ? 168 : 208;
  // Names are whole as far as there is room.
  for (int f = 0; f < frames; ++f)
    width = std::max(
        width, std::min(232.0f, row.h + 16 + (slim || layout.tablet ? 0 : 15) +
                                    text_width(Font::body_bold, drawing_words(app.document(), f))));
  // Many drawings scroll with the wheel.
  float& scroll = app.view.strip_scroll;
  const float add = layout.tablet ? 72 : 104, camera = layout.tablet ? 104 : 130;
  const float gap = layout.tablet ? 14 : 20;
  const float needed = (width + 8) * float(frames) + add + gap + camera;
  if (ImGui::IsWindowHovered()) scroll -= 60 * ImGui::GetIO().MouseWheel;
  scroll = std::clamp(scroll, 0.0f, std::max(0.0f, needed - row.w));
  row.x -= scroll;
  for (int f = 0; f < frames && f < int(app.document().frames.size()); ++f) {
    card(app, f, {row.x, row.y, width, row.h}, slim, layout.tablet);
    row.x += width + 8;
  }
  const Rect more{row.x, row.y, add, row.h};
  Look look;
  const Press press = press_area("Add drawing", more);
  if (press.hovered)
    draw().AddRectFilled(more.min(), more.max(), faded(t.control, 0.6f), kRadiusCard);
  dashed_frame(more, kRadiusCard, t.disabled);
  write_icon({more.centre().x, more.centre().y - (slim || layout.tablet ? 0 : 10)},
             IconSize::normal, t.muted, icon::kPlus);
  if (!slim && !layout.tablet)
    write({more.x, more.centre().y + 4, more.w, 18}, Font::caption, t.muted, "Add drawing",
          Align::centre);
  if (press.clicked) app.ask("add_drawings");
  const float tall = slim ? 30 : 54;
  camera_choice(app, {more.right() + gap, row.y + (row.h - tall) / 2, camera, tall}, slim);
}

}  // namespace artisketch

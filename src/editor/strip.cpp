// The drawings in a row; in Result the timeline takes its place.
#include <cmath>

#include "document/edit.h"
#include "editor/panels.h"

namespace artisketch {

void thumbnail(const Work& work, const Frame& frame, const Rect& place, bool outlines) {
  const float zoom = std::min(place.w / float(std::max(1, frame.width)),
                              place.h / float(std::max(1, frame.height)));
  const OnScreen on{{place.x + (place.w - zoom * float(frame.width)) / 2,
                     place.y + (place.h - zoom * float(frame.height)) / 2},
                    zoom};
  draw().AddRectFilled(place.min(), place.max(), theme().paper_tint, kRadiusSmall);
  const Rect paper{on.origin.x, on.origin.y, zoom * float(frame.width), zoom * float(frame.height)};
  if (const Drawing* drawing = work.drawings.of(frame))
    show_picture(drawing->texture, paper, 1, {0, 0}, {1, 1}, theme().paper_tint);
  if (!outlines) return;
  OutlineLook look;
  look.width = 1.1f;
  look.casing = 0;
  for (const Contour& contour : frame.contours)
    paint_outline(draw(), contour.line, on, joint_tint(contour.joint), look);
}

namespace {

struct Count {
  int outlined = 0, off = 0, all = 0;
};
Count count(const Work& work, int frame) {
  Count c;
  for (int joint : parts_to_draw(work.document())) {
    const Fit fit = fit_of(work, joint, frame);
    ++c.all;
    c.outlined += fit != Fit::missing;
    c.off += fit == Fit::off;
  }
  return c;
}

// Duplicate, move, remove: on a right click, or a press that lasts.
void drawing_menu(Work& work, int f, const Press& press) {
  constexpr float kLong = 0.5f;  // seconds
  const ImGuiIO& io = ImGui::GetIO();
  if (press.held && io.MouseDownDuration[0] > kLong && !work.view.moving_drawing &&
      !ImGui::IsMouseDragging(ImGuiMouseButton_Left))
    ImGui::OpenPopup(ImGui::GetItemID());
  if (!ImGui::BeginPopupContextItem()) return;
  const Document& document = work.document();
  const auto item = [](const char* label, bool enabled) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    record(label, {at.x, at.y, ImGui::CalcTextSize(label).x + 20, ImGui::GetTextLineHeight()},
           enabled);
    return ImGui::MenuItem(("  " + std::string(label) + "  ").c_str(), nullptr, false, enabled);
  };
  const auto move_to = [&](int to) {
    work.commit("Move drawing", with_frame_moved(document, f, to));
    work.view.frame = to;
  };
  ImGui::Dummy({0, 2});
  if (item("Duplicate drawing", true)) {
    work.commit("Duplicate drawing", with_frame_copied(document, f));
    work.view.frame = f + 1;
  } else if (item("Move left", f > 0)) {
    move_to(f - 1);
  } else if (item("Move right", f + 1 < int(document.frames.size()))) {
    move_to(f + 1);
  } else if (item("Remove drawing", true)) {
    work.commit("Remove drawing", without_frame(document, f));
    work.view.contour = -1;
  }
  ImGui::Dummy({0, 2});
  ImGui::EndPopup();
}

// A card that is dragged goes where the line between two others shows.
void move_drawing(Work& work, int f, const Rect& place, float step, const Press& press) {
  std::optional<int>& moving = work.view.moving_drawing;
  constexpr float kFar = 10;  // points
  if (press.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, kFar)) moving = f;
  if (moving != f) return;
  const int frames = int(work.document().frames.size());
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
  work.commit("Move drawing", with_frame_moved(work.document(), f, to));
  work.view.frame = to;
}

// The document's one camera.
void camera_choice(Work& work, Rect place, bool slim) {
  const bool flat = work.document().camera.type == Camera::Type::orthographic;
  if (!slim) write(place.cut_top(24), Font::caption, theme().muted, "Camera");
  Look look;
  look.hint = flat ? "Seen from afar: sizes don't change with depth. Click for perspective"
                   : "Seen from near: what is closer is larger. Click for orthographic";
  if (button(flat ? "Orthographic" : "Perspective", place.cut_top(30), look))
    work.commit(flat ? "Perspective camera" : "Orthographic camera",
                with_camera_type(work.document(),
                                 flat ? Camera::Type::perspective : Camera::Type::orthographic));
}

void card(Work& work, int f, const Rect& place, bool slim, bool narrow) {
  const Theme& t = theme();
  const bool on = f == work.view.frame;
  const std::string number = std::to_string(f + 1);
  const std::string name = drawing_words(work.document(), f);
  const Press press = press_area("Drawing card " + number, place, true, on);
  if (press.clicked) {
    work.view.frame = f;
    work.view.contour = -1;
  }
  drawing_menu(work, f, press);
  if (!work.has_frame() || f >= int(work.document().frames.size())) return;
  move_drawing(work, f, place, place.w + 8, press);
  draw().AddRectFilled(place.min(), place.max(),
                       on              ? t.selection
                       : press.hovered ? t.hover
                                       : t.control,
                       kRadiusCard);
  if (on) draw().AddRect(place.min(), place.max(), t.accent, kRadiusCard, 0, 2);
  Rect row = place.inset(6);
  thumbnail(work, work.document().frames[std::size_t(f)], row.cut_left(row.h));
  row.cut_left(11);
  const Count c = count(work, f);
  const float line = slim ? row.h / 2 : row.h / 3;
  Rect title = row.cut_top(line);
  if (!slim)
    write(title.cut_left(text_width(Font::body, number) + 7), Font::body, on ? t.accent : t.muted,
          number);
  write(title, Font::body_bold, t.text, name);
  const std::string parts = std::to_string(c.outlined) + " of " + std::to_string(c.all) +
                            (slim || narrow ? "" : " parts");
  write(row.cut_top(line), Font::caption, t.muted, parts);
  if (slim) return;
  Rect mark = row.cut_top(line);
  const ImVec2 at{mark.x + 6, mark.centre().y};
  if (c.off > 0) {
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
  } else if (f < int(work.live.model ? work.live.fits.size()
                     : work.built    ? work.built->fits.size()
                                     : 0)) {
    write_icon(at, IconSize::small, t.muted, icon::kCheck);
    mark.cut_left(18);
    write(mark, Font::caption, t.muted, "fits");
  }
}

}  // namespace

void drawing_strip(Work& work, const Layout& layout) {
  const Theme& t = theme();
  const Rect place = layout.strip;
  const Panel panel("Strip", place, t.panel);
  hairline({place.x, place.y}, {place.right(), place.y + 1});
  const bool slim = place.h < 100;
  Rect row = place.inset(12, slim ? 8 : 10);
  const float width = layout.tablet ? 168 : slim ? 168 : 208;
  const int frames = int(work.document().frames.size());
  // Many drawings scroll with the wheel.
  float& scroll = work.view.strip_scroll;
  const float add = layout.tablet ? 92 : 104;
  constexpr float kCamera = 130;
  const float needed = (width + 8) * float(frames) + add + 20 + kCamera;
  if (ImGui::IsWindowHovered()) scroll -= 60 * ImGui::GetIO().MouseWheel;
  scroll = std::clamp(scroll, 0.0f, std::max(0.0f, needed - row.w));
  row.x -= scroll;
  for (int f = 0; f < frames && f < int(work.document().frames.size()); ++f) {
    card(work, f, {row.x, row.y, width, row.h}, slim, layout.tablet);
    row.x += width + 8;
  }
  const Rect more{row.x, row.y, add, row.h};
  Look look;
  const Press press = press_area("Add drawing", more);
  if (press.hovered)
    draw().AddRectFilled(more.min(), more.max(), faded(t.control, 0.6f), kRadiusCard);
  dashed_frame(more, kRadiusCard, t.disabled);
  write_icon({more.centre().x, more.centre().y - (slim ? 0 : 10)}, IconSize::normal, t.muted,
             icon::kPlus);
  if (!slim)
    write({more.x, more.centre().y + 4, more.w, 18}, Font::caption, t.muted, "Add drawing",
          Align::centre);
  if (press.clicked) work.ask(Command::add_drawings);
  const float tall = slim ? 30 : 54;
  camera_choice(work, {more.right() + 20, row.y + (row.h - tall) / 2, kCamera, tall}, slim);
}

namespace {

constexpr float kNames = 128;  // width of the clips' names

struct Ruler {
  float x = 0, per_second = 1;
  float of(double time) const { return x + float(time) * per_second; }
};

void transport(Work& work, Rect row, double length) {
  const Theme& t = theme();
  View& view = work.view;
  row = row.inset(14, 0);
  const auto to = [&](double time) {
    view.time = std::clamp(time, 0.0, length);
    view.playing = false;
    view.posed.reset();
  };
  Look look;
  look.quiet = true;
  look.icon = icon::kSkipPrevious;
  look.hint = "To the key before";
  if (icon_button("Previous key", row.cut_left(32).middle(32, 32), look))
    to(std::ceil(view.time) - 1);
  row.cut_left(6);
  Look play;
  play.primary = true;
  play.icon = view.playing ? icon::kPause : icon::kPlay;
  play.key = "Space";
  if (icon_button(view.playing ? "Pause" : "Play", row.cut_left(36).middle(36, 32), play))
    work.ask(Command::play);
  row.cut_left(6);
  look.icon = icon::kSkipNext;
  look.hint = "To the key after";
  if (icon_button("Next key", row.cut_left(32).middle(32, 32), look)) to(std::floor(view.time) + 1);
  row.cut_left(6);
  Look loop;
  loop.icon = icon::kRepeat;
  loop.on = view.looping;
  loop.quiet = true;
  loop.hint = "Play again and again";
  if (icon_button("Loop", row.cut_left(36).middle(36, 32), loop)) view.looping = !view.looping;
  row.cut_left(16);
  char now[32], of[32];
  std::snprintf(now, sizeof now, "%d:%04.1f", int(view.time) / 60, std::fmod(view.time, 60.0));
  std::snprintf(of, sizeof of, "of %d:%04.1f", int(length) / 60, std::fmod(length, 60.0));
  write(row.cut_left(48), Font::body_bold, t.text, now);
  write(row.cut_left(80), Font::caption, t.muted, of);
}

void clip_row(Work& work, int c, const Rect& row, const Ruler& ruler) {
  const Theme& t = theme();
  const Clip& clip = work.built->model.clips[std::size_t(c)];
  const bool on = c == work.view.clip;
  const Press press =
      press_area("Clip " + clip.name, {row.x + 8, row.y, kNames - 12, row.h}, true, on);
  if (press.clicked) {
    work.view.clip = c;
    work.view.time = 0;
    work.view.posed.reset();
  }
  Rect names = {row.x + 16, row.y, kNames - 20, row.h};
  if (c == 0 && row.h > 40) {
    names.y += names.h / 2 - 18;
    write(names.cut_top(18), Font::body_bold, t.text, clip.name);
    write(names.cut_top(16), Font::small, t.muted, "from the drawings");
  } else {
    write(names, on ? Font::body_bold : Font::body, t.text, clip.name);
  }
  const double end = clip.times.empty() ? 0 : clip.times.back();
  const Rect band{ruler.x, row.y + 1, row.right() - ruler.x - 16, row.h - 2};
  draw().AddRectFilled(band.min(), band.max(), t.control, kRadiusSmall);
  draw().AddRectFilled(band.min(), {ruler.of(end), band.bottom()}, on ? t.selection : t.hover,
                       kRadiusSmall);
  for (std::size_t k = 0; k < clip.times.size(); ++k) {
    const float x = ruler.of(clip.times[k]);
    if (c == 0 && k < work.document().frames.size() && row.h > 40) {
      const float size = row.h - 8;
      const Rect picture{x + 4, row.y + 4, size, size};
      thumbnail(work, work.document().frames[k], picture, false);
      if (std::abs(clip.times[k] - work.view.time) < 1e-3)
        draw().AddRect(picture.min(), picture.max(), t.accent, kRadiusSmall, 0, 2);
    } else {
      const float y = band.centre().y;
      draw().AddQuadFilled({x + 5, y - 5}, {x + 10, y}, {x + 5, y + 5}, {x, y}, t.text);
    }
  }
}

}  // namespace

void timeline(Work& work, const Layout& layout) {
  const Theme& t = theme();
  Rect place = layout.strip;
  const Panel panel("Timeline", place, t.panel);
  hairline({place.x, place.y}, {place.right(), place.y + 1});
  if (!work.built || work.built->model.clips.empty()) {
    write(place, Font::body, t.muted, "Reconstruct makes the model, and a clip of its poses.",
          Align::centre);
    return;
  }
  const std::vector<Clip>& clips = work.built->model.clips;
  double longest = 1;
  for (const Clip& clip : clips)
    if (!clip.times.empty()) longest = std::max(longest, clip.times.back());
  const std::vector<double>& times = clips[std::size_t(work.view.clip)].times;
  transport(work, place.cut_top(52), times.empty() ? 0 : times.back());
  Ruler ruler{place.x + kNames, 0};
  ruler.per_second = (place.right() - 64 - ruler.x) / float(longest);
  // The ruler, and the playhead on it.
  const Rect scale = place.cut_top(18);
  const Press press =
      press_area("Playhead", {ruler.x - 6, scale.y, place.right() - ruler.x, scale.h});
  if (press.held) {
    work.view.time = std::clamp(double((ImGui::GetIO().MousePos.x - ruler.x) / ruler.per_second),
                                0.0, times.empty() ? 0 : times.back());
    work.view.playing = false;
    work.view.posed.reset();
  }
  for (int quarter = 0; quarter <= int(longest * 4 + 0.5); ++quarter) {
    const float x = ruler.of(quarter / 4.0);
    const bool whole = quarter % 4 == 0;
    draw().AddLine({x, scale.bottom() - (whole ? 10.0f : 5.0f)}, {x, scale.bottom() - 1},
                   t.disabled);
    if (whole)
      write({x + 5, scale.y, 60, 16}, Font::small, t.muted, std::to_string(quarter / 4) + " s");
  }
  const int rows = int(clips.size());
  const float tall = std::min(48.0f, place.h - 4 - 26 * std::min(1.0f, float(rows - 1)));
  for (int c = 0; c < rows && place.h > 20; ++c)
    clip_row(work, c, place.cut_top(c == 0 ? tall : 26), ruler);
  const float x = ruler.of(work.view.time);
  draw().AddLine({x, scale.y + 4}, {x, layout.strip.bottom() - 4}, t.accent, 2);
  draw().AddRectFilled({x - 6, scale.y}, {x + 6, scale.y + 8}, t.accent, 2);
  draw().AddTriangleFilled({x - 6, scale.y + 7}, {x + 6, scale.y + 7}, {x, scale.y + 13}, t.accent);
}

}  // namespace artisketch

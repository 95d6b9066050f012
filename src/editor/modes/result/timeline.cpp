#include "editor/modes/result/timeline.h"

#include <algorithm>
#include <cmath>

#include "document/animate.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/session/motions_in.h"
#include "editor/ui/icons.h"
#include "editor/ui/menu.h"
#include "model/rig/library.h"

namespace artisketch {
namespace {

constexpr float kNames = 128;  // width of the clips' names
constexpr float kLibrary = 104;

struct Ruler {
  float x = 0, per_second = 1;
  float of(double time) const { return x + float(time) * per_second; }
};

// The time of the key before or after the playhead.
double key_beside(const App& app, bool after) {
  const std::vector<double>& times =
      app.session.built->model.clips[std::size_t(app.session.playback.clip)].times;
  constexpr double kHere = 1e-3;  // seconds
  double best = after && !times.empty() ? times.back() : 0;
  for (const double time : times) {
    if (after && time > app.session.playback.time + kHere) return time;
    if (!after && time < app.session.playback.time - kHere) best = time;
  }
  return best;
}

// The clips that come with the program and fit the skeleton.
void library_button(App& app, const Rect& place) {
  Look look;
  look.icon = icon::kPlus;
  look.hint = "Clips made for this skeleton: idle, walk and more";
  const bool opens = button("Library", place, look);
  Menu menu("Library of clips", opens);
  if (!menu) return;
  const Skeleton& skeleton = app.document().skeleton;
  for (const LibraryClip& clip : library_clips(skeleton)) {
    if (!menu.line(std::string("Add ") + clip.name)) continue;
    const Result<Clip> made = library_clip(skeleton, clip.name, {});
    if (made) add_clip(app, std::string("Add ") + clip.name, animation_of(*made));
  }
}

// What the motion that was dropped last moves.
void motion_button(App& app, const Rect& place) {
  Look look;
  look.icon = icon::kWalk;
  look.on = app.view.mapping;
  look.hint = "Which joint of the motion moves which";
  if (button("Motion", place.middle(kLibrary, 32), look)) app.view.mapping = !app.view.mapping;
}

void transport(App& app, Rect row, double length) {
  const Theme& t = theme();
  View& view = app.view;
  row = row.inset(14, 0);
  const auto to = [&](double time) {
    app.session.playback.time = std::clamp(time, 0.0, length);
    app.session.playback.playing = false;
    app.session.playback.posed.reset();
    app.session.playback.key = -1;
  };
  Look look;
  look.quiet = true;
  look.icon = icon::kSkipPrevious;
  look.hint = "To the key before";
  if (icon_button("Previous key", row.cut_left(32).middle(32, 32), look))
    to(key_beside(app, false));
  row.cut_left(6);
  Look play;
  play.primary = true;
  play.icon = app.session.playback.playing ? icon::kPause : icon::kPlay;
  play.key = "P";
  if (icon_button(app.session.playback.playing ? "Pause" : "Play", row.cut_left(36).middle(36, 32),
                  play))
    app.ask("play");
  row.cut_left(6);
  look.icon = icon::kSkipNext;
  look.hint = "To the key after";
  if (icon_button("Next key", row.cut_left(32).middle(32, 32), look)) to(key_beside(app, true));
  row.cut_left(6);
  Look loop;
  loop.icon = icon::kRepeat;
  loop.on = view.looping;
  loop.quiet = true;
  loop.hint = "Play again and again";
  if (icon_button("Loop", row.cut_left(36).middle(36, 32), loop)) view.looping = !view.looping;
  row.cut_left(16);
  char now[32], of[32];
  std::snprintf(now, sizeof now, "%d:%04.1f", int(app.session.playback.time) / 60,
                std::fmod(app.session.playback.time, 60.0));
  std::snprintf(of, sizeof of, "of %d:%04.1f", int(length) / 60, std::fmod(length, 60.0));
  write(row.cut_left(48), Font::body_bold, t.text, now);
  write(row.cut_left(80), Font::caption, t.muted, of);
  row.cut_left(16);
  if (row.w >= 104) command_button(app, "new_clip", row.cut_left(104).middle(104, 32));
  row.cut_left(8);
  if (row.w >= 96) command_button(app, "set_key", row.cut_left(96).middle(96, 32));
  row.cut_left(8);
  if (row.w >= kLibrary) library_button(app, row.cut_left(kLibrary).middle(kLibrary, 32));
  row.cut_left(8);
  if (row.w >= kLibrary && dropped_motion(app)) motion_button(app, row.cut_left(kLibrary));
}

// The keys of a clip of the document's: a click goes there, a drag moves it in time.
void keys_row(App& app, int c, const Rect& band, const Ruler& ruler) {
  const Theme& t = theme();
  const int animation = c - 1;
  const Clip clip = app.session.built->model.clips[std::size_t(c)];  // a gesture makes them anew
  for (int k = 0; k < int(clip.times.size()); ++k) {
    const ImVec2 at{ruler.of(clip.times[std::size_t(k)]), band.centre().y};
    const bool chosen = c == app.session.playback.clip && k == app.session.playback.key;
    const Press press = press_area("Key " + std::to_string(k + 1) + " of " + clip.name,
                                   {at.x - 8, band.y, 16, band.h}, true, chosen);
    if (ImGui::IsItemActivated()) {
      app.session.begin_gesture();
      app.session.playback.clip = c;
      app.session.playback.key = k;
      app.session.playback.time = clip.times[std::size_t(k)];
      app.session.playback.playing = false;
      app.session.playback.posed.reset();
    }
    const float size = chosen || press.hovered ? 6.5f : 5;
    draw().AddQuadFilled({at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                         {at.x - size, at.y}, chosen ? t.accent : t.text);
    if (press.hovered && !press.held) tooltip("Drag in time; Delete removes the key", "");
    if (!item_dragged()) continue;
    const double time =
        std::round((ImGui::GetIO().MousePos.x - ruler.x) / ruler.per_second / kLeastStep) *
        kLeastStep;
    app.session.change("Move key of " + clip.name,
                       with_key_moved(app.document(), animation, k, time));
    if (animation < int(app.document().animations.size()))
      app.session.playback.time =
          app.document().animations[std::size_t(animation)].keys[std::size_t(k)].time;
    return;  // the clips are others by now
  }
}

// Whether the clip is gone.
bool clip_menu(App& app, int c) {
  Menu menu;
  if (!menu || !menu.line("Remove clip")) return false;
  const std::string name = app.document().animations[std::size_t(c - 1)].name;
  app.session.commit("Remove " + name, without_clip(app.document(), c - 1));
  return true;
}

void clip_row(App& app, int c, const Rect& row, const Ruler& ruler) {
  const Theme& t = theme();
  const Clip clip = app.session.built->model.clips[std::size_t(c)];
  const bool on = c == app.session.playback.clip;
  const Press press =
      press_area("Clip " + clip.name, {row.x + 8, row.y, kNames - 12, row.h}, true, on);
  if (press.clicked) {
    app.session.playback.clip = c;
    app.session.playback.time = 0;
    app.session.playback.key = -1;
    app.session.playback.posed.reset();
  }
  if (c > 0 && clip_menu(app, c)) return;
  Rect names = {row.x + 16, row.y, kNames - 20, row.h};
  if (c == 0 && row.h > 40) {
    names.y += names.h / 2 - 18;
    write_name(names.cut_top(18), Font::body_bold, t.text, clip.name);
    write(names.cut_top(16), Font::small, t.muted, "from the drawings");
  } else {
    write_name(names, on ? Font::body_bold : Font::body, t.text, clip.name);
  }
  const double end = clip.times.empty() ? 0 : clip.times.back();
  const Rect band{ruler.x, row.y + 1, row.right() - ruler.x - 16, row.h - 2};
  draw().AddRectFilled(band.min(), band.max(), t.control, kRadiusSmall);
  draw().AddRectFilled(band.min(), {ruler.of(end), band.bottom()}, on ? t.selection : t.hover,
                       kRadiusSmall);
  for (std::size_t k = 0; k < clip.times.size(); ++k) {
    const float x = ruler.of(clip.times[k]);
    if (c == 0 && k < app.document().frames.size() && row.h > 40) {
      const float size = row.h - 8;
      const Rect picture{x + 4, row.y + 4, size, size};
      thumbnail(app, app.document().frames[k], picture, false);
      if (std::abs(clip.times[k] - app.session.playback.time) < 1e-3)
        draw().AddRect(picture.min(), picture.max(), t.accent, kRadiusSmall, 0, 2);
    } else if (c == 0) {
      const float y = band.centre().y;
      draw().AddQuadFilled({x, y - 5}, {x + 5, y}, {x, y + 5}, {x - 5, y}, t.text);
    }
  }
  if (c > 0) keys_row(app, c, band, ruler);
}

// The clips' rows: the drawings' stays, the others go by the wheel, and to one just chosen.
void rows_of_clips(App& app, Rect place, const Ruler& ruler) {
  constexpr float kRow = 26;
  const int rows = int(app.session.built->model.clips.size());
  if (place.h <= 20) return;
  const float tall = std::min(48.0f, place.h - 4 - kRow * std::min(1.0f, float(rows - 1)));
  clip_row(app, 0, place.cut_top(tall), ruler);
  place.cut_bottom(2);
  Playback& playback = app.session.playback;
  const int fit = std::max(1, int(place.h / kRow));
  if (playback.followed != playback.clip) {
    playback.followed = playback.clip;
    if (playback.clip > 0)
      playback.first_row = std::clamp(playback.first_row, playback.clip - fit, playback.clip - 1);
  }
  Rect names = place;
  names.w -= 8;
  const Rows shown = scrolled_rows(playback.first_row, rows - 1, kRow, names);
  for (int c = shown.first + 1; c < shown.end + 1 && c < int(app.session.built->model.clips.size());
       ++c)
    clip_row(app, c, place.cut_top(kRow), ruler);
}

}  // namespace

void timeline(App& app, const Layout& layout) {
  const Theme& t = theme();
  Rect place = layout.strip;
  const Panel panel("Timeline", place, t.panel);
  hairline({place.x, place.y}, {place.right(), place.y + 1});
  if (!app.session.built || app.session.built->model.clips.empty()) {
    write(place, Font::body, t.muted, "Reconstruct makes the model, and a clip of its poses.",
          Align::centre);
    return;
  }
  const std::vector<Clip>& clips = app.session.built->model.clips;
  double longest = 1;
  for (const Clip& clip : clips)
    if (!clip.times.empty()) longest = std::max(longest, clip.times.back());
  const bool own = app.session.playback.clip > 0;
  const std::vector<double>& times = clips[std::size_t(app.session.playback.clip)].times;
  const double length = times.empty() ? 0 : times.back();
  // One's own clip may grow: the playhead goes a little beyond its end.
  if (own) longest = std::max(longest, length + 1);
  const double reach = own ? longest : length;
  transport(app, place.cut_top(52), length);
  Ruler ruler{place.x + kNames, 0};
  ruler.per_second = (place.right() - 64 - ruler.x) / float(longest);
  // The ruler, and the playhead on it.
  const Rect scale = place.cut_top(18);
  const Press press =
      press_area("Playhead", {ruler.x - 6, scale.y, place.right() - ruler.x, scale.h});
  if (press.held) {
    app.session.playback.time =
        std::clamp(double((ImGui::GetIO().MousePos.x - ruler.x) / ruler.per_second), 0.0, reach);
    app.session.playback.playing = false;
    app.session.playback.key = -1;
    app.session.playback.posed.reset();
  }
  for (int quarter = 0; quarter <= int(longest * 4 + 0.5); ++quarter) {
    const float x = ruler.of(quarter / 4.0);
    const bool whole = quarter % 4 == 0;
    draw().AddLine({x, scale.bottom() - (whole ? 10.0f : 5.0f)}, {x, scale.bottom() - 1},
                   t.disabled);
    if (whole)
      write({x + 5, scale.y, 60, 16}, Font::small, t.muted, std::to_string(quarter / 4) + " s");
  }
  rows_of_clips(app, place, ruler);
  const float x = ruler.of(app.session.playback.time);
  draw().AddLine({x, scale.y + 4}, {x, layout.strip.bottom() - 4}, t.accent, 2);
  draw().AddRectFilled({x - 6, scale.y}, {x + 6, scale.y + 8}, t.accent, 2);
  draw().AddTriangleFilled({x - 6, scale.y + 7}, {x + 6, scale.y + 7}, {x, scale.y + 13}, t.accent);
}

}  // namespace artisketch

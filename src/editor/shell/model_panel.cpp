// The model from all sides: orbit, pan, zoom; its surfaces and bones; posing by dragging joints.
#include <cmath>

#include "base/words.h"
#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/session/command.h"
#include "editor/session/notes.h"
#include "editor/session/part_fit.h"
#include "editor/shell/panels.h"

namespace artisketch {

namespace {

// Moves what is looked at with the pointer; points.
void pan(Orbit& orbit, ImVec2 by, const ViewProjection& projection) {
  const Mat3 turn = orbit.turn();
  const ImVec2 target = projection.project(orbit.target),
               beside = projection.project(orbit.target + turn.row(0).transpose());
  const double unit = 1 / std::max(1e-6, double(apart(target, beside)));  // that a point takes
  orbit.target -= unit * (by.x * turn.row(0) - by.y * turn.row(1)).transpose();
}

// Whether it was tapped.
bool navigate(Orbit& orbit, const Fingers& fingers, const ViewProjection& projection,
              const Rect& place, bool free_to_turn) {
  const ImGuiIO& io = ImGui::GetIO();
  if (fingers.count > 0 && place.holds(fingers.at)) {
    pan(orbit, fingers.moved, projection);
    orbit.distance /= fingers.spread;
    return false;
  }
  const Press press = press_area("Turn the model", place);
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
                       place.holds(io.MousePos);
  if (hovered && io.MouseWheel != 0) orbit.distance *= std::pow(0.9, io.MouseWheel);
  const bool panning = hovered && (ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) ||
                                   (press.held && (io.KeyShift || pan_key_held())));
  if (panning) {
    pan(orbit, io.MouseDelta, projection);
  } else if (press.held && free_to_turn) {
    orbit.yaw -= 0.01 * io.MouseDelta.x;
    orbit.pitch = std::clamp(orbit.pitch + 0.01 * io.MouseDelta.y, -1.5, 1.5);
  }
  return press.clicked && free_to_turn && !pointer_dragged();
}

void paint_joints(const App& app, const ViewProjection& projection,
                  const std::vector<Vec3>& joints) {
  const Skeleton& skeleton = app.shown()->model.skeleton;
  for (int j = 1; j < skeleton.size(); ++j)
    draw().AddLine(projection.project(joints[std::size_t(skeleton.joints[j].parent)]),
                   projection.project(joints[std::size_t(j)]), rgb(0xFFFFFF, 0.85f), 1.5f);
  for (int j = 0; j < skeleton.size(); ++j) {
    const ImVec2 p = projection.project(joints[std::size_t(j)]);
    if (j == app.session.selection.joint) draw().AddCircle(p, 9, theme().accent, 0, 2);
    draw().AddCircleFilled(p, 4, rgb(0xFFFFFF));
    draw().AddCircleFilled(p, 2.75f, joint_tint(j));
  }
}

// Which way is up: three short axes.
void paint_axes(const ViewProjection& projection, ImVec2 centre) {
  struct Axis {
    Vec3 direction;
    unsigned colour;
    const char* name;
  };
  Axis axes[] = {{Vec3::UnitX(), 0xE05A6A, "x"},
                 {Vec3::UnitY(), 0x67B552, "y"},
                 {Vec3::UnitZ(), 0x4A90E2, "z"}};
  for (Axis& axis : axes) axis.direction = projection.turn * axis.direction;
  std::sort(std::begin(axes), std::end(axes),
            [](const Axis& a, const Axis& b) { return a.direction.z() < b.direction.z(); });
  for (const Axis& axis : axes) {
    constexpr float kLength = 19;
    const ImVec2 tip{centre.x + kLength * float(axis.direction.x()),
                     centre.y - kLength * float(axis.direction.y())};
    draw().AddLine(centre, tip, rgb(axis.colour), 2);
    draw().AddCircleFilled(tip, 6.5f, rgb(axis.colour));
    write({tip.x - 6, tip.y - 7, 12, 13}, Font::small, rgb(0xFFFFFF), axis.name, Align::centre);
  }
}

void model_head(App& app, const Layout& layout) {
  const Theme& t = theme();
  Rect row = layout.view_head.inset(16, 8);
  row.w += 8;
  View& view = app.view;
  Look bones;
  bones.icon = icon::kBone;
  bones.on = view.model_bones;
  bones.quiet = true;
  bones.hint = "Show the model's skeleton";
  bones.enabled = app.shown() != nullptr;
  if (icon_button("Model skeleton", row.cut_right(32).middle(32, 30), bones))
    view.model_bones = !view.model_bones;
  struct Choice {
    Surface surface;
    const char* label;
    const char* icon;
    const char* hint;
  };
  constexpr Choice kChoices[] = {
      {Surface::weights, "Weights", icon::kPalette,
       "Which joint moves what; the chosen part alone"},
      {Surface::wireframe, "Wireframe", icon::kGrid, "The triangles"},
      {Surface::shaded, "Shaded", icon::kCubeOutline, "The bare shape"},
      {Surface::textured, "Textured", icon::kImage, "With the drawings' colours"}};
  for (const Choice& choice : kChoices) {
    row.cut_right(2);
    Look look;
    look.icon = choice.icon;
    look.hint = choice.hint;
    look.quiet = true;
    look.enabled = app.shown() != nullptr;
    look.on = app.shown() && view.surface == choice.surface;
    if (icon_button(choice.label, row.cut_right(32).middle(32, 30), look))
      view.surface = choice.surface;
  }
  const char* title = view.mode == Mode::result ? "Model" : "Live model";
  write(row.cut_left(text_width(Font::body_bold, title) + 1), Font::body_bold, t.text, title);
  row.cut_left(8);
  std::string about;
  if (view.mode == Mode::result && app.session.built && !app.session.built->model.clips.empty()) {
    char seconds[32];
    const Clip& clip = app.session.built->model.clips[std::size_t(app.session.playback.clip)];
    std::snprintf(seconds, sizeof seconds, ", %.1f s", clip.times.empty() ? 0 : clip.times.back());
    about = app.session.playback.posed ? "your pose" : clip.name + seconds;
  } else if (app.shows_parts()) {
    about = app.session.proposal && app.session.proposal->theirs() ? "parts, calibrated"
                                                                   : "parts, your pose";
  } else if (app.session.built && app.has_frame()) {
    about = "as in " + drawing_words(app.document(), app.session.selection.frame);
  }
  // Where the whole doesn't fit, nothing says it: its beginning alone tells nothing.
  if (text_width(Font::caption, about) <= row.w) write(row, Font::caption, t.muted, about);
}

void model_foot(App& app, const Rect& band) {
  const Theme& t = theme();
  Rect row = band.inset(16, 0);
  if (!app.shown()) return;
  if (const int notes = count_notes(app); notes > 0) {
    const std::string label = counted(notes, "note");
    Look look;
    look.quiet = true;
    look.on = app.session.notes_shown;
    look.hint = command(app, "notes").about;
    const float width = text_width(Font::body, label) + 20;
    if (button(label, row.cut_right(width).middle(width, 28), look)) app.ask("notes");
    row.cut_right(8);
  }
  const BuiltModel& built = *app.shown();
  int off = 0;
  for (int joint : drawn_joints(app.document()))
    if (app.has_frame() && fit_of(app, joint, app.session.selection.frame) == Fit::off) ++off;
  std::string words;
  std::string trust;
  bool good = true;
  if (app.view.mode == Mode::result && app.session.stale()) {
    words = "Changed since the model was made.";
    good = false;
  } else if (app.view.mode == Mode::result) {
    words = in_thousands(int(built.model.mesh.F.rows())) + " triangles, " +
            std::to_string(built.model.skeleton.size()) +
            (built.model.skeleton.size() == 1 ? " joint" : " joints") +
            (built.model.texture ? ", 1 texture" : "");
    trust = trust_in_words(app, -1);
  } else if (off > 0) {
    words = std::to_string(off) +
            (off == 1 ? " part does not fit this drawing" : " parts do not fit this drawing");
    good = false;
  } else if (app.shows_parts()) {
    words = std::to_string(app.session.live.parts.size()) +
            (app.session.live.parts.size() == 1 ? " part. " : " parts. ") +
            "Reconstruct joins them.";
  } else if (!is_posed(app.document(), app.session.selection.frame)) {
    words = "This drawing isn't posed yet, and not used";
    good = false;
  } else if (app.session.selection.frame < int(built.fits.size())) {
    words = "Fills " +
            std::to_string(int(built.fits[std::size_t(app.session.selection.frame)].iou * 100)) +
            " % of this drawing";
  }
  if (words.empty()) return;
  write_icon({row.x + 6, row.centre().y}, IconSize::small, good ? t.muted : t.warning,
             good ? icon::kCheck : icon::kAlert);
  row.cut_left(18);
  record(words, row);
  write(row, Font::caption, good ? t.muted : t.warning, words);
  row.cut_left(text_width(Font::caption, words) + 16);
  if (trust.empty() || text_width(Font::caption, trust) > row.w) return;
  record(trust, row);
  write(row, Font::caption, t.muted, trust);
}

// What Result's tool in hand does with the pointer, and shows; gives whether it has the pointer,
// which else turns the view.
bool use_tool(App& app, const ViewProjection& projection, const Pose& pose, const Vec3& shift) {
  ModelStage model{projection, pose, shift, {}};
  for (const Transform& joint : posed_joints(app.shown()->model.skeleton, pose))
    model.joints.push_back(joint.translation() + shift);
  const bool result = app.session.built && app.view.mode == Mode::result;
  if (result) {
    const Pointer p = pointer_on_model();
    const Stage stage{projection.place, {}, &model};
    app.tool().pointer(app, p, stage);
    app.tool().paint(app, p, stage);
  }
  if (app.view.model_bones || (result && app.tool().shows_bones()))
    paint_joints(app, projection, model.joints);
  return result && app.tool().holds_pointer();
}

void ground_shade(const Rect& place, bool floating) {
  const Theme& t = theme();
  const ImU32 top = t.dark ? rgb(0x23262C) : rgb(0xEDEFF2), bottom = t.dark ? t.canvas : t.canvas;
  if (floating) return;  // its corners are round: the panel's own ground
  draw().AddRectFilledMultiColor(place.min(), place.max(), top, top, bottom, bottom);
}

void nothing_yet(const App& app, const Rect& place) {
  const Theme& t = theme();
  Rect column = place.middle(std::min(240.0f, place.w - 24), 90);
  write_icon(column.cut_top(28).centre(), IconSize::large, t.disabled, icon::kCubeOutline);
  column.cut_top(8);
  const bool outlines = !drawn_joints(app.document()).empty();
  const std::string words = outlines ? "Reconstruct makes the model" : "The model appears here";
  column.cut_top(write_lines(column, Font::body, t.muted, words, 20, Align::centre));
  constexpr const char* kWhen = "once a part is outlined";
  if (!outlines && lines_height(Font::caption, kWhen, column.w, 18) <= column.h)  // not on phones
    write_lines(column, Font::caption, t.disabled, kWhen, 18, Align::centre);
}

}  // namespace

void model_panel(App& app, const Layout& layout, float pixel_ratio) {
  const Theme& t = theme();
  Rect place = layout.view;
  const bool inset = layout.inset && !layout.swapped;
  const float radius = inset ? kRadiusPanel : 0;
  const Panel panel("Model", place, t.canvas, inset ? Panel::Layer::floating : Panel::Layer::base,
                    radius);
  ground_shade(place, inset);
  const BuiltModel* shown = app.shown();
  if (!shown) {
    nothing_yet(app, place);
    if (!inset) model_head(app, layout);
    return;
  }
  const ViewProjection projection = orbit_projection(app.view.orbit, place);
  const Pose pose = app.shown_pose();
  const Vec3 shift = app.shown_footing();
  shown->picture->pose(pose, shift);
  PaintOptions options;
  options.surface = app.view.surface;
  options.joint = app.session.selection.joint;
  // Parts have their joints' colours rather than the drawings'.
  if (app.shows_parts() && options.surface == Surface::textured) {
    options.surface = Surface::weights;
    options.joint = -1;
  }
  options.ground = true;
  options.rough = app.services.hurried;
  options.dark = t.dark;
  show_model(*shown, projection, options, app.services.model_seen, 1, pixel_ratio, radius);

  const bool grabbed = use_tool(app, projection, pose, shift);
  Rect turning = place;
  const bool bands = !layout.tablet && !inset;
  if (bands)
    turning = {place.x, layout.view_head.bottom(), place.w,
               layout.view_foot.y - layout.view_head.bottom()};
  const bool tapped = navigate(app.view.orbit, app.fingers, projection, turning, !grabbed);
  paint_axes(projection,
             {place.right() - 38, bands ? layout.view_foot.y - 16 : place.bottom() - 40});
  if (inset) {
    draw().AddRect(place.min(), place.max(), t.line, kRadiusPanel);
    write_icon({place.right() - 22, place.y + 22}, IconSize::normal, t.text, icon::kFullscreen);
    record("Enlarge the model", {place.right() - 44, place.y, 44, 44});
    if (tapped) app.view.swap();
    write({place.x + 14, place.y + 10, 150, 18}, Font::caption_bold, t.text,
          app.view.mode == Mode::result ? "Model" : "Live model");
    return;
  }
  model_head(app, layout);
  if (bands) model_foot(app, layout.view_foot);
}

}  // namespace artisketch

// The sketch: drawing, model, outlines and bones of one frame, to pan and zoom.
#include <algorithm>
#include <cmath>
#include <limits>

#include "document/edit.h"
#include "editor/modes/outline/outline_commands.h"
#include "editor/shell/panels.h"

namespace artisketch {
namespace {

constexpr float kFitMargin = 0, kMinZoom = 0.05f, kMaxZoom = 40;

void zoom_about(View& view, ImVec2 about, float factor) {
  const float zoom = std::clamp(view.zoom * factor, kMinZoom, kMaxZoom);
  const float k = zoom / view.zoom;
  view.origin = {about.x + k * (view.origin.x - about.x), about.y + k * (view.origin.y - about.y)};
  view.zoom = zoom;
  view.fit = false;
}

void fit(View& view, const Frame& frame, const Rect& place) {
  const Rect inner = place.inset(kFitMargin);
  view.zoom = std::min(inner.w / float(frame.width), inner.h / float(frame.height));
  view.origin = {inner.x + (inner.w - view.zoom * float(frame.width)) / 2,
                 inner.y + (inner.h - view.zoom * float(frame.height)) / 2};
}

// What shows of the figure, in pixels of the sketch.
struct Figure {
  std::vector<Vec2> outlines, joints;
};
Figure figure_of(const Work& work) {
  Figure figure;
  for (const Contour& contour : work.frame().contours)
    figure.outlines.insert(figure.outlines.end(), contour.line.points.begin(),
                           contour.line.points.end());
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  for (const Transform& joint : posed_joints(work.document().skeleton, work.drawn_pose()))
    if (camera.in_front(joint.translation()))
      figure.joints.push_back(camera.project(joint.translation()));
  return figure;
}

// Which share of the points lies under one of the places.
double share_under(const std::vector<Rect>& places, const std::vector<Vec2>& points,
                   const OnScreen& on) {
  if (points.empty()) return 0;
  std::size_t under = 0;
  for (const Vec2& p : points) {
    const ImVec2 at = on.of(p);
    under += std::any_of(places.begin(), places.end(),
                         [&](const Rect& place) { return place.holds(at); });
  }
  return double(under) / double(points.size());
}

// On tablets tools and model float over the canvas: the drawing goes where they cover least of the
// figure, a little smaller if need be.
void fit_between(Work& work, const Layout& layout) {
  View& view = work.view;
  const Rect& place = layout.canvas;
  const ImVec2 size{place.w, place.h};
  if (view.fitted_frame == view.frame && view.fitted_mode == view.mode &&
      view.fitted_size.x == size.x && view.fitted_size.y == size.y)
    return;
  view.fitted_frame = view.frame;
  view.fitted_mode = view.mode;
  view.fitted_size = size;
  fit(view, work.frame(), place);
  std::vector<Rect> floating{rail_place(work, layout), layout.view, layout.canvas_head};
  if (const std::optional<Rect> card = missing_card_place(work, layout)) floating.push_back(*card);
  if (view.mode == Mode::pose)
    for (const Rect& inset : pose_inset_places(layout)) floating.push_back(inset);
  const Figure figure = figure_of(work);
  constexpr float kShares[] = {0.5f, 0.4f, 0.6f, 0.25f, 0.75f, 0, 1};
  constexpr double kSmaller = 0.4, kAside = 0.01;  // as bad as covering so much of the figure
  const float whole = view.zoom;
  double best = std::numeric_limits<double>::infinity();
  for (const float scale : {1.0f, 0.95f, 0.9f, 0.85f, 0.8f})
    for (const float across : kShares)
      for (const float down : kShares) {
        const float zoom = whole * scale;
        const OnScreen on{{place.x + across * (place.w - zoom * float(work.frame().width)),
                           place.y + down * (place.h - zoom * float(work.frame().height))},
                          zoom};
        const double cost = share_under(floating, figure.outlines, on) +
                            share_under(floating, figure.joints, on) + kSmaller * (1 - scale) +
                            kAside * (std::abs(across - 0.5) + std::abs(down - 0.5));
        if (cost < best) best = cost, view.zoom = on.zoom, view.origin = on.origin;
      }
}

// Wheel zooms at the pointer; the middle button, or two fingers, pan.
void navigate(Work& work, const Rect& place) {
  View& view = work.view;
  const Fingers& fingers = work.fingers;
  const ImGuiIO& io = ImGui::GetIO();
  if (fingers.count > 0 && place.holds(fingers.at)) {
    view.origin.x += fingers.moved.x;
    view.origin.y += fingers.moved.y;
    zoom_about(view, fingers.at, fingers.spread);
    return;
  }
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) ||
      !place.holds(io.MousePos))
    return;
  if (io.MouseWheel != 0 && !wheel_twists(work, {view.origin, view.zoom}))
    zoom_about(view, io.MousePos, std::pow(1.15f, io.MouseWheel));
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0)) {
    view.origin.x += io.MouseDelta.x;
    view.origin.y += io.MouseDelta.y;
    view.fit = false;
  }
}

void paint_outlines(const Work& work, const OnScreen& on) {
  const View& view = work.view;
  const Frame& frame = work.frame();
  const bool editing = view.mode == Mode::outline && view.contour >= 0;
  for (int i = 0; i < int(frame.contours.size()); ++i) {
    const Contour& contour = frame.contours[std::size_t(i)];
    const bool chosen = editing ? i == view.contour : contour.joint == view.joint;
    OutlineLook look;
    look.width = chosen && view.mode == Mode::outline ? 3 : 2;
    look.opacity = editing && !chosen ? 0.55f : 1;
    look.fill = view.mode == Mode::outline ? (chosen ? 0.16f : 0.10f) : 0;
    if (view.mode == Mode::pose) look.width = 1.25f, look.casing = 0.75f;
    paint_outline(draw(), contour.line, on, joint_tint(contour.joint), look);
  }
}

void paint_model(Work& work, const FrameCamera& camera, const OnScreen& on, const Rect& place,
                 float pixel_ratio) {
  const Built& shown = *work.shown();
  const std::vector<Clip>& clips = shown.model.clips;
  if (clips.empty() || work.view.frame >= int(clips[0].poses.size())) return;
  const Pose& pose = clips[0].poses[std::size_t(work.view.frame)];
  // In Pose the model stands as the person has it, so that what does not fit shows; while nothing
  // has changed since, as it was made.
  const Pose drawn = work.drawn_pose();
  const bool posing = work.view.mode == Mode::pose && !work.as_built();
  const bool theirs =
      (posing || work.shows_parts()) && drawn.rotations.size() == pose.rotations.size();
  shown.picture->pose(theirs ? drawn : pose, Vec3::Zero());
  const Eye eye = sketch_eye(camera, on.origin, on.zoom, place);
  PaintOptions options;
  options.dark = theme().dark;
  options.rough = work.hurried;
  if (work.shows_parts()) options.surface = Surface::weights;
  show_model(shown, eye, options, work.over_sketch, work.view.layer().model_opacity, pixel_ratio);
}

// A lock beside each joint whose turn the calibration keeps.
void paint_locks(const Work& work, const FrameCamera& camera, const OnScreen& on) {
  const std::vector<Transform> posed = posed_joints(work.document().skeleton, work.drawn_pose());
  for (const int joint : work.document().calibration.locked) {
    const Vec3 place = posed[std::size_t(joint)].translation();
    if (!camera.in_front(place)) continue;
    const ImVec2 p = on.of(camera.project(place));
    const ImVec2 at{p.x + 15, p.y - 13};
    draw().AddCircleFilled(at, 11, rgb(0x1C2025, 0.9f));
    draw().AddCircle(at, 11, rgb(0xFFFFFF, 0.9f), 0, 1.25f);
    write_icon(at, IconSize::small, rgb(0xFFFFFF), icon::kLockOutline);
  }
}

void paint_sketch(Work& work, const Rect& place, float pixel_ratio) {
  const View& view = work.view;
  const Frame& frame = work.frame();
  const OnScreen on{view.origin, view.zoom};
  const Rect paper{view.origin.x, view.origin.y, view.zoom * float(frame.width),
                   view.zoom * float(frame.height)};
  draw().AddRectFilled(paper.min(), paper.max(), theme().paper_tint);
  const Layers& layers = view.layer();
  const Drawing* drawing = work.drawings.of(frame);
  const float opacity = view.mode == Mode::skeleton ? 0.3f : layers.drawing_opacity;
  if (drawing && layers.drawing)
    show_picture(drawing->texture, paper, opacity, {0, 0}, {1, 1}, theme().paper_tint);
  // The calibrated document may have found another scale for the frame.
  const FrameCamera camera = frame_camera(work.document(), view.frame);
  if (const Built* shown = layers.model ? work.shown() : nullptr) {
    const bool same = view.frame < int(shown->document.frames.size());
    paint_model(work, same ? frame_camera(shown->document, view.frame) : camera, on, place,
                pixel_ratio);
  }
  if (layers.outlines) paint_outlines(work, on);
  if (view.mode == Mode::pose) paint_fit_marks(work, on);
  if (layers.bones) {
    BonesLook look;
    look.tapered = view.mode == Mode::pose || view.mode == Mode::skeleton;
    look.chosen = view.mode == Mode::outline ? -1 : view.joint;
    if (work.proposal) {
      BonesLook other;
      other.faint = true;
      const Pose& faint = work.proposal->theirs()
                              ? frame.pose
                              : work.proposal->document.frames[std::size_t(view.frame)].pose;
      paint_bones(draw(), work.document().skeleton, faint, camera, on, other);
    }
    paint_bones(draw(), work.document().skeleton, work.drawn_pose(), camera, on, look);
    if (view.mode == Mode::pose) paint_locks(work, camera, on);
  }
  if (view.mode == Mode::pose) paint_fit_tag(work, place, on);
}

void head(Work& work, const Layout& layout) {
  const Theme& t = theme();
  Rect row = layout.canvas_head;
  const int frames = int(work.document().frames.size());
  const std::string name = work.has_frame() ? drawing_words(work.document(), work.view.frame) : "";
  const std::string of = std::to_string(work.view.frame + 1) + " of " + std::to_string(frames);
  if (layout.tablet) {
    const float width = text_width(Font::body_bold, name) + 9 + text_width(Font::caption, of);
    row = row.middle(std::clamp(width + 104, row.w, layout.canvas.w - 184), row.h);
    draw().AddRectFilled(row.min(), row.max(), faded(t.panel, 0.95f), kRadiusPanel);
    command_icon(work, Command::previous_drawing, row.cut_left(44));
    command_icon(work, Command::next_drawing, row.cut_right(44));
    Rect middle = row.middle(std::min(width, row.w), row.h);
    write(middle.cut_left(text_width(Font::body_bold, name) + 8), Font::body_bold, t.text, name);
    write(middle, Font::caption, t.muted, of);
    return;
  }
  row = row.inset(10, 8);
  if (frames > 0) {
    command_icon(work, Command::previous_drawing, row.cut_left(28).middle(28, 28));
    row.cut_left(6);
    const float width = std::min(text_width(Font::body_bold, name) + 1, 160.0f);
    write(row.cut_left(width), Font::body_bold, t.text, name);
    row.cut_left(8);
    write(row.cut_left(text_width(Font::caption, of) + 2), Font::caption, t.muted, of);
    row.cut_left(6);
    command_icon(work, Command::next_drawing, row.cut_left(28).middle(28, 28));
  }
  Layers& layers = work.view.layer();
  const auto toggle = [&](const char* label, const char* hint, const char* icon, bool& on,
                          const std::string& key, bool enabled) {
    Look look;
    look.icon = icon;
    look.on = on && enabled;
    look.quiet = true;
    look.hint = hint;
    look.key = key;
    look.enabled = enabled;
    if (icon_button(label, row.cut_right(32).middle(32, 30), look)) on = !on;
    row.cut_right(2);
  };
  toggle("Show model", "Lay the model over the drawing", icon::kCubeOutline, layers.model, "G",
         work.shown() != nullptr);
  toggle("Show bones", "Show the skeleton", icon::kBone, layers.bones, "B", true);
  toggle("Show outlines", "Show the outlines", icon::kVectorCurve, layers.outlines, "", true);
  toggle("Show drawing", "Show the drawing", icon::kImage, layers.drawing, "H", true);
}

void foot(Work& work, const Layout& layout) {
  const Theme& t = theme();
  Rect row = layout.canvas_foot.inset(16, 0);
  Layers& layers = work.view.layer();
  const float length = layout.compact ? 80 : 110;
  if (work.view.mode != Mode::skeleton) {
    write(row.cut_left(48), Font::caption, t.muted, "Drawing");
    row.cut_left(8);
    slider("Drawing opacity", row.cut_left(length), layers.drawing_opacity, 0, 1);
    row.cut_left(24);
    if (layers.model && work.shown()) {
      write(row.cut_left(38), Font::caption, t.muted, "Model");
      row.cut_left(8);
      slider("Model opacity", row.cut_left(length), layers.model_opacity, 0, 1);
    }
  }
  command_icon(work, Command::fit, row.cut_right(28).middle(28, 28));
  row.cut_right(4);
  command_icon(work, Command::zoom_in, row.cut_right(28).middle(28, 28));
  write(row.cut_right(52), Font::caption, t.text,
        std::to_string(int(std::lround(work.view.zoom * 100))) + " %", Align::centre);
  command_icon(work, Command::zoom_out, row.cut_right(28).middle(28, 28));
}

// Where an outline crosses itself, with what puts it right.
void crossing_chips(Work& work, const Rect& place) {
  const Theme& t = theme();
  const OnScreen on{work.view.origin, work.view.zoom};
  int wanted = -2;
  for (const CrossingMark& mark : crossing_marks(work)) {
    const ImVec2 at = on.of(mark.at);
    draw().AddCircle(at, 9, t.error, 0, 2);
    constexpr const char* kWords = "Crosses itself";
    const float words = text_width(Font::caption, kWords);
    // Below the mark, clear of the chip that a new outline carries at its side.
    Rect chip{at.x - (words + 84) / 2, at.y + (mark.contour < 0 ? 40.0f : 14.0f), words + 84, 32};
    chip.x = std::clamp(chip.x, place.x + 4, std::max(place.x + 4, place.right() - chip.w - 4));
    chip.y = std::min(chip.y, place.bottom() - 36);
    shadow(chip, kRadius);
    draw().AddRectFilled(chip.min(), chip.max(), t.raised, kRadius);
    Rect row = chip.inset(10, 4);
    write(row.cut_left(words + 10), Font::caption, t.error, kWords);
    Look look;
    look.id = mark.contour < 0 ? "Mend new" : "Mend " + std::to_string(mark.contour + 1);
    look.hint = words_of(Command::mend).hint;
    if (button("Mend", row, look)) wanted = mark.contour;
  }
  if (wanted >= -1) mend(work, wanted);
}

// The blank page: what to do first.
void invitation(Work& work, const Rect& place) {
  const Theme& t = theme();
  const Rect card = place.middle(std::min(360.0f, place.w - 32), 180);
  dashed_frame(card, kRadiusPanel, t.accent);
  Rect column = card.inset(20);
  write_icon(column.cut_top(32).centre(), IconSize::large, t.accent, icon::kImageMultiple);
  column.cut_top(8);
  write(column.cut_top(24), Font::title, t.text, "Drop a drawing, or just draw.", Align::centre);
  column.cut_top(16);
  Rect row = column.cut_top(36);
  Look primary;
  primary.primary = true;
  const float half = (row.w - 8) / 2;
  command_button(work, Command::add_drawings, row.cut_left(half), primary);
  command_button(work, Command::blank_drawing, row.cut_right(half));
}

// Beside a large model (tablets): to look at, and to tap.
void as_inset(Work& work, const Rect& place, float pixel_ratio) {
  const Theme& t = theme();
  fit(work.view, work.frame(), place.inset(8));
  paint_sketch(work, place, pixel_ratio);
  draw().AddRect(place.min(), place.max(), t.line, kRadiusPanel);
  const ImVec2 corner{place.right() - 22, place.y + 22};
  draw().AddCircleFilled(corner, 16, faded(t.panel, 0.85f));
  write_icon(corner, IconSize::normal, t.text, icon::kFullscreen);
  if (press_area("Enlarge the drawing", place).clicked) work.view.swap();
}

}  // namespace

void canvas(Work& work, const Layout& layout, float pixel_ratio) {
  const Theme& t = theme();
  Rect whole = layout.canvas;
  if (!layout.tablet) {
    whole.y = layout.canvas_head.y;
    whole.h = layout.canvas_foot.bottom() - whole.y;
  }
  const Panel panel("Canvas", whole, t.canvas,
                    layout.swapped ? Panel::Layer::floating : Panel::Layer::base,
                    layout.swapped ? kRadiusPanel : 0);
  const Rect place = layout.canvas;
  if (!work.has_frame()) {
    invitation(work, place);
    return;
  }
  if (layout.swapped) return as_inset(work, place, pixel_ratio);
  if (!work.view.fit)
    work.view.fitted_frame = -1;
  else if (layout.tablet)
    fit_between(work, layout);
  else
    fit(work.view, work.frame(), place);
  navigate(work, place);
  draw().PushClipRect(place.min(), place.max(), true);
  paint_sketch(work, place, pixel_ratio);
  if (work.view.mode == Mode::pose) pose_insets(work, layout, pixel_ratio);
  // The marks' buttons come before the tool, in whose place they lie, and are drawn over it.
  draw().ChannelsSplit(2);
  draw().ChannelsSetCurrent(1);
  if (work.view.mode == Mode::outline) crossing_chips(work, place);
  draw().ChannelsSetCurrent(0);
  Rect clear = place;
  if (layout.tablet) clear.cut_left(rail_place(work, layout).right() - place.x);
  canvas_menu(work, clear, {work.view.origin, work.view.zoom});
  use_tool(work, place, clear, {work.view.origin, work.view.zoom});
  draw().ChannelsMerge();
  draw().PopClipRect();
  head(work, layout);
  if (!layout.tablet) {
    foot(work, layout);
    hairline({whole.right() - 1, whole.y}, {whole.right(), whole.bottom()});
  }
}

}  // namespace artisketch

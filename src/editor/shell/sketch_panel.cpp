// The sketch: drawing, model, outlines and bones of one frame, to pan and zoom.
#include <algorithm>
#include <cmath>
#include <limits>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/modes/outline/copy_to.h"
#include "editor/modes/outline/missing_card.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/modes/outline/outline_edits.h"
#include "editor/modes/pose/fit_paint.h"
#include "editor/modes/pose/pose_insets.h"
#include "editor/shell/panels.h"

namespace artisketch {
namespace {

constexpr float kMinZoom = 0.05f, kMaxZoom = 40;

void zoom_about(SketchPlace& sketch, ImVec2 about, float factor) {
  const float zoom = std::clamp(sketch.zoom * factor, kMinZoom, kMaxZoom);
  const float k = zoom / sketch.zoom;
  sketch.origin = {about.x + k * (sketch.origin.x - about.x),
                   about.y + k * (sketch.origin.y - about.y)};
  sketch.zoom = zoom;
  sketch.fit = false;
}

void fit(SketchPlace& sketch, const Frame& frame, const Rect& place) {
  sketch.zoom = std::min(place.w / float(frame.width), place.h / float(frame.height));
  sketch.origin = {place.x + (place.w - sketch.zoom * float(frame.width)) / 2,
                   place.y + (place.h - sketch.zoom * float(frame.height)) / 2};
}

// Of a place for the drawing what it is to take: about a figure that fills its picture joints and
// outlines have room, too.
Rect with_room(const App& app, const Rect& place) {
  constexpr float kRoom = 32;  // points
  const Drawing* drawing = app.services.drawings.of(app.frame());
  return drawing && drawing->full ? place.inset(kRoom) : place;
}

// What shows of the figure, in pixels of the sketch.
struct Figure {
  std::vector<Vec2> outlines, joints;
};
Figure figure_of(const App& app) {
  Figure figure;
  for (const Contour& contour : app.frame().contours)
    figure.outlines.insert(figure.outlines.end(), contour.line.points.begin(),
                           contour.line.points.end());
  const FrameCamera camera = frame_camera(app.document(), app.session.selection.frame);
  for (const Transform& joint : posed_joints(app.document().skeleton, app.drawn_pose()))
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

// What floats over the drawing.
std::vector<Rect> floating_places(const App& app, const Layout& layout) {
  const Rect rail = rail_place(app, layout);
  std::vector<Rect> places;
  if (layout.inset) places.push_back(layout.view);
  if (layout.tablet) places.insert(places.end(), {rail, layout.canvas_head});
  if (app.view.mode == Mode::pose)
    for (const Rect& inset : pose_inset_places(layout, rail)) places.push_back(inset);
  return places;
}

// Where tools and model float over the canvas the drawing goes where they cover least of the
// figure, a little smaller if need be.
void fit_between(App& app, const Layout& layout) {
  View& view = app.view;
  const Rect place = with_room(app, layout.canvas);
  const ImVec2 size{place.w, place.h};
  if (view.sketch.fitted_frame == app.session.selection.frame &&
      view.sketch.fitted_mode == view.mode && view.sketch.fitted_size.x == size.x &&
      view.sketch.fitted_size.y == size.y)
    return;
  view.sketch.fitted_frame = app.session.selection.frame;
  view.sketch.fitted_mode = view.mode;
  view.sketch.fitted_size = size;
  fit(app.view.sketch, app.frame(), place);
  std::vector<Rect> floating = floating_places(app, layout);
  if (const std::optional<Rect> card = missing_card_place(app, layout)) floating.push_back(*card);
  const Figure figure = figure_of(app);
  constexpr float kShares[] = {0.5f, 0.4f, 0.6f, 0.25f, 0.75f, 0, 1};
  constexpr double kSmaller = 0.4, kAside = 0.01;  // as bad as covering so much of the figure
  const float whole = view.sketch.zoom;
  double best = std::numeric_limits<double>::infinity();
  for (const float scale : {1.0f, 0.95f, 0.9f, 0.85f, 0.8f})
    for (const float across : kShares)
      for (const float down : kShares) {
        const float zoom = whole * scale;
        const OnScreen on{{place.x + across * (place.w - zoom * float(app.frame().width)),
                           place.y + down * (place.h - zoom * float(app.frame().height))},
                          zoom};
        const double cost = share_under(floating, figure.outlines, on) +
                            share_under(floating, figure.joints, on) + kSmaller * (1 - scale) +
                            kAside * (std::abs(across - 0.5) + std::abs(down - 0.5));
        if (cost < best) best = cost, view.sketch.zoom = on.zoom, view.sketch.origin = on.origin;
      }
}

bool tool_takes_wheel(const App& app, const Rect& place) {
  Pointer p;
  p.screen = ImGui::GetIO().MousePos;
  return app.tool().takes_wheel(app, p, {place, app.view.sketch.on()});
}

// Two fingers on a trackpad scroll both ways, and in pieces of a notch; after a pause the next
// scroll may be a wheel's again. A wheel with Ctrl, and pinching, which comes as that, zoom in any
// case.
bool scrolls(View& view, double now) {
  constexpr float kWheel = 0.5f;  // notches: a wheel gives whole ones
  constexpr double kPause = 0.4;  // seconds
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.KeySuper) return false;
  if (io.MouseWheelH == 0 && io.MouseWheel == 0) return false;
  const bool piece = io.MouseWheelH != 0 || std::abs(io.MouseWheel) < kWheel;
  if (!piece && now - view.scrolled_at > kPause) return false;
  view.scrolled_at = now;
  return true;
}

// The wheel zooms at the pointer; the middle button, a drag with Space held, or two fingers pan.
void navigate(App& app, const Rect& place) {
  View& view = app.view;
  const Fingers& fingers = app.fingers;
  const ImGuiIO& io = ImGui::GetIO();
  if (fingers.count > 0 && place.holds(fingers.at)) {
    view.sketch.origin.x += fingers.moved.x;
    view.sketch.origin.y += fingers.moved.y;
    zoom_about(view.sketch, fingers.at, fingers.spread);
    return;
  }
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) ||
      !place.holds(io.MousePos))
    return;
  if (scrolls(view, app.services.now)) {
    constexpr float kNotch = 60;  // points
    view.sketch.origin.x += kNotch * io.MouseWheelH;
    view.sketch.origin.y += kNotch * io.MouseWheel;
    view.sketch.fit = false;
  } else if (io.MouseWheel != 0 && !tool_takes_wheel(app, place)) {
    zoom_about(view.sketch, io.MousePos, std::pow(1.15f, io.MouseWheel));
  }
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) ||
      (view.panning && pointer_holds() && pointer_moved())) {
    view.sketch.origin.x += io.MouseDelta.x;
    view.sketch.origin.y += io.MouseDelta.y;
    view.sketch.fit = false;
  }
}

void paint_outlines(const App& app, const OnScreen& on) {
  const View& view = app.view;
  const Frame& frame = app.frame();
  const bool editing = view.mode == Mode::outline && app.session.selection.contour >= 0;
  for (int i = 0; i < int(frame.contours.size()); ++i) {
    const Contour& contour = frame.contours[std::size_t(i)];
    const bool chosen =
        editing ? i == app.session.selection.contour : contour.joint == app.session.selection.joint;
    OutlineLook look;
    look.width = chosen && view.mode == Mode::outline ? 3 : 2;
    look.opacity = editing && !chosen ? 0.55f : 1;
    look.fill = view.mode == Mode::outline ? (chosen ? 0.16f : 0.10f) : 0;
    if (view.mode == Mode::pose) look.width = 1.25f, look.casing = 0.75f;
    paint_outline(draw(), contour.line, on, joint_tint(contour.joint), look);
  }
}

void paint_model(App& app, const FrameCamera& camera, const OnScreen& on, const Rect& place,
                 float pixel_ratio) {
  const BuiltModel& shown = *app.shown();
  const std::vector<Clip>& clips = shown.model.clips;
  if (clips.empty() || app.session.selection.frame >= int(clips[0].poses.size())) return;
  const Pose& pose = clips[0].poses[std::size_t(app.session.selection.frame)];
  // In Pose the model stands as the person has it, so that what does not fit shows; while nothing
  // has changed since, as it was made.
  const Pose drawn = app.drawn_pose();
  const bool posing = app.view.mode == Mode::pose && !app.session.as_built();
  const bool theirs =
      (posing || app.shows_parts()) && drawn.rotations.size() == pose.rotations.size();
  shown.picture->pose(theirs ? drawn : pose, Vec3::Zero());
  const ViewProjection projection = sketch_projection(camera, on.origin, on.zoom, place);
  PaintOptions options;
  options.dark = theme().dark;
  options.rough = app.services.hurried;
  if (app.shows_parts()) options.surface = Surface::weights;
  show_model(shown, projection, options, app.services.over_sketch, app.view.layer().model_opacity,
             pixel_ratio);
}

// A lock beside each joint whose turn the calibration keeps.
void paint_locks(const App& app, const FrameCamera& camera, const OnScreen& on) {
  const std::vector<Transform> posed = posed_joints(app.document().skeleton, app.drawn_pose());
  for (const int joint : app.document().calibration.locked) {
    const Vec3 place = posed[std::size_t(joint)].translation();
    if (!camera.in_front(place)) continue;
    const ImVec2 p = on.of(camera.project(place));
    const ImVec2 at{p.x + 15, p.y - 13};
    draw().AddCircleFilled(at, 11, rgb(0x1C2025, 0.9f));
    draw().AddCircle(at, 11, rgb(0xFFFFFF, 0.9f), 0, 1.25f);
    write_icon(at, IconSize::small, rgb(0xFFFFFF), icon::kLockOutline);
  }
}

void paint_sketch(App& app, const Rect& place, float pixel_ratio) {
  const View& view = app.view;
  const Frame& frame = app.frame();
  const OnScreen on = app.view.sketch.on();
  const Rect paper{view.sketch.origin.x, view.sketch.origin.y,
                   view.sketch.zoom * float(frame.width), view.sketch.zoom * float(frame.height)};
  const Layers& layers = view.layer();
  const Drawing* drawing = app.services.drawings.of(frame);
  draw().AddRectFilled(paper.min(), paper.max(), ground_of(drawing));
  const float opacity = view.mode == Mode::skeleton ? 0.3f : layers.drawing_opacity;
  if (drawing && layers.drawing)
    show_picture(drawing->texture, paper, opacity, {0, 0}, {1, 1}, theme().paper_tint);
  // The calibrated document may have found another scale for the frame.
  const FrameCamera camera = frame_camera(app.document(), app.session.selection.frame);
  if (const BuiltModel* shown = layers.model ? app.shown() : nullptr) {
    const bool same = app.session.selection.frame < int(shown->document.frames.size());
    paint_model(app, same ? frame_camera(shown->document, app.session.selection.frame) : camera, on,
                place, pixel_ratio);
  }
  if (layers.outlines) paint_outlines(app, on);
  if (view.mode == Mode::pose) paint_fit_marks(app, on);
  if (layers.bones) {
    BonesLook look;
    look.tapered = view.mode == Mode::pose || view.mode == Mode::skeleton;
    look.chosen = view.mode == Mode::outline ? -1 : app.session.selection.joint;
    if (app.session.proposal) {
      BonesLook other;
      other.faint = true;
      const Pose& faint =
          app.session.proposal->theirs()
              ? frame.pose
              : app.session.proposal->document.frames[std::size_t(app.session.selection.frame)]
                    .pose;
      paint_bones(draw(), app.document().skeleton, faint, camera, on, other);
    }
    paint_bones(draw(), app.document().skeleton, app.drawn_pose(), camera, on, look);
    if (view.mode == Mode::pose) paint_locks(app, camera, on);
  }
  if (view.mode == Mode::pose || view.mode == Mode::skeleton) record_joints(app, on);
}

void sketch_head(App& app, const Layout& layout) {
  const Theme& t = theme();
  Rect row = layout.canvas_head;
  const int frames = int(app.document().frames.size());
  const std::string name =
      app.has_frame() ? drawing_words(app.document(), app.session.selection.frame) : "";
  const std::string of =
      std::to_string(app.session.selection.frame + 1) + " of " + std::to_string(frames);
  if (layout.tablet) {
    const float width = text_width(Font::body_bold, name) + 9 + text_width(Font::caption, of);
    row = row.middle(std::clamp(width + 104, row.w, layout.canvas.w - 184), row.h);
    draw().AddRectFilled(row.min(), row.max(), faded(t.panel, 0.95f), kRadiusPanel);
    command_icon(app, "previous_drawing", row.cut_left(44));
    command_icon(app, "next_drawing", row.cut_right(44));
    Rect middle = row.middle(std::min(width, row.w), row.h);
    write(middle.cut_left(text_width(Font::body_bold, name) + 8), Font::body_bold, t.text, name);
    write(middle, Font::caption, t.muted, of);
    return;
  }
  row = row.inset(10, 8);
  if (frames > 0) {
    command_icon(app, "previous_drawing", row.cut_left(28).middle(28, 28));
    row.cut_left(6);
    const float width = std::min(text_width(Font::body_bold, name) + 1, 160.0f);
    write(row.cut_left(width), Font::body_bold, t.text, name);
    row.cut_left(8);
    write(row.cut_left(text_width(Font::caption, of) + 2), Font::caption, t.muted, of);
    row.cut_left(6);
    command_icon(app, "next_drawing", row.cut_left(28).middle(28, 28));
  }
  const auto toggle = [&](const char* label, std::string_view id, bool enabled = true) {
    const Command& row_of = command(app, id);
    Look look = command_look(app, row_of);
    look.on = look.on && enabled;
    look.enabled = enabled;
    look.quiet = true;
    if (icon_button(label, row.cut_right(32).middle(32, 30), look)) app.ask(row_of.id);
    row.cut_right(2);
  };
  toggle("Show model", "show_model", app.shown() != nullptr);
  toggle("Show bones", "show_bones");
  toggle("Show outlines", "show_outlines");
  toggle("Show drawing", "show_drawing");
}

void sketch_foot(App& app, const Layout& layout) {
  const Theme& t = theme();
  Rect row = layout.canvas_foot.inset(16, 0);
  Layers& layers = app.view.layer();
  const auto wide = [](const char* words, float least) {
    return std::max(least, text_width(Font::caption, words) + 1);
  };
  const float drawing = wide("Drawing", 48), model = wide("Model", 38);
  const float words = drawing + 8 + 24 + model + 8;
  constexpr float kZoom = 144, kApart = 8;
  const float length =
      std::clamp((row.w - kZoom - words - kApart) / 2, 32.0f, layout.compact ? 80.0f : 110.0f);
  if (app.view.mode != Mode::skeleton) {
    write(row.cut_left(drawing), Font::caption, t.muted, "Drawing");
    row.cut_left(8);
    slider("Drawing opacity", row.cut_left(length), layers.drawing_opacity, 0, 1);
    row.cut_left(24);
    if (layers.model && app.shown()) {
      write(row.cut_left(model), Font::caption, t.muted, "Model");
      row.cut_left(8);
      slider("Model opacity", row.cut_left(length), layers.model_opacity, 0, 1);
    }
  }
  command_icon(app, "fit", row.cut_right(28).middle(28, 28));
  row.cut_right(4);
  command_icon(app, "zoom_in", row.cut_right(28).middle(28, 28));
  write(row.cut_right(52), Font::caption, t.text,
        std::to_string(int(std::lround(app.view.sketch.zoom * 100))) + " %", Align::centre);
  command_icon(app, "zoom_out", row.cut_right(28).middle(28, 28));
}

// Where an outline crosses itself, with what puts it right.
void crossing_chips(App& app, const Rect& place) {
  const Theme& t = theme();
  const OnScreen on = app.view.sketch.on();
  int wanted = -2;
  for (const CrossingMark& mark : crossing_marks(app)) {
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
    look.hint = command(app, "mend").about;
    if (button("Mend", row, look)) wanted = mark.contour;
  }
  if (wanted >= -1) mend(app, wanted);
}

// A joint is meant by a press on it; with a tool whose line may begin there, by a click.
bool takes_offer(const App& app, const Pointer& p) {
  constexpr float kStays = 4;  // points that a click moves
  const float farthest = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left];
  return app.tool().draws_lines() ? p.released && farthest < kStays * kStays : p.pressed;
}

// What the tool in hand does with the pointer, and shows.
//   clear  where no other tools float over the place
void use_tool(App& app, const Rect& place, const Rect& clear) {
  const Stage stage{place, app.view.sketch.on()};
  Pointer p = pointer_on_sketch(place, stage.on);
  if (p.pressed) app.view.panning = pan_key_held();
  if (p.hovered && pan_key_held()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  const bool over = p.released;
  if (app.view.panning || (!p.held && pan_key_held()))
    p.hovered = p.pressed = p.held = p.released = p.dragging = p.double_clicked = false;
  if (over) app.view.panning = false;
  if (app.view.mode == Mode::result) return;  // its tools work on the model
  const bool outlining = app.view.mode == Mode::outline;
  const Offer offer = outlining ? offer_under(app, p, stage) : Offer();
  if (offer.part >= 0) paint_offer(app, offer, p);
  if (offer.part >= 0 && takes_offer(app, p)) {
    if (app.tool().under_way()) app.tool().cancel(app);
    reassign(app, offer.part);
    p.pressed = p.held = p.released = p.dragging = false;
  }
  app.tool().pointer(app, p, stage);
  app.tool().paint(app, p, stage);
  const std::optional<NewOutline>& pending = app.session.new_outline;
  if (!outlining || !pending || pending->frame != app.session.selection.frame) return;
  paint_pending(app, clear, stage.on);
  answer_pending(app, p);
}

// The blank page: what to do first.
void invitation(App& app, const Rect& place) {
  const Theme& t = theme();
  constexpr const char* kTitle = "Drop a drawing, or just draw.";
  constexpr float kPad = 20, kLine = 24, kButton = 36, kBetween = 8, kRoundWords = 52;
  const float width = std::min(360.0f, place.w - 32), inner = width - 2 * kPad;
  const float half = (inner - kBetween) / 2;
  // Long words take a line each.
  bool beside = true;
  for (const char* id : {"add_drawings", "blank_drawing"})
    beside &= text_width(Font::body_bold, command(app, id).name) + kRoundWords <= half;
  const float title = lines_height(Font::title, kTitle, inner, kLine);
  const Rect card = place.middle(width, 156 + title + (beside ? 0 : kBetween + kButton));
  dashed_frame(card, kRadiusPanel, t.accent);
  Rect column = card.inset(kPad);
  write_icon(column.cut_top(32).centre(), IconSize::large, t.accent, icon::kImageMultiple);
  column.cut_top(8);
  write_lines(column.cut_top(title), Font::title, t.text, kTitle, kLine, Align::centre);
  column.cut_top(16);
  Rect row = column.cut_top(kButton);
  Look primary;
  primary.primary = true;
  command_button(app, "add_drawings", beside ? row.cut_left(half) : row, primary);
  column.cut_top(kBetween);
  command_button(app, "blank_drawing", beside ? row.cut_right(half) : column.cut_top(kButton));
}

// A stroke where no drawing is begins a blank sheet, and goes on there.
void draw_on_nothing(App& app, const Rect& place) {
  Pointer p = pointer_on_sketch(place, app.view.sketch.on());
  if (!p.pressed || app.view.mode != Mode::outline) return;
  perform(app, "blank_drawing");
  if (!app.has_frame()) return;
  fit(app.view.sketch, app.frame(), place);
  app.take_up(Mode::outline, "draw");
  const Stage stage{place, app.view.sketch.on()};
  p.at = stage.on.back(p.screen);
  app.tool().pointer(app, p, stage);
}

// Beside a large model (tablets): to look at, and to tap.
void as_inset(App& app, const Rect& place, float pixel_ratio) {
  const Theme& t = theme();
  fit(app.view.sketch, app.frame(), place.inset(8));
  paint_sketch(app, place, pixel_ratio);
  draw().AddRect(place.min(), place.max(), t.line, kRadiusPanel);
  const ImVec2 corner{place.right() - 22, place.y + 22};
  draw().AddCircleFilled(corner, 16, faded(t.panel, 0.85f));
  write_icon(corner, IconSize::normal, t.text, icon::kFullscreen);
  if (press_area("Enlarge the drawing", place).clicked) app.view.swap();
}

}  // namespace

void sketch_panel(App& app, const Layout& layout, float pixel_ratio) {
  const Theme& t = theme();
  Rect whole = layout.canvas;
  if (!layout.tablet && !layout.swapped) {
    whole.y = layout.canvas_head.y;
    whole.h = layout.canvas_foot.bottom() - whole.y;
  }
  const Panel panel("Canvas", whole, t.canvas,
                    layout.swapped ? Panel::Layer::floating : Panel::Layer::base,
                    layout.swapped ? kRadiusPanel : 0);
  const Rect place = layout.canvas;
  if (!app.has_frame()) {
    Rect free = place;  // tablets: beside the rail, which floats there
    if (layout.tablet) free.cut_left(rail_place(app, layout).right() - place.x);
    invitation(app, free);
    draw_on_nothing(app, free);
    return;
  }
  if (layout.swapped) return as_inset(app, place, pixel_ratio);
  if (!app.view.sketch.fit)
    app.view.sketch.fitted_frame = -1;
  else if (layout.inset)
    fit_between(app, layout);
  else
    fit(app.view.sketch, app.frame(), with_room(app, place));
  navigate(app, place);
  draw().PushClipRect(place.min(), place.max(), true);
  paint_sketch(app, place, pixel_ratio);
  if (app.view.mode == Mode::pose)
    paint_fit_tag(app, place, floating_places(app, layout), app.view.sketch.on());
  if (app.view.mode == Mode::pose) pose_insets(app, layout, rail_place(app, layout), pixel_ratio);
  // The marks' buttons come before the tool, in whose place they lie, and are drawn over it.
  draw().ChannelsSplit(2);
  draw().ChannelsSetCurrent(1);
  if (app.view.mode == Mode::outline) crossing_chips(app, place), copy_menu(app, place);
  draw().ChannelsSetCurrent(0);
  Rect clear = place;
  if (layout.tablet) clear.cut_left(rail_place(app, layout).right() - place.x);
  canvas_menu(app, clear, app.view.sketch.on());
  use_tool(app, place, clear);
  draw().ChannelsMerge();
  draw().PopClipRect();
  sketch_head(app, layout);
  if (!layout.tablet) {
    sketch_foot(app, layout);
    hairline({whole.right() - 1, whole.y}, {whole.right(), whole.bottom()});
  }
}

}  // namespace artisketch

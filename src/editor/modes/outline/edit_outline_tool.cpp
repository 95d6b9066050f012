// Edit: chooses outlines, and moves, bends and adds to their points.
#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/modes/outline/outline_edits.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/theme.h"

namespace artisketch {
namespace {

// Only points some way apart on screen are handles: a traced outline has hundreds.
std::vector<int> handles_of(const Polyline& line, const OnScreen& on) {
  constexpr float kApart = 14;
  std::vector<int> result;
  for (int i = 0; i < int(line.points.size()); ++i)
    if (result.empty() || apart(on.of(line.points[std::size_t(result.back())]),
                                on.of(line.points[std::size_t(i)])) >= kApart)
      result.push_back(i);
  return result;
}

// The points within a handle's reach follow it, less the farther along the line they are.
std::vector<Vec2> dragged(bool closed, const std::vector<Vec2>& from, int point, const Vec2& by,
                          double reach) {
  std::vector<Vec2> points = from;
  const int n = int(points.size());
  points[std::size_t(point)] += by;
  for (int way : {1, -1}) {
    double along = 0;
    for (int k = 1; k < n; ++k) {
      const int i = point + way * k;
      if (!closed && (i < 0 || i >= n)) break;
      const std::size_t here = std::size_t((i % n + n) % n),
                        before = std::size_t(((i - way) % n + n) % n);
      along += (from[here] - from[before]).norm();
      if (along >= reach) break;
      const double t = along / reach, weight = (1 - t * t) * (1 - t * t);
      points[here] += weight * by;
    }
  }
  return points;
}

class EditOutlineTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    app.session.selection.point = p.hovered ? handle_under(app, p, stage) : -1;
    if (p.pressed) take_hold(app, p, stage);
    if (p.double_clicked && add_point(app, p, stage)) return;
    if (point_ >= 0) return move(app, p, stage);
    if (p.pressed) choose(app, p, stage);
  }

  void paint(const App& app, const Pointer& p, const Stage& stage) const override {
    const Contour* contour = chosen(app);
    if (!contour) return;
    Polyline shown{{}, contour->line.closed};
    for (int i : handles_of(contour->line, stage.on))
      shown.points.push_back(contour->line.points[std::size_t(i)]);
    paint_points(shown, stage.on, joint_tint(contour->joint), p.screen);
  }

  std::string hint(const App&) const override {
    return "Click an outline, drag its points.  Double-click adds a point, Delete removes it.";
  }

  void cancel(App& app) override { app.session.selection.point = point_ = -1; }
  bool gives_outlines() const override { return true; }

 private:
  static const Contour* chosen(const App& app) {
    const int contour = app.session.selection.contour;
    return contour < 0 ? nullptr : &app.frame().contours[std::size_t(contour)];
  }

  static int handle_under(const App& app, const Pointer& p, const Stage& stage) {
    const Contour* contour = chosen(app);
    if (!contour) return -1;
    int under = -1;
    float best = kReach;
    for (int i : handles_of(contour->line, stage.on)) {
      const float distance = apart(stage.on.of(contour->line.points[std::size_t(i)]), p.screen);
      if (distance < best) best = distance, under = i;
    }
    return under;
  }

  // Of a point, or of an edge, which bends where it is held.
  void take_hold(App& app, const Pointer& p, const Stage& stage) {
    gesture_ = app.session.begin_gesture();
    point_ = -1;
    const Contour* contour = chosen(app);
    if (!contour) return;
    from_ = p.at;
    points_ = contour->line.points;
    point_ = app.session.selection.point;
    const OnLine edge = nearest_on(contour->line, stage.on, p.screen);
    if (point_ >= 0 || edge.distance >= kReach || p.double_clicked) return;
    point_ = int(edge.segment) + 1;
    points_.insert(points_.begin() + point_, p.at);
  }

  bool add_point(App& app, const Pointer& p, const Stage& stage) {
    const Contour* contour = chosen(app);
    if (!contour || app.session.selection.point >= 0) return false;
    const OnLine place = nearest_on(contour->line, stage.on, p.screen);
    if (place.distance >= kReach) return false;
    std::vector<Vec2> points = contour->line.points;
    points.insert(points.begin() + std::ptrdiff_t(place.segment) + 1, p.at);
    const Selection& selection = app.session.selection;
    app.session.commit("Add point", with_contour_points(app.document(), selection.frame,
                                                        selection.contour, std::move(points)));
    return true;
  }

  void move(App& app, const Pointer& p, const Stage& stage) {
    const Contour* contour = chosen(app);
    if (!p.dragging || !p.moved || !contour || !app.session.goes_on(gesture_)) return;
    const double reach = 14 / stage.on.zoom;  // as far as the next handles
    const Selection& selection = app.session.selection;
    app.session.change(
        "Move point",
        with_contour_points(app.document(), selection.frame, selection.contour,
                            dragged(contour->line.closed, points_, point_, p.at - from_, reach)));
  }

  static void choose(App& app, const Pointer& p, const Stage& stage) {
    const int under = contour_at(app, stage.on, p.screen);
    if (app.session.next.joins && chosen(app) && under >= 0) return join_with(app, under);
    app.session.selection.contour = under;
    const Contour* now = chosen(app);
    app.session.selection.joint = now ? now->joint : -1;
  }

  long gesture_ = 0;
  int point_ = -1;            // of points_; −1: nothing is held
  Vec2 from_ = Vec2::Zero();  // where it was taken hold of
  std::vector<Vec2> points_;  // of the outline, then
};

}  // namespace

ToolRow edit_outline_tool() {
  return {.id = "edit",
          .mode = Mode::outline,
          .name = "Edit",
          .icon = icon::kCursorDefaultOutline,
          .key = ImGuiKey_V,
          .make = make_tool<EditOutlineTool>,
          .usual = true};
}

}  // namespace artisketch

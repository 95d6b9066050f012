// Draw: a stroke round a part is an outline; one along the chosen outline takes the place of that
// stretch.
#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

class DrawTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    constexpr float kApart = 1.5f;  // points
    if (p.pressed) stroke_ = {p.at};
    if (p.held && !stroke_.empty() && apart(stage.on.of(stroke_.back()), p.screen) > kApart)
      stroke_.push_back(p.at);
    if (!p.released || stroke_.empty()) return;
    const std::vector<Vec2> stroke = std::exchange(stroke_, {});
    StrokeOptions options;
    options.smooth = 2 / stage.on.zoom;
    options.error = 0.4 / stage.on.zoom;
    options.reach = kCloseReach / stage.on.zoom;
    options.open = p.alt;
    std::optional<Polyline> line = outline_of_stroke(stroke, options);
    if (app.session.next.redraws && app.session.selection.contour >= 0)
      return redraw_whole(app, line);
    // What closes is an outline of its own, though it may begin where another one runs.
    if (!(line && line->closed) && along_chosen(app, stroke, stage.on))
      return redraw_stretch(app, stroke, options);
    if (!line) return;
    NewOutline fresh;
    fresh.line = std::move(*line);
    fresh.stroke = stroke;
    fresh.options = options;
    propose(app, std::move(fresh));
  }

  void paint(const App&, const Pointer& p, const Stage& stage) const override {
    if (!p.held || stroke_.size() < 2) return;
    paint_outline(draw(), {stroke_, false}, stage.on, theme().accent, {});
    const ImVec2 first = stage.on.of(stroke_.front());
    if (apart(first, p.screen) < kCloseReach && stroke_.size() > 8)
      draw().AddCircle(first, kCloseReach, theme().accent, 0, 1.5f);
  }

  std::string hint(const App&) const override {
    return "Drag around a part; let go near the start to close.  Start on the chosen outline to "
           "redraw that piece.";
  }
  bool under_way() const override { return !stroke_.empty(); }
  bool draws_lines() const override { return true; }
  void cancel(App&) override { stroke_.clear(); }

 private:
  static void redraw_whole(App& app, const std::optional<Polyline>& line) {
    app.session.next.redraws = false;
    if (!line) return;
    const Selection& selection = app.session.selection;
    Document next = app.document();
    Contour& chosen =
        next.frames[std::size_t(selection.frame)].contours[std::size_t(selection.contour)];
    chosen.line = *line;
    app.session.commit("Redraw " + part_words(app, chosen.joint), std::move(next));
  }

  static bool along_chosen(const App& app, const std::vector<Vec2>& stroke, const OnScreen& on) {
    const int contour = app.session.selection.contour;
    if (contour < 0 || stroke.size() < 3) return false;
    const Polyline& line = app.frame().contours[std::size_t(contour)].line;
    return nearest_on(line, on, on.of(stroke.front())).distance < kCloseReach &&
           nearest_on(line, on, on.of(stroke.back())).distance < kCloseReach;
  }

  static void redraw_stretch(App& app, const std::vector<Vec2>& stroke, StrokeOptions options) {
    options.open = true;
    const std::optional<Polyline> smooth = outline_of_stroke(stroke, options);
    if (!smooth) return;
    const Selection& selection = app.session.selection;
    const Contour& chosen = app.frame().contours[std::size_t(selection.contour)];
    app.session.commit(
        "Redraw " + part_words(app, chosen.joint),
        with_contour_points(app.document(), selection.frame, selection.contour,
                            with_stretch_redrawn(chosen.line, smooth->points).points));
  }

  std::vector<Vec2> stroke_;  // under the pointer, in the sketch's pixels
};

}  // namespace

ToolRow draw_tool() {
  return {.id = "draw",
          .mode = Mode::outline,
          .name = "Draw",
          .icon = icon::kPencil,
          .key = ImGuiKey_D,
          .make = make_tool<DrawTool>};
}

}  // namespace artisketch

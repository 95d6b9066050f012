// Points: a click sets a corner; dragging from it pulls the curve's tangent.
#include "document/mend.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

class PointsTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    const bool closes = closes_at(p, stage);
    if (p.pressed && !closes) {
      if (points_.empty()) app.session.keep_new_outline();
      points_.push_back(p.at);
      tangents_.push_back(Vec2::Zero());
    }
    if (p.dragging && !points_.empty()) tangents_.back() = p.at - points_.back();
    if (p.backspace) undo();
    if (!(p.pressed && closes) && !(p.enter && points_.size() > 2)) return;
    NewOutline fresh;
    fresh.line = curve_through(points_, tangents_, true);
    cancel(app);
    propose(app, std::move(fresh));
  }

  void paint(const App&, const Pointer& p, const Stage& stage) const override {
    const OnScreen& on = stage.on;
    const bool closes = closes_at(p, stage);
    std::vector<Vec2> shown = points_, bent = tangents_;
    if (p.hovered && !p.held && !points_.empty()) {
      shown.push_back(closes ? points_.front() : p.at);
      bent.push_back(closes ? tangents_.front() : Vec2::Zero());
    }
    if (shown.size() > 1)
      paint_outline(draw(), curve_through(shown, bent, false), on, theme().accent, {});
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (tangents_[i].isZero()) continue;
      const ImVec2 a = on.of(points_[i] - tangents_[i]), b = on.of(points_[i] + tangents_[i]);
      draw().AddLine(a, b, theme().accent, 1);
      draw().AddCircleFilled(a, 3, theme().accent);
      draw().AddCircleFilled(b, 3, theme().accent);
    }
    paint_points({points_, false}, on, theme().accent, p.screen);
    if (closes) draw().AddCircle(on.of(points_.front()), kCloseReach, theme().accent, 0, 1.5f);
  }

  std::string hint(const App&) const override {
    return "Click point by point; Enter or a click on the first closes.";
  }
  bool under_way() const override { return !points_.empty(); }
  bool undo() override {
    if (points_.empty()) return false;
    points_.pop_back();
    tangents_.pop_back();
    return true;
  }
  void cancel(App&) override {
    points_.clear();
    tangents_.clear();
  }

 private:
  bool closes_at(const Pointer& p, const Stage& stage) const {
    return points_.size() > 2 && apart(stage.on.of(points_.front()), p.screen) < kCloseReach;
  }

  std::vector<Vec2> points_, tangents_;  // in the sketch's pixels
};

}  // namespace

ToolRow points_tool() {
  return {.id = "points",
          .mode = Mode::outline,
          .name = "Points",
          .icon = icon::kVectorPolyline,
          .key = ImGuiKey_P,
          .make = make_tool<PointsTool>};
}

}  // namespace artisketch

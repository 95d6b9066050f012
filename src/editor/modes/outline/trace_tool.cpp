// Trace: a click outlines the region about it; dragging sideways takes in more or less.
#include <algorithm>
#include <cmath>

#include "editor/modes/outline/new_outline.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

void explain(App& app, const char* words) {
  Toast toast;
  toast.words = words;
  if (app.toasts.empty() || app.toasts.back().words != toast.words) app.say(std::move(toast));
}

class TraceTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage&) override {
    constexpr double kDoubles = 60;   // points of dragging that double the tolerance
    constexpr double kQuickDrag = 4;  // points
    if (p.pressed) {
      gesture_ = app.session.begin_gesture();
      from_ = p.screen.x;
      tracing_ = begin(app, p.at);
    }
    if (!going_on(app)) return;
    // Where it is let go counts as well: a quick drag may have no frame in between.
    const double by = p.screen.x - from_;
    if (!(p.dragging || (p.released && std::abs(by) > kQuickDrag))) return;
    trace_again(app, app.session.new_outline->tracing->from * std::exp2(by / kDoubles));
  }

  void paint(const App& app, const Pointer& p, const Stage&) const override {
    if (going_on(app) && p.dragging)
      tooltip("Tolerance " + std::to_string(int(std::lround(100 * app.view.tolerance))) + " %", "");
  }

  std::string hint(const App&) const override {
    return "Click a shape; drag sideways to take in more or less, far right for all.";
  }
  void cancel(App&) override { tracing_ = false; }

 private:
  bool going_on(const App& app) const {
    return tracing_ && app.session.goes_on(gesture_) && app.session.new_outline &&
           app.session.new_outline->tracing;
  }

  // Whether an outline was found there; it is the pending one then.
  static bool begin(App& app, const Vec2& at) {
    const Drawing* drawing = app.services.drawings.of(app.frame());
    if (!drawing) {
      explain(app, "There is no picture to trace here. Draw around the part: D.");
      return false;
    }
    const Image& image = drawing->image;
    auto tracing = std::make_shared<Tracing>();
    tracing->image = segmented(image);
    if (is_paper(tracing->image, at)) {
      explain(app, "That is paper. Click inside a shape; where its line has a gap, draw instead.");
      return false;
    }
    tracing->levels = flood_levels(tracing->image, at);
    tracing->from = app.view.tolerance;
    std::optional<RegionOutline> found =
        region_outline(tracing->image, tracing->levels, app.view.tolerance);
    if (!found) {
      explain(app, "Nothing hangs together here. Drag sideways for more.");
      return false;
    }
    NewOutline fresh;
    fresh.line = std::move(found->outline);
    fresh.holes = std::move(found->holes);
    fresh.verb = "Trace";
    fresh.tracing = std::move(tracing);
    propose(app, std::move(fresh));
    return true;
  }

  long gesture_ = 0;
  bool tracing_ = false;  // the press under way found an outline
  float from_ = 0;        // where it went down
};

}  // namespace

ToolRow trace_tool() {
  return {.id = "trace",
          .mode = Mode::outline,
          .name = "Trace",
          .icon = icon::kAutoFix,
          .key = ImGuiKey_T,
          .make = make_tool<TraceTool>,
          .about = "Outline what you click"};
}

}  // namespace artisketch

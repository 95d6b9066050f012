// Trace: a click outlines the region about it; dragging sideways takes in more or less.
#include <cmath>

#include "editor/canvas/tools.h"
#include "editor/modes/outline/new_outline.h"

namespace artisketch {
namespace {

constexpr double kLeast = 0.01, kDoubles = 60;  // tolerance; points of dragging that double it

void explain(Work& work, const char* words) {
  Toast toast;
  toast.words = words;
  if (work.toasts.empty() || work.toasts.back().words != toast.words) work.say(std::move(toast));
}

void begin(Work& work, const Vec2& at) {
  const Drawing* drawing = work.drawings.of(work.frame());
  if (!drawing) return explain(work, "There is no picture to trace here. Draw around the part: D.");
  const Image& image = drawing->image;
  auto tracing = std::make_shared<Tracing>();
  tracing->image = trace_image({image.width, image.height, image.rgba});
  if (is_paper(tracing->image, at))
    return explain(work,
                   "That is paper. Click inside a shape; where its line has a gap, draw instead.");
  tracing->levels = flood_levels(tracing->image, at);
  tracing->from = work.view.tolerance;
  std::optional<Traced> found = traced(tracing->image, tracing->levels, work.view.tolerance);
  if (!found) return explain(work, "Nothing hangs together here. Drag sideways for more.");
  NewOutline fresh;
  fresh.line = std::move(found->outline);
  fresh.holes = std::move(found->holes);
  fresh.verb = "Trace";
  fresh.tracing = std::move(tracing);
  propose(work, std::move(fresh));
  work.gesture.contour = 0;
}

}  // namespace

void trace_with(Work& work, double tolerance) {
  const std::shared_ptr<Tracing> tracing = work.outline->tracing;
  work.view.tolerance = std::clamp(tolerance, kLeast, 1.0);
  propose_again(work, traced(tracing->image, tracing->levels, work.view.tolerance));
}

void trace_tool(Work& work, const Pointer& p, const OnScreen&) {
  if (p.pressed) {
    work.gesture = {};
    work.gesture.from = Vec2(p.screen.x, p.screen.y);
    begin(work, p.at);
  }
  const bool tracing = work.outline && work.outline->tracing && work.gesture.contour == 0;
  // Where it is let go counts as well: a quick drag may have no frame in between.
  const double by = p.screen.x - work.gesture.from.x();
  if (!tracing || !(p.dragging || (p.released && std::abs(by) > 4))) return;
  const double tolerance = work.outline->tracing->from * std::exp2(by / kDoubles);
  if (std::abs(std::clamp(tolerance, kLeast, 1.0) - work.view.tolerance) > 1e-6)
    trace_with(work, tolerance);
  tooltip("Tolerance " + std::to_string(int(std::lround(100 * work.view.tolerance))) + " %", "");
}

}  // namespace artisketch

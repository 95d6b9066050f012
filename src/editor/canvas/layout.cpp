#include "editor/canvas/layout.h"

#include <algorithm>
#include <utility>

namespace artisketch {
namespace {

constexpr float kTabletWidth = 1000, kCompactWidth = 1360, kCompactHeight = 800;

Layout tablet(Rect all, const View& view) {
  Layout l;
  l.tablet = true;
  l.top = all.cut_top(56);
  l.modes = all.cut_top(56);
  l.strip = all.cut_bottom(view.mode == Mode::result ? 148 : 104);
  l.inspector = all.cut_bottom(view.exporting ? 640.0f : view.all_drawings ? 460.0f : 144.0f);
  l.canvas = all;
  l.canvas_head = {all.x + all.w / 2 - 84, all.y + 12, 168, 44};
  l.canvas_foot = {};
  l.rail = {all.x + 12, all.y + 91, 68, 0};
  l.view = {all.right() - 244, all.bottom() - 280, 232, 268};
  l.swapped = view.swapped[std::size_t(view.mode)];
  if (l.swapped) {
    std::swap(l.canvas, l.view);
    l.view_head = {all.x + 80, all.y + 6, all.w - 80, 48};
  }
  return l;
}

}  // namespace

Layout lay_out(float width, float height, const View& view) {
  Rect all{0, 0, width, height};
  if (width < kTabletWidth) return tablet(all, view);
  Layout l;
  l.compact = width < kCompactWidth || height < kCompactHeight;
  l.top = all.cut_top(48);
  l.status = all.cut_bottom(24);
  const Splits& by = view.splits;
  constexpr float kLeast = 240;  // of what lies beside
  const auto sized = [](float usual, float more, float least, float most) {
    return std::clamp(usual + more, least, std::max(least, most));
  };
  l.inspector = all.cut_right(sized(l.compact ? 264 : 288, by.inspector, 232, all.w / 3));
  const float strip = view.mode == Mode::result ? 148 : l.compact ? 80 : 112;
  l.strip = all.cut_bottom(sized(strip, by.strip, l.compact ? 64 : 80, all.h / 2));
  l.rail = all.cut_left(l.compact ? 48 : 64);
  l.view = all.cut_right(sized(l.compact ? 300 : 396, by.model, kLeast, all.w - kLeast));
  l.canvas = all;
  l.canvas_head = l.canvas.cut_top(48);
  l.canvas_foot = l.canvas.cut_bottom(44);
  Rect model = l.view;
  l.view_head = model.cut_top(48);
  l.view_foot = model.cut_bottom(44);
  return l;
}

}  // namespace artisketch

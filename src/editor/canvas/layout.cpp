#include "editor/canvas/layout.h"

#include <algorithm>
#include <utility>

namespace artisketch {
namespace {

// Below the first, drawing and model don't stand beside each other.
constexpr float kNarrow = 1000, kCompactWidth = 1360, kCompactHeight = 800;

// In the lower corner of what is drawn.
Rect inset_place(const Rect& canvas, float width, float height) {
  constexpr float kMargin = 12;
  return {canvas.right() - width - kMargin, canvas.bottom() - height - kMargin, width, height};
}

Layout tablet(Rect all, const View& view) {
  Layout l;
  l.tablet = l.inset = true;
  l.top = all.cut_top(56);
  l.modes = all.cut_top(56);
  l.strip = all.cut_bottom(view.mode == Mode::result ? 148 : 104);
  // Of a phone, a sheet leaves the top of what is drawn.
  constexpr float kLeft = 180;
  const float sheet = std::min(640.0f, all.h - kLeft);
  l.inspector = all.cut_bottom(view.exporting || view.mapping ? sheet
                               : view.all_drawings            ? 460.0f
                                                              : 144.0f);
  l.canvas = all;
  l.canvas_head = {all.x + all.w / 2 - 84, all.y + 12, 168, 44};
  l.canvas_foot = {};
  l.rail = {all.x + 12, all.y + 91, 68, 0};
  const float wide =
      std::min(232.0f, 0.4f * all.w);  // on phones the drawing keeps most of the width
  l.view = inset_place(all, wide, std::min(wide * 268 / 232, all.h - 80));
  l.swapped = view.swapped[std::size_t(view.mode)];
  if (l.swapped) {
    std::swap(l.canvas, l.view);
    l.view_head = {all.x + 80, all.y + 6, all.w - 80, 48};
  }
  return l;
}

// A laptop's window in a zoomed browser: low and wide, with a pointer.
Layout low(Rect all, const View& view) {
  Layout l;
  l.inset = l.compact = true;
  l.top = all.cut_top(48);
  l.status = all.cut_bottom(24);
  l.inspector = all.cut_right(232);
  l.strip = all.cut_bottom(view.mode == Mode::result ? 148 : 64);
  l.rail = all.cut_left(48);
  l.canvas = all;
  l.swapped = view.swapped[std::size_t(view.mode)];
  Rect& large = l.swapped ? l.view : l.canvas;
  Rect& head = l.swapped ? l.view_head : l.canvas_head;
  Rect& foot = l.swapped ? l.view_foot : l.canvas_foot;
  large = all;
  if (l.swapped) {
    head = Rect(large).cut_top(48);
    foot = Rect(large).cut_bottom(44);
  } else {
    head = large.cut_top(48);
    foot = large.cut_bottom(44);
  }
  const float side = std::min(188.0f, 0.5f * large.h);
  Rect free = all;
  free.cut_bottom(44);
  (l.swapped ? l.canvas : l.view) = inset_place(free, side, side);
  return l;
}

}  // namespace

Layout lay_out(float width, float height, const View& view) {
  Rect all{0, 0, width, height};
  if (width < kNarrow) return width < height ? tablet(all, view) : low(all, view);
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

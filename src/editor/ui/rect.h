// Rectangles in points, and layout by cutting pieces off them.
#pragma once

#include <algorithm>

#include <imgui.h>

namespace artisketch {

struct Rect {
  float x = 0, y = 0, w = 0, h = 0;

  float right() const { return x + w; }
  float bottom() const { return y + h; }
  ImVec2 min() const { return {x, y}; }
  ImVec2 max() const { return {x + w, y + h}; }
  ImVec2 centre() const { return {x + w / 2, y + h / 2}; }
  bool holds(ImVec2 p) const { return p.x >= x && p.y >= y && p.x < right() && p.y < bottom(); }

  // The piece of that size; the rest stays in this one.
  Rect cut_left(float size) {
    size = std::min(size, w);
    const Rect piece{x, y, size, h};
    x += size;
    w -= size;
    return piece;
  }
  Rect cut_right(float size) {
    size = std::min(size, w);
    w -= size;
    return {right(), y, size, h};
  }
  Rect cut_top(float size) {
    size = std::min(size, h);
    const Rect piece{x, y, w, size};
    y += size;
    h -= size;
    return piece;
  }
  Rect cut_bottom(float size) {
    size = std::min(size, h);
    h -= size;
    return {x, bottom(), w, size};
  }
  Rect inset(float dx, float dy) const { return {x + dx, y + dy, w - 2 * dx, h - 2 * dy}; }
  Rect inset(float d) const { return inset(d, d); }
  // A rectangle of that size in the middle of this one.
  Rect middle(float width, float height) const {
    return {x + (w - width) / 2, y + (h - height) / 2, width, height};
  }
};

}  // namespace artisketch

// Outlines as drawn, in pixels of their sketch.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/types.h"

namespace artisketch {

// A closed line is a polygon whose last point joins the first; an open one is a stroke.
struct Polyline {
  std::vector<Vec2> points;  // pixels; three or more where closed, two or more where open
  bool closed = true;
  std::size_t segments() const { return closed ? points.size() : points.size() - 1; }
  const Vec2& end_of(std::size_t segment) const { return points[(segment + 1) % points.size()]; }
};

// z of the cross product: positive where b lies clockwise of a on screen (y down).
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Pixels²; positive where the points run clockwise on screen.
double signed_area(const Polyline& closed);
double length(const Polyline& line);
// By the even-odd rule: of all closed lines together.
bool contains(const Polyline& closed, const Vec2& p);
bool contains(std::span<const Polyline> lines, const Vec2& p);
// The closed ones of the lines.
std::vector<std::vector<Vec2>> closed_polygons(std::span<const Polyline> lines);
Box2 bounds(std::span<const Polyline> lines);

// Points at equal steps of at most `step` pixels along the line, starting at its first point; an
// open line keeps its last point too. At least three for a closed line.
Polyline resampled(const Polyline& line, double step);

// Where the line crosses itself or lies on itself (a fold, a doubled stretch), if it does: the
// leftmost such place, about. A line that only touches itself, at a vertex or with one, doesn't
// cross: inside and outside stay clear. O(n log n) on any line; repeated points don't matter.
std::optional<Vec2> self_crossing(const Polyline& line);

// Centroid of the area inside the closed lines by the even-odd rule; the mean of all points where
// that area is nothing.
Vec2 centroid(std::span<const Polyline> lines);

}  // namespace artisketch

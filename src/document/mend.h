// Outlines put right: without crossings, two as one, curves as lines.
#pragma once

#include <optional>
#include <span>

#include "document/contour.h"

namespace artisketch {

// The line without its crossings. A closed one keeps what it encloses: a loop is turned about, or
// let go where it is a sliver; an open one lets its loops go. A line that doesn't cross itself
// comes back as it is. Never crosses itself; O(n²) for each crossing.
Polyline mended(const Polyline& line);

// Two closed outlines as the one around both, or two strokes as one from nearest end to nearest end
// (closed where the others meet within `reach` pixels as well). Nothing where two outlines don't
// touch, or one is closed and the other open.
std::optional<Polyline> joined(const Polyline& a, const Polyline& b, double reach);

// Cubic curves through points, as lines within 0.1 pixels: the tangent at points[i] is handles[i]
// (zero: a corner): from the point to the control point after it, and backwards to the one
// before. As many handles as points.
Polyline curve_through(std::span<const Vec2> points, std::span<const Vec2> handles, bool closed);

}  // namespace artisketch

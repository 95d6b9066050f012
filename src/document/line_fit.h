// Fewer and calmer points for a line that was drawn or traced.
#pragma once

#include <span>
#include <vector>

#include "document/contour.h"

namespace artisketch {

// The points that matter: no point of the line is farther than `error` pixels from what is left.
// Source: Ramer 1972, Douglas and Peucker 1973.
std::vector<Vec2> simplified(std::span<const Vec2> points, bool closed, double error);

// A Gaussian, `radius` pixels wide, over points equally spaced by `step`. An open line keeps its
// ends.
std::vector<Vec2> smoothed(std::span<const Vec2> points, bool closed, double radius, double step);

// The closed lines along which a field of w × h samples is one half: clockwise on screen about
// what is more, the other way round holes. Sample (x, y) stands at (x + 0.5, y + 0.5); beyond the
// border all is 0. They neither cross themselves nor each other: where samples meet at a corner
// alone, they are kept apart.
std::vector<Polyline> iso_lines(std::span<const float> field, int w, int h);

}  // namespace artisketch

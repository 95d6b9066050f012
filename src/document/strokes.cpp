// Strokes and outlines: what drawing and redrawing make of the pointer's path.
#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/line_fit.h"
#include "document/mend.h"

namespace artisketch {

std::optional<Polyline> outline_of_stroke(std::span<const Vec2> stroke,
                                          const StrokeOptions& options) {
  Polyline raw{{}, false};
  for (const Vec2& p : stroke)
    if (raw.points.empty() || (p - raw.points.back()).norm() > 1e-6) raw.points.push_back(p);
  if (raw.points.size() < 3) return std::nullopt;
  const double gap = (raw.points.front() - raw.points.back()).norm(), size = length(raw);
  raw.closed = !options.open && gap <= options.reach && size > 3 * options.reach;
  if (!raw.closed && size < 4) return std::nullopt;
  constexpr double kStep = 1;  // pixels
  const Polyline even = resampled(raw, kStep);
  Polyline result{simplified(smoothed(even.points, raw.closed, options.smooth, kStep), raw.closed,
                             options.error),
                  raw.closed};
  if (!result.closed) return result;
  if (result.points.size() < 3 || std::abs(signed_area(result)) < 1) return std::nullopt;
  // A hand rarely meets its own beginning: the small loop there goes. What crosses itself more
  // than that stays as it was drawn, to be seen.
  constexpr double kSmall = 0.05;  // of the area
  Polyline clean = mended(result);
  const double area = std::abs(signed_area(result)), other = std::abs(signed_area(clean));
  return std::abs(other - area) <= kSmall * area ? clean : result;
}

Polyline with_stretch_redrawn(const Polyline& outline, std::span<const Vec2> stroke) {
  const int n = int(outline.points.size());
  const auto nearest = [&](const Vec2& p) {
    int best = 0;
    for (int i = 1; i < n; ++i)
      if ((outline.points[i] - p).norm() < (outline.points[best] - p).norm()) best = i;
    return best;
  };
  if (stroke.size() < 2 || n < 3) return outline;
  const int a = nearest(stroke.front()), b = nearest(stroke.back());
  const auto along = [&](int from, int to) {
    double sum = 0;
    for (int i = from; i != to; i = (i + 1) % n)
      sum += (outline.points[(i + 1) % n] - outline.points[i]).norm();
    return sum;
  };
  Polyline result{{}, outline.closed};
  if (!outline.closed) {
    const bool forward = a <= b;
    const int low = std::min(a, b), high = std::max(a, b);
    result.points.assign(outline.points.begin(), outline.points.begin() + low);
    if (forward)
      result.points.insert(result.points.end(), stroke.begin(), stroke.end());
    else
      result.points.insert(result.points.end(), stroke.rbegin(), stroke.rend());
    result.points.insert(result.points.end(), outline.points.begin() + high + 1,
                         outline.points.end());
    return result;
  }
  // The shorter way round is the one that was redrawn; the longer one stays.
  const bool forward = along(a, b) <= along(b, a);
  const int from = forward ? b : a, to = forward ? a : b;
  for (int i = from;; i = (i + 1) % n) {
    result.points.push_back(outline.points[i]);
    if (i == to) break;
  }
  if (forward)
    result.points.insert(result.points.end(), stroke.begin(), stroke.end());
  else
    result.points.insert(result.points.end(), stroke.rbegin(), stroke.rend());
  return result;
}

}  // namespace artisketch

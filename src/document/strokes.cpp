// Strokes and outlines: what drawing and redrawing make of the pointer's path.
#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/line_fit.h"
#include "document/mend.h"

namespace artisketch {
namespace {

// A hand rarely meets its own beginning, or the line that it goes on from: the small loop there
// goes. What crosses itself more than that stays as it was drawn, to be seen.
Polyline without_small_loops(Polyline line) {
  constexpr double kSmall = 0.05;  // of the area
  Polyline clean = mended(line);
  const double area = std::abs(signed_area(line)), other = std::abs(signed_area(clean));
  return std::abs(other - area) <= kSmall * area ? clean : line;
}

// The place on a line nearest to p, as a point of its own; gives its index.
int with_nearest_place(Polyline& line, const Vec2& p) {
  std::size_t after = 0;
  Vec2 best = line.points[0];
  for (std::size_t s = 0; s < line.segments(); ++s) {
    const Vec2 &a = line.points[s], along = line.end_of(s) - a;
    const double t =
        std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
    const Vec2 place = a + t * along;
    if ((place - p).norm() < (best - p).norm()) best = place, after = s;
  }
  line.points.insert(line.points.begin() + std::ptrdiff_t(after) + 1, best);
  return int(after) + 1;
}

}  // namespace

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
  // The loops of an eight count against each other in its own area.
  if (result.points.size() < 3 || std::abs(signed_area(mended(result))) < 1) return std::nullopt;
  return without_small_loops(std::move(result));
}

Polyline with_stretch_redrawn(const Polyline& outline, std::span<const Vec2> stroke) {
  if (stroke.size() < 2 || outline.points.size() < 3) return outline;
  Polyline old = outline;
  int a = with_nearest_place(old, stroke.front());
  const int b = with_nearest_place(old, stroke.back());
  if (b <= a) ++a;
  const int n = int(old.points.size());
  const auto along = [&](int from, int to) {
    double sum = 0;
    for (int i = from; i != to; i = (i + 1) % n)
      sum += (old.points[(i + 1) % n] - old.points[i]).norm();
    return sum;
  };
  Polyline result{{}, outline.closed};
  if (!outline.closed) {
    const bool forward = a <= b;
    const int low = std::min(a, b), high = std::max(a, b);
    result.points.assign(old.points.begin(), old.points.begin() + low);
    if (forward)
      result.points.insert(result.points.end(), stroke.begin(), stroke.end());
    else
      result.points.insert(result.points.end(), stroke.rbegin(), stroke.rend());
    result.points.insert(result.points.end(), old.points.begin() + high + 1, old.points.end());
    return result;
  }
  // The shorter way round is the one that was redrawn; the longer one stays.
  const bool forward = along(a, b) <= along(b, a);
  const int from = forward ? b : a, to = forward ? a : b;
  for (int i = from;; i = (i + 1) % n) {
    result.points.push_back(old.points[i]);
    if (i == to) break;
  }
  if (forward)
    result.points.insert(result.points.end(), stroke.begin(), stroke.end());
  else
    result.points.insert(result.points.end(), stroke.rbegin(), stroke.rend());
  return without_small_loops(std::move(result));
}

}  // namespace artisketch

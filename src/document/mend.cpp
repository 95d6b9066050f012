#include "document/mend.h"

#include <algorithm>
#include <cmath>

#include "base/distance_field.h"
#include "base/ensure.h"
#include "document/line_fit.h"

namespace artisketch {
namespace {

struct Crossing {
  std::size_t first, second;  // segments
  Vec2 point;
};

// Where two segments pass through each other; those that only touch are left alone.
std::optional<Crossing> first_crossing(const Polyline& line) {
  const std::size_t n = line.segments();
  constexpr double kEnd = 1e-9;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = line.points[i], d = line.end_of(i) - p;
    for (std::size_t j = i + 2; j < n; ++j) {
      const Vec2 q = line.points[j], e = line.end_of(j) - q;
      const double denominator = cross(d, e);
      if (std::abs(denominator) < 1e-12) continue;
      const double t = cross(q - p, e) / denominator, u = cross(q - p, d) / denominator;
      if (t > kEnd && t < 1 - kEnd && u > kEnd && u < 1 - kEnd) return Crossing{i, j, p + t * d};
    }
  }
  return std::nullopt;
}

// The crossing undone: the loop between its two segments is let go or turned about.
void undo_crossing(Polyline& line, const Crossing& at) {
  std::vector<Vec2>& points = line.points;
  const auto loop_begins = points.begin() + std::ptrdiff_t(at.first) + 1,
             loop_ends = points.begin() + std::ptrdiff_t(at.second) + 1;
  Polyline loop{{loop_begins, loop_ends}, true}, rest{{points.begin(), loop_begins}, true};
  loop.points.push_back(at.point);
  rest.points.push_back(at.point);
  rest.points.insert(rest.points.end(), loop_ends, points.end());
  if (!line.closed) {
    points = std::move(rest.points);
    return;
  }
  constexpr double kSliver = 0.04;  // of the larger of the two
  const double a = std::abs(signed_area(loop)), b = std::abs(signed_area(rest));
  if (a < kSliver * b) {
    points = std::move(rest.points);
  } else if (b < kSliver * a) {
    points = std::move(loop.points);
  } else {
    std::reverse(loop_begins, loop_ends);
    // Both passes keep off the crossing, each on its side.
    const Vec2 before = *(loop_begins - 1), after = *loop_begins;
    const Vec2 last = *(loop_ends - 1),
               next = loop_ends == points.end() ? points.front() : *loop_ends;
    constexpr double kOff = 0.25;  // pixels
    const auto beside = [&](const Vec2& x, const Vec2& y) {
      const Vec2 d = (x + y) / 2 - at.point;
      return Vec2(at.point + d * std::min(0.5, kOff / std::max(d.norm(), 1e-9)));
    };
    const std::ptrdiff_t turn = loop_ends - points.begin();
    points.insert(points.begin() + turn, beside(last, next));
    points.insert(points.begin() + std::ptrdiff_t(at.first) + 1, beside(before, after));
  }
}

// The outermost line around what `outside` says is within: positive outside, in pixels.
template <class Distance>
std::optional<Polyline> around(const Box2& box, const Distance& outside) {
  constexpr double kMost = 250000;  // samples
  const Vec2 size = box.sizes() + Vec2(6, 6), origin = box.min() - Vec2(3, 3);
  const double step = std::max(0.5, std::sqrt(size.prod() / kMost));
  const int w = int(size.x() / step) + 1, h = int(size.y() / step) + 1;
  std::vector<float> field;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const Vec2 p = origin + step * Vec2(x + 0.5, y + 0.5);
      field.push_back(float(std::clamp(0.5 - outside(p) / step, 0.0, 1.0)));
    }
  const std::vector<Polyline> lines = iso_lines(field, w, h);
  const auto largest = std::max_element(
      lines.begin(), lines.end(),
      [](const Polyline& a, const Polyline& b) { return signed_area(a) < signed_area(b); });
  if (largest == lines.end()) return std::nullopt;
  Polyline line = *largest;
  for (Vec2& p : line.points) p = origin + step * p;
  constexpr double kError = 0.2;
  const Polyline simple{simplified(line.points, true, kError), true};
  return simple.points.size() >= 3 && !self_crossing(simple) ? simple : line;
}

}  // namespace

Polyline mended(const Polyline& line) {
  if (!self_crossing(line)) return line;
  Polyline result = line;
  constexpr int kMost = 200;  // crossings: a scribble, rather
  for (int i = 0; i < kMost; ++i) {
    const std::optional<Crossing> crossing = first_crossing(result);
    if (!crossing) break;
    undo_crossing(result, *crossing);
  }
  const std::size_t least = line.closed ? 3 : 2;
  if (result.points.size() >= least && !self_crossing(result)) return result;
  if (!line.closed) return {{line.points.front(), line.points.back()}, false};
  // Folds and worse: the line around all of it.
  const PolygonDistance distance(std::span(&line.points, 1));
  const Box2 box = bounds(std::span(&line, 1));
  const auto outside = [&](const Vec2& p) { return distance.distance(p); };
  if (const std::optional<Polyline> whole = around(box, outside); whole && !self_crossing(*whole))
    return *whole;
  // What has no inside of its own gets one of a pixel: a corner of no width would lie on itself.
  const Vec2 a = box.min(), c = a + Vec2(box.sizes().cwiseMax(1.0));
  return {{a, {c.x(), a.y()}, c}, true};
}

std::optional<Polyline> joined(const Polyline& a, const Polyline& b, double reach) {
  if (a.closed != b.closed) return std::nullopt;
  if (!a.closed) {
    std::vector<Vec2> best;
    double gap = 1e300;
    for (bool turn_a : {false, true})
      for (bool turn_b : {false, true}) {
        std::vector<Vec2> first = a.points, second = b.points;
        if (turn_a) std::reverse(first.begin(), first.end());
        if (turn_b) std::reverse(second.begin(), second.end());
        const double between = (first.back() - second.front()).norm();
        if (between >= gap) continue;
        gap = between;
        best = std::move(first);
        best.insert(best.end(), second.begin(), second.end());
      }
    const bool closes = (best.front() - best.back()).norm() <= reach && best.size() > 2;
    return Polyline{std::move(best), closes};
  }
  const PolygonDistance to_a(std::span(&a.points, 1)), to_b(std::span(&b.points, 1));
  constexpr double kTouch = 0.5;  // pixels
  const auto touches = [&](const Polyline& line, const PolygonDistance& other) {
    return std::any_of(line.points.begin(), line.points.end(),
                       [&](const Vec2& p) { return other.distance(p) < kTouch; });
  };
  if (!touches(resampled(a, 1), to_b) && !touches(resampled(b, 1), to_a)) return std::nullopt;
  Box2 box = bounds(std::span(&a, 1));
  box.extend(bounds(std::span(&b, 1)));
  return around(box, [&](const Vec2& p) { return std::min(to_a.distance(p), to_b.distance(p)); });
}

Polyline curve_through(std::span<const Vec2> points, std::span<const Vec2> handles, bool closed) {
  ensure(points.size() == handles.size(), "a handle for every point");
  Polyline line{{}, closed};
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    line.points.push_back(points[i]);
    const std::size_t j = (i + 1) % n;
    if ((j == 0 && !closed) || n < 2) break;
    if (handles[i].isZero() && handles[j].isZero()) continue;
    const Vec2 a = points[i], b = a + handles[i], d = points[j], c = d - handles[j];
    // Half as far from the chord with half the step, squared.
    const double bend = std::max((a - 2 * b + c).norm(), (b - 2 * c + d).norm());
    constexpr double kError = 0.1;
    const int steps = std::clamp(int(std::ceil(std::sqrt(0.75 * bend / kError))), 1, 100);
    for (int k = 1; k < steps; ++k) {
      const double t = double(k) / steps, s = 1 - t;
      line.points.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
    }
  }
  return line;
}

}  // namespace artisketch

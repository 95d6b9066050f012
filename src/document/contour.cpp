#include "document/contour.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

namespace artisketch {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Side of c seen from the line a b: −1, 0, 1. Plain doubles: a touch within rounding may be missed
// or found, which a person drawing in pixels cannot tell either.
int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double s = cross(b - a, c - a);
  return (s > 0) - (s < 0);
}

bool on_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (p.array() >= a.cwiseMin(b).array()).all() && (p.array() <= a.cwiseMax(b).array()).all();
}

std::optional<Vec2> meeting(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int s1 = side(a, b, c), s2 = side(a, b, d), s3 = side(c, d, a), s4 = side(c, d, b);
  if (s1 * s2 < 0 && s3 * s4 < 0) return a + (b - a) * (cross(c - a, d - c) / cross(b - a, d - c));
  if (s1 == 0 && on_segment(a, b, c)) return c;
  if (s2 == 0 && on_segment(a, b, d)) return d;
  if (s3 == 0 && on_segment(c, d, a)) return a;
  if (s4 == 0 && on_segment(c, d, b)) return b;
  return std::nullopt;
}

}  // namespace

double signed_area(const Polyline& closed) {
  double twice = 0;
  for (std::size_t i = 0; i < closed.points.size(); ++i)
    twice += cross(closed.points[i] - closed.points[0], closed.end_of(i) - closed.points[0]);
  return twice / 2;
}

double length(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.segments(); ++i) sum += (line.end_of(i) - line.points[i]).norm();
  return sum;
}

Box2 bounds(std::span<const Polyline> lines) {
  Box2 box;
  for (const Polyline& line : lines)
    for (const Vec2& p : line.points) box.extend(p);
  return box;
}

Polyline resampled(const Polyline& line, double step) {
  const double total = length(line);
  const int least = line.closed ? 3 : 1;
  const int n = std::max(least, int(std::ceil(total / step)));
  Polyline out;
  out.closed = line.closed;
  out.points.reserve(n + 1);
  std::size_t segment = 0;
  double start = 0, span = (line.end_of(0) - line.points[0]).norm();
  for (int i = 0; i < n; ++i) {
    const double at = total * i / n;
    while (at > start + span && segment + 1 < line.segments()) {
      start += span;
      ++segment;
      span = (line.end_of(segment) - line.points[segment]).norm();
    }
    const double w = span > 0 ? std::clamp((at - start) / span, 0.0, 1.0) : 0.0;
    out.points.push_back((1 - w) * line.points[segment] + w * line.end_of(segment));
  }
  if (!line.closed) out.points.push_back(line.points.back());
  return out;
}

std::optional<Vec2> self_crossing(const Polyline& line) {
  const std::size_t n = line.segments();
  if (n < 2) return std::nullopt;
  // Buckets about as wide as the mean segment keep the expected pairs per segment few; at most
  // 1024 across, so that one long segment in a crowd of short ones stays affordable.
  const Box2 box = bounds({&line, 1});
  const double widest = std::max(box.sizes().maxCoeff(), 1e-9);
  const double bucket = std::max(length(line) / n, widest / 1024);
  std::unordered_map<long long, std::vector<int>> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = line.points[i], &b = line.end_of(i);
    const Vec2 low = (a.cwiseMin(b) - box.min()) / bucket,
               high = (a.cwiseMax(b) - box.min()) / bucket;
    for (int y = int(low.y()); y <= int(high.y()); ++y)
      for (int x = int(low.x()); x <= int(high.x()); ++x) {
        std::vector<int>& here = segments[(long long)y << 32 | x];
        for (const int j : here) {
          const bool neighbours = i - j == 1 || (line.closed && j == 0 && i == n - 1);
          if (!neighbours) {
            if (auto p = meeting(line.points[j], line.end_of(j), a, b)) return p;
          } else if (n > 2) {
            // Neighbours share a point; they cross only where one folds back onto the other.
            const bool wraps = i - j != 1;
            const Vec2& shared = wraps ? line.points[0] : a;
            const Vec2& before = wraps ? a : line.points[j];
            const Vec2& after = wraps ? line.end_of(0) : b;
            const Vec2 u = before - shared, v = after - shared;
            if (cross(u, v) == 0 && u.dot(v) > 0) return shared;
          }
        }
        here.push_back(int(i));
      }
  }
  return std::nullopt;
}

Vec2 centroid(std::span<const Polyline> lines) {
  // Even-odd: a line inside another one is a hole, so it counts against the area it lies in.
  double area = 0;
  Vec2 moment = Vec2::Zero(), mean = Vec2::Zero();
  std::size_t count = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const Polyline& line = lines[l];
    for (const Vec2& p : line.points) mean += p;
    count += line.points.size();
    if (!line.closed) continue;
    int depth = 0;
    for (std::size_t m = 0; m < lines.size(); ++m) {
      if (m == l || !lines[m].closed) continue;
      const Vec2& p = line.points[0];
      bool inside = false;
      for (std::size_t i = 0; i < lines[m].points.size(); ++i) {
        const Vec2 &a = lines[m].points[i], &b = lines[m].end_of(i);
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
          inside = !inside;
      }
      depth += inside;
    }
    double twice = 0;
    Vec2 six = Vec2::Zero();
    const Vec2 o = line.points[0];
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Vec2 a = line.points[i] - o, b = line.end_of(i) - o;
      twice += cross(a, b);
      six += (a + b) * cross(a, b);
    }
    const double sign = (twice < 0 ? -1 : 1) * (depth % 2 ? -1 : 1);
    area += sign * twice / 2;
    moment += sign * (six / 6 + o * twice / 2);
  }
  if (area > 1e-12) return moment / area;
  return count ? Vec2(mean / double(count)) : Vec2(Vec2::Zero());
}

}  // namespace artisketch

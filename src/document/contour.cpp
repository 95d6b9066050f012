#include "document/contour.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace artisketch {
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

bool contains(const Polyline& closed, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < closed.points.size(); ++i) {
    const Vec2 &a = closed.points[i], &b = closed.end_of(i);
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

bool contains(std::span<const Polyline> lines, const Vec2& p) {
  bool inside = false;
  for (const Polyline& line : lines) inside ^= line.closed && contains(line, p);
  return inside;
}

std::vector<std::vector<Vec2>> closed_polygons(std::span<const Polyline> lines) {
  std::vector<std::vector<Vec2>> polygons;
  for (const Polyline& line : lines)
    if (line.closed) polygons.push_back(line.points);
  return polygons;
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
      depth += contains(lines[m], line.points[0]);
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

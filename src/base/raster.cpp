#include "base/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/ensure.h"
#include "base/within.h"

namespace artisketch {
namespace {

bool usable(const Vec2& p) {
  return std::abs(p.x()) <= kFarthestPixel && std::abs(p.y()) <= kFarthestPixel;  // false for NaN
}

// The first of n pixels whose centre lies at or beyond x.
int first_pixel(double x, int n) {
  // Truncation in place of std::ceil, which is a call on plain x86-64 and half the time of a mask.
  const double t = within(x - 0.5, 0, n);
  const int whole = int(t);
  return whole + (t > whole);
}

// An edge that runs down the raster. Whoever shares it computes the same crossings, digit for
// digit, because its ends are ordered first.
struct Edge {
  Vec2 top;
  double slope = 0;  // x per y
  double x(double y) const { return top.x() + (y - top.y()) * slope; }
};

// The upper end comes first; a level edge crosses no row, so its slope is never asked for.
Edge edge(const Vec2& upper, const Vec2& lower) {
  return {upper, (lower.x() - upper.x()) / (lower.y() - upper.y())};
}

// Calls fill(y, x0, x1) for each row's pixels x0 ≤ x < x1 inside the triangle.
template <class Fill>
void for_spans(Vec2 a, Vec2 b, Vec2 c, int width, int height, Fill&& fill) {
  if (!usable(a) || !usable(b) || !usable(c)) return;
  if (b.y() < a.y()) std::swap(a, b);
  if (c.y() < b.y()) std::swap(b, c);
  if (b.y() < a.y()) std::swap(a, b);
  const int start = first_pixel(a.y(), height), end = first_pixel(c.y(), height);
  if (start >= end) return;
  const int middle = first_pixel(b.y(), height);
  const Edge whole = edge(a, c);
  const auto rows = [&](int from, int to, const Edge& side) {
    for (int y = from; y < to; ++y) {
      const double u = whole.x(y + 0.5), v = side.x(y + 0.5);
      const int x0 = first_pixel(std::min(u, v), width), x1 = first_pixel(std::max(u, v), width);
      if (x0 < x1) fill(y, x0, x1);
    }
  };
  if (start < middle) rows(start, middle, edge(a, b));
  if (middle < end) rows(middle, end, edge(b, c));
}

// A value that varies linearly over the raster, given at three points.
struct Plane {
  Vec2 at;
  double value = 0, dx = 0, dy = 0;
  double operator()(double x, double y) const {
    return value + dx * (x - at.x()) + dy * (y - at.y());
  }
};

Plane plane(const Vec2& a, const Vec2& b, const Vec2& c, double va, double vb, double vc) {
  const Vec2 u = b - a, v = c - a;
  const double area = u.x() * v.y() - u.y() * v.x();
  if (area == 0) return {a, va, 0, 0};
  const double p = vb - va, q = vc - va;
  return {a, va, (p * v.y() - q * u.y()) / area, (q * u.x() - p * v.x()) / area};
}

std::vector<std::array<int, 2>> outline_pixels(const Mask& mask) {
  std::vector<std::array<int, 2>> outline;
  const int w = mask.width, h = mask.height;
  for (int y = 0; y < h; ++y) {
    const std::uint8_t* row = &mask.in[std::size_t(y) * w];
    for (int x = 0; x < w; ++x) {
      if (!row[x]) continue;
      const bool border = x == 0 || y == 0 || x == w - 1 || y == h - 1;
      if (border || !row[x - 1] || !row[x + 1] || !row[x - w] || !row[x + w])
        outline.push_back({x, y});
    }
  }
  return outline;
}

constexpr int kFarRow = 1 << 20;  // no outline pixel in this column

// For every pixel the number of rows to the nearest outline pixel of its column.
std::vector<int> rows_to(const std::vector<std::array<int, 2>>& outline, int width, int height) {
  std::vector<int> rows(std::size_t(width) * height, kFarRow);
  for (const auto& [x, y] : outline) rows[std::size_t(y) * width + x] = 0;
  for (std::size_t i = width; i < rows.size(); ++i)
    rows[i] = std::min(rows[i], rows[i - width] + 1);
  for (std::size_t i = rows.size() - width; i-- > 0;)
    rows[i] = std::min(rows[i], rows[i + width] + 1);
  return rows;
}

double mean_distance(const std::vector<std::array<int, 2>>& from, const std::vector<int>& rows,
                     int width) {
  double sum = 0;
  for (const auto& [x, y] : from) {
    const int* row = &rows[std::size_t(y) * width];
    std::int64_t best = std::int64_t(row[x]) * row[x];
    // Columns further away than the best can't hold a nearer pixel: exact, and short where the
    // outlines are close.
    for (std::int64_t d = 1; d * d < best && (x - d >= 0 || x + d < width); ++d) {
      if (x - d >= 0) best = std::min(best, d * d + std::int64_t(row[x - d]) * row[x - d]);
      if (x + d < width) best = std::min(best, d * d + std::int64_t(row[x + d]) * row[x + d]);
    }
    sum += std::sqrt(double(best));
  }
  return sum / double(from.size());
}

}  // namespace

void add_polygons(std::span<const std::vector<Vec2>> polygons, Mask& mask) {
  struct Crossing {
    int row;
    double x;
  };
  std::vector<Crossing> crossings;
  for (const std::vector<Vec2>& polygon : polygons) {
    if (!std::all_of(polygon.begin(), polygon.end(), usable)) continue;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (b.y() < a.y()) std::swap(a, b);
      const int start = first_pixel(a.y(), mask.height), end = first_pixel(b.y(), mask.height);
      if (start >= end) continue;
      const Edge e = edge(a, b);
      for (int y = start; y < end; ++y) crossings.push_back({y, e.x(y + 0.5)});
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.row != b.row ? a.row < b.row : a.x < b.x;
  });
  // A closed line crosses each row an even number of times.
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const int x0 = first_pixel(crossings[i].x, mask.width);
    const int x1 = first_pixel(crossings[i + 1].x, mask.width);
    if (x0 < x1) std::memset(&mask.at(x0, crossings[i].row), 1, x1 - x0);
  }
}

void add_triangles(std::span<const Vec2> pixels, const Triangles& F, Mask& mask) {
  for (int f = 0; f < F.rows(); ++f)
    for_spans(pixels[F(f, 0)], pixels[F(f, 1)], pixels[F(f, 2)], mask.width, mask.height,
              [&](int y, int x0, int x1) { std::memset(&mask.at(x0, y), 1, x1 - x0); });
}

void add_surface(std::span<const Vec2> pixels, const Triangles& F, Mask& mask) {
  for (int f = 0; f < F.rows(); ++f) {
    const Vec2 &a = pixels[F(f, 0)], &b = pixels[F(f, 1)], &c = pixels[F(f, 2)];
    const Vec2 u = b - a, v = c - a;
    if (u.x() * v.y() - u.y() * v.x() < 0) continue;
    for_spans(a, b, c, mask.width, mask.height,
              [&](int y, int x0, int x1) { std::memset(&mask.at(x0, y), 1, x1 - x0); });
  }
}

double intersection_over_union(const Mask& a, const Mask& b) {
  ensure(a.width == b.width && a.height == b.height, "masks of one size");
  std::size_t both = 0, either = 0;
  for (int y = 0; y < a.height; ++y) {
    const std::uint8_t *p = &a.in[std::size_t(y) * a.width], *q = &b.in[std::size_t(y) * a.width];
    unsigned row_both = 0, row_either = 0;
    for (int x = 0; x < a.width; ++x) {
      row_both += p[x] & q[x];
      row_either += p[x] | q[x];
    }
    both += row_both;
    either += row_either;
  }
  return either ? double(both) / double(either) : 1;
}

double outline_distance(const Mask& a, const Mask& b) {
  ensure(a.width == b.width && a.height == b.height, "masks of one size");
  const auto outline_a = outline_pixels(a), outline_b = outline_pixels(b);
  if (outline_a.empty() && outline_b.empty()) return 0;
  if (outline_a.empty() || outline_b.empty()) return std::numeric_limits<double>::infinity();
  return (mean_distance(outline_a, rows_to(outline_b, a.width, a.height), a.width) +
          mean_distance(outline_b, rows_to(outline_a, a.width, a.height), a.width)) /
         2;
}

Visible raster_triangles(std::span<const Vec2> pixels, std::span<const double> depth,
                         std::span<const double> w, const Triangles& F, int width, int height) {
  Visible seen{
      width, height, std::vector<int>(std::size_t(width) * height, -1),
      std::vector<float>(std::size_t(width) * height, std::numeric_limits<float>::infinity())};
  for (int f = 0; f < F.rows(); ++f) {
    const int i = F(f, 0), j = F(f, 1), k = F(f, 2);
    const Vec2 &a = pixels[i], &b = pixels[j], &c = pixels[k];
    // Slivers extrapolate wildly within their rounding: hold them between their corners.
    const double nearest = std::min({depth[i], depth[j], depth[k]});
    const double farthest = std::max({depth[i], depth[j], depth[k]});
    Plane value, share{a, 1, 0, 0};
    bool ready = false;
    for_spans(a, b, c, width, height, [&](int y, int x0, int x1) {
      if (!ready) {  // many triangles are smaller than a pixel and never come here
        ready = true;
        if (w.empty()) {
          value = plane(a, b, c, depth[i], depth[j], depth[k]);
        } else {
          value = plane(a, b, c, depth[i] / w[i], depth[j] / w[j], depth[k] / w[k]);
          share = plane(a, b, c, 1 / w[i], 1 / w[j], 1 / w[k]);
        }
      }
      const float low = float(nearest), high = float(farthest);
      const float v0 = float(value(x0 + 0.5, y + 0.5)), dv = float(value.dx);
      const float s0 = float(share(x0 + 0.5, y + 0.5)), ds = float(share.dx);
      float* z = &seen.depth[std::size_t(y) * width + x0];
      int* face = &seen.face[std::size_t(y) * width + x0];
      const auto keep = [&](int n, float d) {
        d = std::clamp(d, low, high);
        if (d < z[n]) {
          z[n] = d;
          face[n] = f;
        }
      };
      if (w.empty())
        for (int n = 0; n < x1 - x0; ++n) keep(n, v0 + dv * n);
      else
        for (int n = 0; n < x1 - x0; ++n) keep(n, (v0 + dv * n) / (s0 + ds * n));
    });
  }
  return seen;
}

Vec3 corner_weights(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c, const Vec3& w) {
  const auto twice_area = [](const Vec2& u, const Vec2& v) {
    return u.x() * v.y() - u.y() * v.x();
  };
  const double area = twice_area(b - a, c - a);
  if (area == 0) return {1, 0, 0};
  const double wb = twice_area(p - a, c - a) / area, wc = twice_area(b - a, p - a) / area;
  const Vec3 weights = Vec3(1 - wb - wc, wb, wc).cwiseMax(0.0).cwiseQuotient(w);
  return weights / weights.sum();
}

}  // namespace artisketch

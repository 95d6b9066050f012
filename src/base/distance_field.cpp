#include "base/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/ensure.h"
#include "base/within.h"

namespace artisketch {
namespace {

// Lists per bucket in one array: count, prefix sums, fill.
void to_lists(const std::vector<std::pair<int, int>>& bucket_item, int buckets,
              std::vector<int>& start, std::vector<int>& items) {
  start.assign(buckets + 1, 0);
  for (const auto& [bucket, item] : bucket_item) ++start[bucket + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  items.resize(bucket_item.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (const auto& [bucket, item] : bucket_item) items[next[bucket]++] = item;
}

// Whether p is a place in a plane that is drawn on: NaN is none, nor is what would overflow when it
// is squared. A polygon with a point that is none is left out; a query at none is infinitely far
// outside.
bool is_place(const Vec2& p) {
  constexpr double kFarthest = 1e9;
  return std::abs(p.x()) <= kFarthest && std::abs(p.y()) <= kFarthest;
}

}  // namespace

PolygonDistance::PolygonDistance(std::span<const std::vector<Vec2>> polygons) {
  for (const std::vector<Vec2>& polygon : polygons) {
    if (!std::all_of(polygon.begin(), polygon.end(), is_place)) continue;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      segments_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
      box_.extend(polygon[i]);
    }
  }
  if (segments_.empty()) return;
  const Vec2 size = box_.sizes().cwiseMax(1e-9);
  // About as many buckets as segments: a query near the line then looks at a handful of them.
  bucket_ = std::max(std::sqrt(size.x() * size.y() / segments_.size()), size.maxCoeff() / 512);
  nx_ = int(size.x() / bucket_) + 1;
  ny_ = int(size.y() / bucket_) + 1;
  std::vector<std::pair<int, int>> in_bucket, in_row;
  for (int s = 0; s < int(segments_.size()); ++s) {
    const Vec2 a = (segments_[s].a - box_.min()) / bucket_,
               b = (segments_[s].b - box_.min()) / bucket_;
    const int y0 = std::min(int(std::min(a.y(), b.y())), ny_ - 1);
    const int y1 = std::min(int(std::max(a.y(), b.y())), ny_ - 1);
    for (int y = y0; y <= y1; ++y) {
      in_row.emplace_back(y, s);
      // The stretch of the segment inside this row of buckets.
      double t0 = 0, t1 = 1;
      if (a.y() != b.y()) {
        const double u = (y - a.y()) / (b.y() - a.y()), v = (y + 1 - a.y()) / (b.y() - a.y());
        t0 = std::clamp(std::min(u, v), 0.0, 1.0);
        t1 = std::clamp(std::max(u, v), 0.0, 1.0);
      }
      const double xa = a.x() + t0 * (b.x() - a.x()), xb = a.x() + t1 * (b.x() - a.x());
      const int x0 = std::clamp(int(std::min(xa, xb) - 1e-9), 0, nx_ - 1);
      const int x1 = std::clamp(int(std::max(xa, xb) + 1e-9), 0, nx_ - 1);
      for (int x = x0; x <= x1; ++x) in_bucket.emplace_back(y * nx_ + x, s);
    }
  }
  to_lists(in_bucket, nx_ * ny_, bucket_start_, bucket_segments_);
  to_lists(in_row, ny_, row_start_, row_segments_);
}

bool PolygonDistance::inside(const Vec2& p) const {
  if (segments_.empty() || !is_place(p) || !box_.contains(p)) return false;
  const int y = std::min(int((p.y() - box_.min().y()) / bucket_), ny_ - 1);
  bool odd = false;
  for (int i = row_start_[y]; i < row_start_[y + 1]; ++i) {
    const Segment& s = segments_[row_segments_[i]];
    if ((s.a.y() > p.y()) != (s.b.y() > p.y()) &&
        p.x() < s.a.x() + (s.b.x() - s.a.x()) * (p.y() - s.a.y()) / (s.b.y() - s.a.y()))
      odd = !odd;
  }
  return odd;
}

double PolygonDistance::nearest(const Vec2& p, Vec2& on_line) const {
  const Vec2 at = (p - box_.min()) / bucket_;
  const int cx = int(within(at.x(), 0, nx_ - 1));
  const int cy = int(within(at.y(), 0, ny_ - 1));
  double best2 = std::numeric_limits<double>::infinity();
  const auto look = [&](int x, int y) {
    for (int i = bucket_start_[y * nx_ + x]; i < bucket_start_[y * nx_ + x + 1]; ++i) {
      const Segment& s = segments_[bucket_segments_[i]];
      const Vec2 d = s.b - s.a;
      const double dd = d.squaredNorm();
      const double t = dd > 0 ? std::clamp((p - s.a).dot(d) / dd, 0.0, 1.0) : 0.0;
      const Vec2 q = s.a + t * d;
      const double r2 = (p - q).squaredNorm();
      if (r2 < best2) {
        best2 = r2;
        on_line = q;
      }
    }
  };
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  for (int r = 0; r <= std::max(nx_, ny_); ++r) {
    // The rings before r cover a square of buckets round p's own: what they left out lies at least
    // as far as that square's nearest side beyond which there still are buckets.
    const int x0 = cx - r, x1 = cx + r, y0 = cy - r, y1 = cy + r;
    const double reach =
        std::min({x0 < 0 ? kNothing : at.x() - (x0 + 1), x1 >= nx_ ? kNothing : x1 - at.x(),
                  y0 < 0 ? kNothing : at.y() - (y0 + 1), y1 >= ny_ ? kNothing : y1 - at.y()});
    if (reach == kNothing && r > 0) break;
    if (r > 0 && reach > 0 && best2 <= reach * reach * bucket_ * bucket_) break;
    for (int y = std::max(y0, 0); y <= std::min(y1, ny_ - 1); ++y) {
      const bool whole = y == y0 || y == y1;
      if (whole)
        for (int x = std::max(x0, 0); x <= std::min(x1, nx_ - 1); ++x) look(x, y);
      else {
        if (x0 >= 0) look(x0, y);
        if (x1 < nx_) look(x1, y);
      }
    }
  }
  return std::sqrt(best2);
}

double PolygonDistance::distance(const Vec2& p) const {
  if (segments_.empty()) return std::numeric_limits<double>::infinity();
  Vec2 q;
  const double d = nearest(p, q);
  return inside(p) ? -d : d;
}

double PolygonDistance::distance(const Vec2& p, Vec2& gradient) const {
  gradient.setZero();
  if (segments_.empty()) return std::numeric_limits<double>::infinity();
  Vec2 q = p;
  const double d = nearest(p, q);
  const double sign = inside(p) ? -1 : 1;
  if (d > 1e-12 && std::isfinite(d)) gradient = (p - q) * (sign / d);
  return sign * d;
}

// In samples from the raster's origin. Where none is known yet it is very far away, so that the
// passes need no other test.
struct SampledDistance::Nearest {
  static constexpr float kFar = 1e9f;
  std::vector<float> x, y, squared;
  explicit Nearest(std::size_t n) : x(n, kFar), y(n, kFar), squared(n, kFar * kFar) {}
};

SampledDistance::SampledDistance(const PolygonDistance& exact, double per_pixel, double margin)
    : per_pixel_(per_pixel) {
  if (exact.empty()) return;
  origin_ = exact.box().min() - Vec2::Constant(margin);
  const Vec2 size = exact.box().sizes() + Vec2::Constant(2 * margin);
  constexpr double kMostSamples = 1e6;  // along an axis, far more than memory holds of squares
  ensure(size.maxCoeff() * per_pixel <= kMostSamples, "a raster that can be held");
  nx_ = int(std::ceil(size.x() * per_pixel)) + 2;
  ny_ = int(std::ceil(size.y() * per_pixel)) + 2;
  Nearest nearest(std::size_t(nx_) * ny_);
  seed(exact, nearest);
  propagate(nearest);
  values_.resize(nearest.squared.size());
  const float to_pixels = float(1 / per_pixel);
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] = std::sqrt(nearest.squared[i]) * to_pixels;
  take_signs(exact);
}

// The exact nearest point of the lines for every sample within a step or so of them. They stand a
// step apart along the lines at most, so that a sample further off, at n steps, that takes the best
// of them errs by less than 1 / (8 n) of a step.
void SampledDistance::seed(const PolygonDistance& exact, Nearest& nearest) const {
  constexpr double kBand = 1.5;  // samples: more than a cell's diagonal, so the band has no leaks
  for (const PolygonDistance::Segment& s : exact.segments_) {
    const Vec2 a = (s.a - origin_) * per_pixel_, d = (s.b - s.a) * per_pixel_;
    const double dd = d.squaredNorm();
    const int y0 = std::max(0, int(std::ceil(std::min(a.y(), a.y() + d.y()) - kBand)));
    const int y1 = std::min(ny_ - 1, int(std::floor(std::max(a.y(), a.y() + d.y()) + kBand)));
    for (int y = y0; y <= y1; ++y) {
      // The stretch of the segment within the band above and below this row.
      double t0 = 0, t1 = 1;
      if (std::abs(d.y()) > 1e-12) {
        const double u = (y - kBand - a.y()) / d.y(), v = (y + kBand - a.y()) / d.y();
        t0 = std::clamp(std::min(u, v), 0.0, 1.0);
        t1 = std::clamp(std::max(u, v), 0.0, 1.0);
      }
      const double xa = a.x() + t0 * d.x(), xb = a.x() + t1 * d.x();
      const int x0 = std::max(0, int(std::ceil(std::min(xa, xb) - kBand)));
      const int x1 = std::min(nx_ - 1, int(std::floor(std::max(xa, xb) + kBand)));
      for (int x = x0; x <= x1; ++x) {
        const Vec2 p(x, y);
        const double t = dd > 0 ? std::clamp((p - a).dot(d) / dd, 0.0, 1.0) : 0.0;
        const Vec2 q = a + t * d;
        const float squared = float((p - q).squaredNorm());
        const std::size_t at = std::size_t(y) * nx_ + x;
        if (squared >= nearest.squared[at]) continue;
        nearest.squared[at] = squared;
        nearest.x[at] = float(q.x());
        nearest.y[at] = float(q.y());
      }
    }
  }
}

// Each sample takes its neighbours' nearest point where that is nearer than its own: rows down,
// then up, each swept both ways (Danielsson 1980, with eight neighbours).
void SampledDistance::propagate(Nearest& nearest) const {
  float *const X = nearest.x.data(), *const Y = nearest.y.data(), *const S = nearest.squared.data();
  // From samples [from, from + n) of the row before, to as many of this one; both rows apart in
  // memory, written so that compilers vectorise it.
  const auto across = [&](std::size_t from, std::size_t to, int x0, int n, float y) {
    const float* __restrict fx = X + from, * __restrict fy = Y + from;
    float* __restrict tx = X + to, * __restrict ty = Y + to, * __restrict ts = S + to;
    for (int i = 0; i < n; ++i) {
      const float dx = float(x0 + i) - fx[i], dy = y - fy[i], d2 = dx * dx + dy * dy;
      const bool nearer = d2 < ts[i];
      ts[i] = nearer ? d2 : ts[i];
      tx[i] = nearer ? fx[i] : tx[i];
      ty[i] = nearer ? fy[i] : ty[i];
    }
  };
  // The nearest point so far walks along in registers.
  const auto along = [&](std::size_t row, int y, int first, int last, int step) {
    float px = X[row + first], py = Y[row + first];
    for (int x = first; x != last; x += step) {
      const std::size_t at = row + x;
      const float dx = x - px, dy = y - py, d2 = dx * dx + dy * dy;
      if (d2 < S[at]) {
        S[at] = d2;
        X[at] = px;
        Y[at] = py;
      } else {
        px = X[at];
        py = Y[at];
      }
    }
  };
  const auto row = [&](int y, int before) {
    const std::size_t here = std::size_t(y) * nx_, there = std::size_t(before) * nx_;
    if (before >= 0 && before < ny_) {
      across(there, here, 0, nx_, float(y));
      across(there, here + 1, 1, nx_ - 1, float(y));
      across(there + 1, here, 0, nx_ - 1, float(y));
    }
    along(here, y, 0, nx_, 1);
    along(here, y, nx_ - 1, -1, -1);
  };
  for (int y = 0; y < ny_; ++y) row(y, y - 1);
  for (int y = ny_ - 1; y >= 0; --y) row(y, y + 1);
}

// Even-odd along each row of samples: from the second crossing back to the first, and so on.
void SampledDistance::take_signs(const PolygonDistance& exact) {
  std::vector<std::pair<int, double>> crossings;  // row, x in samples
  for (const PolygonDistance::Segment& s : exact.segments_) {
    const Vec2 a = (s.a - origin_) * per_pixel_, b = (s.b - origin_) * per_pixel_;
    // A row counts where exactly one end lies above it: y in [lower, upper).
    const int y0 = std::max(0, int(std::ceil(std::min(a.y(), b.y()))));
    for (int y = y0; y < std::min(double(ny_), std::max(a.y(), b.y())); ++y)
      crossings.emplace_back(y, a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const int y = crossings[i].first;
    const int x0 = std::max(0, int(std::ceil(crossings[i].second)));
    const int x1 = std::min(nx_ - 1, int(std::ceil(crossings[i + 1].second)) - 1);
    for (int x = x0; x <= x1; ++x) values_[std::size_t(y) * nx_ + x] *= -1;
  }
}

double SampledDistance::distance_beyond(const Vec2& p, Vec2& gradient) const {
  if (values_.empty()) {
    gradient.setZero();
    return std::numeric_limits<double>::infinity();
  }
  const double rx = (p.x() - origin_.x()) * per_pixel_, ry = (p.y() - origin_.y()) * per_pixel_;
  const double ax = within(rx, 0, nx_ - 1.001), ay = within(ry, 0, ny_ - 1.001);
  const double value = interpolated(ax, ay, gradient);
  if (rx == ax && ry == ay) return value;
  // As far as from the point that is nearest to the border's.
  const Vec2 away = Vec2(rx - ax, ry - ay) / per_pixel_ + value * gradient.normalized();
  const double way = away.norm();
  gradient = away / way;
  return way;
}

}  // namespace artisketch

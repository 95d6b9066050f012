#include "base/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

}  // namespace

PolygonDistance::PolygonDistance(std::span<const std::vector<Vec2>> polygons) {
  for (const std::vector<Vec2>& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      segments_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
      box_.extend(polygon[i]);
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
  if (segments_.empty() || !box_.contains(p)) return false;
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
  const int cx = std::clamp(int(std::floor(at.x())), 0, nx_ - 1);
  const int cy = std::clamp(int(std::floor(at.y())), 0, ny_ - 1);
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
  if (d > 1e-12) gradient = (p - q) * (sign / d);
  return sign * d;
}

SampledDistance::SampledDistance(const PolygonDistance& exact, double per_pixel, double margin)
    : per_pixel_(per_pixel) {
  if (exact.empty()) return;
  origin_ = exact.box().min() - Vec2::Constant(margin);
  const Vec2 size = exact.box().sizes() + Vec2::Constant(2 * margin);
  nx_ = int(std::ceil(size.x() * per_pixel)) + 2;
  ny_ = int(std::ceil(size.y() * per_pixel)) + 2;
  values_.resize(std::size_t(nx_) * ny_);
  for (int y = 0; y < ny_; ++y)
    for (int x = 0; x < nx_; ++x)
      values_[std::size_t(y) * nx_ + x] = float(exact.distance(origin_ + Vec2(x, y) / per_pixel));
}

double SampledDistance::distance(const Vec2& p) const {
  Vec2 gradient;
  return distance(p, gradient);
}

double SampledDistance::distance(const Vec2& p, Vec2& gradient) const {
  gradient.setZero();
  if (values_.empty()) return std::numeric_limits<double>::infinity();
  const Vec2 raw = (p - origin_) * per_pixel_;
  const Vec2 at(std::clamp(raw.x(), 0.0, nx_ - 1.001), std::clamp(raw.y(), 0.0, ny_ - 1.001));
  const int x = int(at.x()), y = int(at.y());
  const double wx = at.x() - x, wy = at.y() - y;
  const float* v = &values_[std::size_t(y) * nx_ + x];
  const double low = (1 - wx) * v[0] + wx * v[1], high = (1 - wx) * v[nx_] + wx * v[nx_ + 1];
  gradient.x() = ((1 - wy) * (v[1] - v[0]) + wy * (v[nx_ + 1] - v[nx_])) * per_pixel_;
  gradient.y() = (high - low) * per_pixel_;
  double value = (1 - wy) * low + wy * high;
  const Vec2 beyond = (raw - at) / per_pixel_;
  const double way = beyond.norm();
  if (way > 1e-9) {
    value += way;
    gradient = beyond / way;
  }
  return value;
}

}  // namespace artisketch

// Signed distance to closed lines in the plane.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace artisketch {

// Signed Euclidean distance to a set of polygons by the even-odd rule: negative inside, positive
// outside, in the polygons' own units (pixels). Exact: segments lie in square buckets that are
// searched outward from the query, the sign comes from a winding table per bucket row.
class PolygonDistance {
 public:
  PolygonDistance() = default;
  // Each polygon: three or more points; its last joins its first.
  explicit PolygonDistance(std::span<const std::vector<Vec2>> polygons);

  bool empty() const { return segments_.empty(); }
  double distance(const Vec2& p) const;  // +infinity where there are no polygons
  // The distance and its gradient, which is the unit vector away from the inside (zero on the
  // line).
  double distance(const Vec2& p, Vec2& gradient) const;
  bool inside(const Vec2& p) const;
  const Box2& box() const { return box_; }

 private:
  friend class SampledDistance;
  struct Segment {
    Vec2 a, b;
  };
  double nearest(const Vec2& p, Vec2& on_line) const;

  std::vector<Segment> segments_;
  Box2 box_;
  double bucket_ = 1;
  int nx_ = 0, ny_ = 0;
  std::vector<int> bucket_start_, bucket_segments_;  // segments that touch each bucket
  std::vector<int> row_start_, row_segments_;        // segments that span each bucket row in y
};

// PolygonDistance on a pixel raster, for the many queries of a voxel grid or a search along rays:
// bilinear between samples `1 / per_pixel` apart, beyond its border the distance to the point of
// the lines that is nearest to the border. Within 0.1 samples of the exact distance away from the
// lines' corners. Built in time linear in the samples (some 10 ns each) and in the outline's
// length.
class SampledDistance {
 public:
  SampledDistance() = default;
  SampledDistance(const PolygonDistance& exact, double per_pixel, double margin);

  // Here since searches along rays do little else.
  double distance(const Vec2& p) const {
    const double x = (p.x() - origin_.x()) * per_pixel_, y = (p.y() - origin_.y()) * per_pixel_;
    if (!(x >= 0 && y >= 0 && x < nx_ - 1.001 && y < ny_ - 1.001)) {
      Vec2 gradient;
      return distance_beyond(p, gradient);
    }
    const int i = int(x), j = int(y);
    const double wx = x - i, wy = y - j;
    const float* v = &values_[std::size_t(j) * nx_ + i];
    const double low = v[0] + wx * (v[1] - v[0]), high = v[nx_] + wx * (v[nx_ + 1] - v[nx_]);
    return low + wy * (high - low);
  }
  double distance(const Vec2& p, Vec2& gradient) const {
    const double x = (p.x() - origin_.x()) * per_pixel_, y = (p.y() - origin_.y()) * per_pixel_;
    if (!(x >= 0 && y >= 0 && x < nx_ - 1.001 && y < ny_ - 1.001))
      return distance_beyond(p, gradient);
    return interpolated(x, y, gradient);
  }
  bool empty() const { return values_.empty(); }

 private:
  // At x, y in samples, within the raster.
  double interpolated(double x, double y, Vec2& gradient) const {
    const int i = int(x), j = int(y);
    const double wx = x - i, wy = y - j;
    const float* v = &values_[std::size_t(j) * nx_ + i];
    const double v00 = v[0], v10 = v[1], v01 = v[nx_], v11 = v[nx_ + 1];
    const double low = v00 + wx * (v10 - v00), high = v01 + wx * (v11 - v01);
    gradient.x() = ((1 - wy) * (v10 - v00) + wy * (v11 - v01)) * per_pixel_;
    gradient.y() = (high - low) * per_pixel_;
    return low + wy * (high - low);
  }
  double distance_beyond(const Vec2& p, Vec2& gradient) const;  // the raster's border

  struct Nearest;  // per sample, the nearest known point of the lines
  void seed(const PolygonDistance& exact, Nearest& nearest) const;
  void propagate(Nearest& nearest) const;
  void take_signs(const PolygonDistance& exact);

  Vec2 origin_ = Vec2::Zero();
  double per_pixel_ = 1;
  int nx_ = 0, ny_ = 0;
  std::vector<float> values_;
};

}  // namespace artisketch

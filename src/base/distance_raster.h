// Signed distance to closed lines on a raster: quick to make and quicker to read, for the millions
// of queries of a voxel grid. distance_field.h has the exact one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "base/types.h"

namespace artisketch {

// Even-odd signed distance to polygons, negative inside, bilinear between samples `step` apart (in
// the polygons' unit, pixels). Samples within kBand steps of a line are exact, farther ones within
// a few per cent (their nearest line is found by sweeping). Outside the raster: the border's value
// plus the way to it.
class DistanceRaster {
 public:
  static constexpr int kBand = 2;

  DistanceRaster() = default;
  // margin: how far the raster reaches beyond the polygons' box, pixels. step > 0.
  DistanceRaster(std::span<const std::vector<Vec2>> polygons, double step, double margin);

  bool empty() const { return values_.empty(); }
  float distance(float x, float y) const {  // pixels; +infinity where there are no polygons
    if (values_.empty()) return std::numeric_limits<float>::infinity();
    const float u = (x - x0_) * per_step_, v = (y - y0_) * per_step_;
    const float cu = std::min(std::max(u, 0.f), max_u_), cv = std::min(std::max(v, 0.f), max_v_);
    const int i = int(cu), j = int(cv);
    const float wu = cu - float(i), wv = cv - float(j);
    const float* s = &values_[std::size_t(j) * nx_ + i];
    const float low = s[0] + wu * (s[1] - s[0]);
    const float high = s[nx_] + wu * (s[nx_ + 1] - s[nx_]);
    const float inner = low + wv * (high - low);
    if (u == cu && v == cv) return inner;
    return inner + std::sqrt((u - cu) * (u - cu) + (v - cv) * (v - cv)) * step_;
  }
  double distance(const Vec2& p) const { return distance(float(p.x()), float(p.y())); }
  // Lowers the distances about each place by its amount there, fading to nothing at `width` times
  // the amount (at least two steps) away; where places overlap the larger counts.
  struct Swelling {
    Vec2 at;
    double amount;  // pixels, > 0
  };
  void swell(std::span<const Swelling> places, double width);
  double deepest() const { return deepest_; }  // largest distance inside, pixels

 private:
  float x0_ = 0, y0_ = 0, step_ = 1, per_step_ = 1, max_u_ = 0, max_v_ = 0;
  int nx_ = 0, ny_ = 0;
  double deepest_ = 0;
  std::vector<float> values_;
};

}  // namespace artisketch

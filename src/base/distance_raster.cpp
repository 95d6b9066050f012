#include "base/distance_raster.h"

namespace artisketch {
namespace {

struct Foot {  // the nearest point on a line found so far, in steps; before that, one far away
  float x = 1e12f, y = 1e12f;
  float d2 = std::numeric_limits<float>::max();
};

// Exact feet for the samples within `band` steps of one segment.
void splat(const Vec2& a, const Vec2& b, float band, int nx, int ny, std::vector<Foot>& feet) {
  const int x0 = std::max(0, int(std::ceil(std::min(a.x(), b.x()) - band)));
  const int x1 = std::min(nx - 1, int(std::floor(std::max(a.x(), b.x()) + band)));
  const int y0 = std::max(0, int(std::ceil(std::min(a.y(), b.y()) - band)));
  const int y1 = std::min(ny - 1, int(std::floor(std::max(a.y(), b.y()) + band)));
  const float dx = float(b.x() - a.x()), dy = float(b.y() - a.y());
  const float dd = dx * dx + dy * dy, per_dd = dd > 0 ? 1 / dd : 0;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const float px = float(x - a.x()), py = float(y - a.y());
      const float t = std::min(std::max((px * dx + py * dy) * per_dd, 0.f), 1.f);
      const float rx = px - t * dx, ry = py - t * dy;
      const float d2 = rx * rx + ry * ry;
      Foot& foot = feet[std::size_t(y) * nx + x];
      if (d2 < foot.d2) foot = {float(x) - rx, float(y) - ry, d2};
    }
}

// Long segments in pieces, so that their boxes hold little besides their band.
void splat_in_pieces(const Vec2& a, const Vec2& b, float band, int nx, int ny,
                     std::vector<Foot>& feet) {
  const Vec2 d = b - a;
  const double narrow = d.cwiseAbs().minCoeff();
  const int pieces = 1 + int(narrow / (2 * band));
  for (int i = 0; i < pieces; ++i)
    splat(a + d * (double(i) / pieces), a + d * (double(i + 1) / pieces), band, nx, ny, feet);
}

// Hands every sample its neighbours' feet, there and back (Danielsson's 4SED, 1980).
void sweep(int nx, int ny, std::vector<Foot>& feet) {
  const auto take = [&](int x, int y, int from_x, int from_y) {
    const Foot& other = feet[std::size_t(from_y) * nx + from_x];
    Foot& mine = feet[std::size_t(y) * nx + x];
    const float dx = float(x) - other.x, dy = float(y) - other.y, d2 = dx * dx + dy * dy;
    if (d2 < mine.d2) mine = {other.x, other.y, d2};
  };
  const auto along = [&](int y) {
    for (int x = 1; x < nx; ++x) take(x, y, x - 1, y);
    for (int x = nx - 2; x >= 0; --x) take(x, y, x + 1, y);
  };
  along(0);
  for (int y = 1; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) take(x, y, x, y - 1);
    along(y);
  }
  for (int y = ny - 2; y >= 0; --y) {
    for (int x = 0; x < nx; ++x) take(x, y, x, y + 1);
    along(y);
  }
}

}  // namespace

DistanceRaster::DistanceRaster(std::span<const std::vector<Vec2>> polygons, double step,
                               double margin)
    : step_(float(step)), per_step_(float(1 / step)) {
  Box2 box;
  for (const std::vector<Vec2>& polygon : polygons)
    for (const Vec2& p : polygon) box.extend(p);
  if (box.isEmpty()) return;
  const Vec2 origin = box.min() - Vec2::Constant(margin);
  x0_ = float(origin.x());
  y0_ = float(origin.y());
  nx_ = int(std::ceil((box.sizes().x() + 2 * margin) / step)) + 2;
  ny_ = int(std::ceil((box.sizes().y() + 2 * margin) / step)) + 2;
  max_u_ = std::nextafter(float(nx_ - 1), 0.f);
  max_v_ = std::nextafter(float(ny_ - 1), 0.f);

  std::vector<Foot> feet(std::size_t(nx_) * ny_);
  std::vector<std::vector<float>> crossings(ny_);  // of each row of samples with the lines
  for (const std::vector<Vec2>& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = (polygon[i] - origin) / step;
      const Vec2 b = (polygon[(i + 1) % polygon.size()] - origin) / step;
      splat_in_pieces(a, b, kBand, nx_, ny_, feet);
      const Vec2 &low = a.y() < b.y() ? a : b, &high = a.y() < b.y() ? b : a;
      for (int y = int(std::floor(low.y())) + 1; y <= int(std::floor(high.y())); ++y)
        crossings[y].push_back(
            float(low.x() + (high.x() - low.x()) * (y - low.y()) / (high.y() - low.y())));
    }
  sweep(nx_, ny_, feet);

  values_.resize(feet.size());
  for (int y = 0; y < ny_; ++y) {
    std::vector<float>& row = crossings[y];
    std::sort(row.begin(), row.end());
    std::size_t passed = 0;
    for (int x = 0; x < nx_; ++x) {
      while (passed < row.size() && row[passed] <= float(x)) ++passed;
      const float d = std::sqrt(feet[std::size_t(y) * nx_ + x].d2) * step_;
      values_[std::size_t(y) * nx_ + x] = passed % 2 ? -d : d;
      if (passed % 2) deepest_ = std::max(deepest_, double(d));
    }
  }
}

void DistanceRaster::swell(std::span<const Swelling> places, double width) {
  std::vector<float> lowered(values_.size(), 0);
  for (const Swelling& place : places) {
    const float amount = float(place.amount);
    const float reach = std::max(float(width * place.amount), 2 * step_) * per_step_;
    const float cx = (float(place.at.x()) - x0_) * per_step_;
    const float cy = (float(place.at.y()) - y0_) * per_step_;
    for (int y = std::max(0, int(std::ceil(cy - reach))); y < std::min(float(ny_), cy + reach); ++y)
      for (int x = std::max(0, int(std::ceil(cx - reach))); x < std::min(float(nx_), cx + reach);
           ++x) {
        const float dx = float(x) - cx, dy = float(y) - cy;
        const float t = 1 - (dx * dx + dy * dy) / (reach * reach);
        if (t <= 0) continue;
        float& here = lowered[std::size_t(y) * nx_ + x];
        here = std::max(here, amount * t * t);
      }
  }
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] -= lowered[i];
}

}  // namespace artisketch

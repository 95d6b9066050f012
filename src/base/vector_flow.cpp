#include "base/vector_flow.h"

#include <algorithm>
#include <cmath>

namespace artisketch {
namespace {

constexpr float kSmoothness = 0.2f;  // μ: how far the flow reaches against how sharp it stays
constexpr int kSweeps = 40;          // Gauss–Seidel, to and fro: carries it over kReach steps
constexpr double kFelt = 4;          // steps beyond which an edge map of width one is nothing

}  // namespace

VectorFlow::VectorFlow(std::span<const Segment> segments, double step) : step_(step) {
  Box2 box;
  for (const auto& [a, b] : segments) box.extend(a).extend(b);
  if (box.isEmpty()) return;
  // A drawing a thousand steps wide is felt by no grid: keep the raster in bounds.
  step_ = std::max(step, box.sizes().maxCoeff() / 1000);
  origin_ = box.min() - Vec2::Constant(kReach * step_);
  nx_ = int(box.sizes().x() / step_) + 2 * kReach + 2;
  ny_ = int(box.sizes().y() / step_) + 2 * kReach + 2;

  std::vector<float> distance2(std::size_t(nx_) * ny_, float(kFelt * kFelt));
  for (const auto& [from, to] : segments) {
    const Vec2 a = (from - origin_) / step_, b = (to - origin_) / step_, d = b - a;
    const double dd = d.squaredNorm();
    const Vec2 low = a.cwiseMin(b) - Vec2::Constant(kFelt),
               high = a.cwiseMax(b) + Vec2::Constant(kFelt);
    for (int y = std::max(int(low.y()), 0); y <= std::min(int(high.y()), ny_ - 1); ++y)
      for (int x = std::max(int(low.x()), 0); x <= std::min(int(high.x()), nx_ - 1); ++x) {
        const Vec2 p = Vec2(x, y) - a;
        const double t = dd > 0 ? std::clamp(p.dot(d) / dd, 0.0, 1.0) : 0.0;
        float& least = distance2[std::size_t(y) * nx_ + x];
        least = std::min(least, float((p - t * d).squaredNorm()));
      }
  }
  edge_.resize(distance2.size());
  for (std::size_t i = 0; i < edge_.size(); ++i)
    edge_[i] = distance2[i] < kFelt * kFelt ? std::exp(-distance2[i] / 2) : 0;

  std::vector<float> fx(edge_.size(), 0), fy(edge_.size(), 0);
  for (int y = 1; y + 1 < ny_; ++y)
    for (int x = 1; x + 1 < nx_; ++x) {
      const std::size_t i = std::size_t(y) * nx_ + x;
      fx[i] = (edge_[i + 1] - edge_[i - 1]) / 2;
      fy[i] = (edge_[i + nx_] - edge_[i - nx_]) / 2;
    }
  u_ = fx;
  v_ = fy;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int row = 1; row + 1 < ny_; ++row)
      for (int column = 1; column + 1 < nx_; ++column) {
        const int y = sweep % 2 ? ny_ - 1 - row : row, x = sweep % 2 ? nx_ - 1 - column : column;
        const std::size_t i = std::size_t(y) * nx_ + x;
        const float held = fx[i] * fx[i] + fy[i] * fy[i], sum = 4 * kSmoothness + held;
        const auto relaxed = [&](const std::vector<float>& w, float f) {
          return (kSmoothness * (w[i - 1] + w[i + 1] + w[i - nx_] + w[i + nx_]) + held * f) / sum;
        };
        u_[i] = relaxed(u_, fx[i]);
        v_[i] = relaxed(v_, fy[i]);
      }
}

VectorFlow::Value VectorFlow::at(const Vec2& pixel) const {
  const Vec2 p = (pixel - origin_) / step_;
  if (!(p.x() >= 0 && p.y() >= 0 && p.x() < nx_ - 1 && p.y() < ny_ - 1)) return {};
  const int x = int(p.x()), y = int(p.y());
  const double wx = p.x() - x, wy = p.y() - y;
  const std::size_t i = std::size_t(y) * nx_ + x;
  const auto bilinear = [&](const std::vector<float>& w) {
    return (1 - wy) * ((1 - wx) * w[i] + wx * w[i + 1]) +
           wy * ((1 - wx) * w[i + nx_] + wx * w[i + nx_ + 1]);
  };
  return {bilinear(edge_), {bilinear(u_), bilinear(v_)}};
}

}  // namespace artisketch

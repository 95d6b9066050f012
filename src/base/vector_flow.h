// Gradient vector flow in the plane (Xu and Prince 1998): a field that points to the nearest lines
// near them, and carries that direction smoothly to where they are not felt.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "base/types.h"

namespace artisketch {

class VectorFlow {
 public:
  using Segment = std::pair<Vec2, Vec2>;

  VectorFlow() = default;
  // Edge map e = exp(−d² / 2 step²) of the distance d to the segments (pixels), on a raster of
  // `step` pixels that reaches `kReach` steps round them; flow: the equilibrium of
  // μ ∇²v = |∇e|² (v − ∇e).
  VectorFlow(std::span<const Segment> segments, double step);

  static constexpr int kReach = 8;

  struct Value {
    double edge = 0;           // 1 on a line, 0 far from all
    Vec2 flow = Vec2::Zero();  // toward the lines, in steps⁻¹: at most 0.61
  };
  Value at(const Vec2& pixel) const;  // bilinear; nothing beyond the raster

 private:
  Vec2 origin_ = Vec2::Zero();
  double step_ = 1;
  int nx_ = 0, ny_ = 0;
  std::vector<float> edge_, u_, v_;
};

}  // namespace artisketch

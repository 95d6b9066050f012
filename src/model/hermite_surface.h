// A smooth implicit surface through points with normals: a Hermite interpolant of radial functions
// (Wendland 2005, chapter 16; Macêdo, Gois and Velho 2011).
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "base/grid.h"
#include "base/types.h"

namespace artisketch {

struct SurfacePoint {
  Vec3 position;
  Vec3 normal;  // unit, outward
};

struct HermiteOptions {
  double value_ridge = 1e-5;    // how loosely f = 0 holds at the points
  double tangent_ridge = 1e-2;  // how loosely ∇f keeps the normal's direction
  double length_ridge = 1e-2;   // how loosely ∇f keeps length 1
  double quadric = 0;           // how freely an ellipsoid's quadratic function joins in
};

// f(x) = Σ aᵢ r³ − 3 r bᵢ·(x − cᵢ) + quadratic, the smoothest (least ∫|∇³f|²) with f(cᵢ) ≈ 0 and
// ∇f(cᵢ) ≈ nᵢ; negative inside, |∇f| ≈ 1 near the points.
class HermiteSurface {
 public:
  // Solves for #P points, 4 #P unknowns, dense. Points at the same place are fine.
  HermiteSurface(std::span<const SurfacePoint> points, const HermiteOptions& options);

  float value(const Vec3& p) const;
  // values[i] = f(start + i · step), i = 0 … n − 1.
  void values(const Vec3& start, const Vec3& step, int n, float* values) const;

 private:
  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1;                               // units of one of the unknowns' lengths
  Eigen::Matrix<float, 7, Eigen::Dynamic> terms_;  // centre, a, b of each point, in that scale
  Eigen::Matrix<double, 10, 1> polynomial_;        // 1, x, y, z, xx, yy, zz, yz, xz, xy
};

// field = max(field, f over its gradient's length) wherever the field is below `above`, in units:
// to first order the distance to the part of f's inside that the field leaves.
void raise(const HermiteSurface& f, double above, Grid3<float>& field);

}  // namespace artisketch

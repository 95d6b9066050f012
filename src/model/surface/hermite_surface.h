// A smooth implicit surface through points with normals: a Hermite interpolant of radial functions
// (Wendland 2005, chapter 16; Macêdo, Gois and Velho 2011).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "base/grid.h"
#include "base/types.h"

namespace artisketch {

// A point where a surface touches a line of sight.
struct SurfacePoint {
  Vec3 position;
  Vec3 normal;        // unit, outward
  Vec3 sight;         // unit, across the normal: the way along which the surface turns away
  double weight = 1;  // over 0: how much it counts beside the others
};

inline constexpr int kFewestSurfacePoints = 2;  // fewer determine nothing beside a linear function

struct HermiteOptions {
  double length = 0;          // units that the ridges refer to, such as the part's half thickness;
                              // no less than an eighth of the points' extent counts
  double value_ridge = 5e-4;  // how loosely f = 0 holds at the points
  double slope_ridge = 60;    // how loosely ∇f is the normal; what turns it sideways within the
                              // outline is left to the neighbours
  double loose_weight = 0.1;  // of the points without a slope, beside the others
};

// f(x) = Σ aᵢ r³ − 3 r bᵢ·(x − cᵢ) + linear, the smoothest (least ∫|∇³f|²) with f(cᵢ) ≈ 0 and,
// loosely, ∂f(cᵢ)/∂nᵢ ≈ 1, ∂f(cᵢ)/∂sᵢ ≈ 0; negative inside. Slopes that were held firmly at depths
// which are only guesses would bulge the surface until the guesses are right.
class HermiteSurface {
 public:
  // Solves for 3 #P + #loose unknowns, dense. Points at the same place are fine.
  //   loose  points without a slope
  HermiteSurface(std::span<const SurfacePoint> points, const HermiteOptions& options,
                 std::span<const Vec3> loose = {});

  float value(const Vec3& p) const;
  // values[i] = f(start + i · step), i = 0 … n − 1.
  void values(const Vec3& start, const Vec3& step, int n, float* values) const;

 private:
  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1;                               // units of one of the unknowns' lengths
  Eigen::Matrix<float, 7, Eigen::Dynamic> terms_;  // centre, a, b of each point, in that scale
  Eigen::Vector4d linear_;                         // 1, x, y, z
};

// values[i] = f(start + i · step), i = 0 … n − 1, of some smooth f.
using Rows = std::function<void(const Vec3& start, const Vec3& step, int n, float* values)>;

// field = max(field, f over its gradient's length) wherever the field is below `above`, in units:
// to first order the distance to the part of f's inside that the field leaves.
void raise(const Rows& f, double above, Grid3<float>& field);

}  // namespace artisketch

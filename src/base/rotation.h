// Rotations that Eigen makes at a higher price.
#pragma once

#include "base/types.h"

namespace artisketch {

// The least rotation that turns `from` into the direction of `to`; about any axis across where they
// are opposite. Neither may be zero. As Quat::FromTwoVectors, without its singular value
// decomposition.
inline Quat least_turn(const Vec3& from, const Vec3& to) {
  const Vec3 a = from.normalized(), b = to.normalized();
  // The quaternion of half the angle is the half-way vector between the whole turn's and none.
  Quat turn;
  turn.w() = 1 + a.dot(b);
  turn.vec() = a.cross(b);
  constexpr double kOpposite = 1e-14;  // of the squared norm
  if (turn.squaredNorm() < kOpposite) return Quat(Eigen::AngleAxisd(kPi, a.unitOrthogonal()));
  return turn.normalized();
}

// About one of the world's axes, by degrees.
inline Quat about_x(double angle) {
  return Quat(Eigen::AngleAxisd(radians(angle), Vec3::UnitX()));
}
inline Quat about_y(double angle) {
  return Quat(Eigen::AngleAxisd(radians(angle), Vec3::UnitY()));
}
inline Quat about_z(double angle) {
  return Quat(Eigen::AngleAxisd(radians(angle), Vec3::UnitZ()));
}

}  // namespace artisketch

// The numeric types that every floor shares.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace artisketch {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;
using Transform = Eigen::Isometry3d;  // rigid motion
using Index3 = Eigen::Vector3i;
using Box2 = Eigen::AlignedBox2d;
using Box3 = Eigen::AlignedBox3d;

using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  // #P×3
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;   // #F×3

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double radians(double degrees) {
  return degrees * kPi / 180;
}
inline constexpr double degrees(double radians) {
  return radians * 180 / kPi;
}

}  // namespace artisketch

#include "model/calibrate/euler_solver.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace artisketch {
namespace {

// Rotations further than this from the user's pose would pass the singularity of the Euler angles
// at β = ±90°; nobody poses that badly.
const double kMostRotation = radians(85);

Quat from_euler(const Vec3& e) {
  return Eigen::AngleAxisd(e.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(e.y(), Vec3::UnitY()) *
         Eigen::AngleAxisd(e.x(), Vec3::UnitX());
}

Vec3 to_euler(const Quat& q) {
  const Mat3 R = q.toRotationMatrix();
  return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)),
          std::atan2(R(1, 0), R(0, 0))};
}

// The unknowns: root translation against the user's, then three angles per free joint.
struct Unknowns {
  const Skeleton& skeleton;
  const Pose& user;
  std::vector<int> slot;  // per joint: first of its three columns, or −1
  int size = 3;

  Unknowns(const Skeleton& skeleton, const Pose& user, const std::vector<char>& free)
      : skeleton(skeleton), user(user), slot(skeleton.size(), -1) {
    for (int j = 0; j < skeleton.size(); ++j)
      if (free[j]) {
        slot[j] = size;
        size += 3;
      }
  }
  Pose pose(const Eigen::VectorXd& x) const {
    Pose p = user;
    p.root_position += x.head<3>();
    for (int j = 0; j < skeleton.size(); ++j)
      if (slot[j] >= 0) p.rotations[j] = user.rotations[j] * from_euler(x.segment<3>(slot[j]));
    return p;
  }
  Eigen::VectorXd values(const Pose& p) const {
    Eigen::VectorXd x(size);
    x.head<3>() = p.root_position - user.root_position;
    for (int j = 0; j < skeleton.size(); ++j)
      if (slot[j] >= 0)
        x.segment<3>(slot[j]) = to_euler(user.rotations[j].conjugate() * p.rotations[j]);
    return x;
  }
};

// Normal equations JᵀJ, its lower half alone, and Jᵀr of Σ weight |posed(rest) − world|², and
// that sum.
struct Normal {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  double energy = 0;
};

Normal normal_equations(const Unknowns& u, const Eigen::VectorXd& x,
                        const std::vector<PointPair>& pairs) {
  const Pose pose = u.pose(x);
  const std::vector<Transform> posed = posed_joints(u.skeleton, pose);
  const std::vector<Transform> skinning = skinning_transforms(u.skeleton, pose);
  // The world axis of each Euler angle: those of Rz(γ) Ry(β) Rx(α) in turn.
  std::vector<Mat3> axes(u.skeleton.size());
  for (int j = 0; j < u.skeleton.size(); ++j) {
    if (u.slot[j] < 0) continue;
    const int parent = u.skeleton.joints[j].parent;
    const Mat3 before = (parent < 0 ? Mat3(Mat3::Identity()) : Mat3(posed[parent].linear())) *
                        u.user.rotations[j].toRotationMatrix();
    const Vec3 e = x.segment<3>(u.slot[j]);
    const Mat3 Rz = Eigen::AngleAxisd(e.z(), Vec3::UnitZ()).toRotationMatrix();
    const Mat3 Ry = Eigen::AngleAxisd(e.y(), Vec3::UnitY()).toRotationMatrix();
    axes[j].col(2) = before.col(2);
    axes[j].col(1) = before * Rz.col(1);
    axes[j].col(0) = before * Rz * Ry.col(0);
  }
  Normal n{Eigen::MatrixXd::Zero(u.size, u.size), Eigen::VectorXd::Zero(u.size), 0};
  Eigen::Matrix<double, 3, Eigen::Dynamic> J(3, u.size);
  std::vector<int> columns;
  for (const PointPair& pair : pairs) {
    const Vec3 X = skinning[pair.joint] * pair.rest;
    const Vec3 r = X - pair.world;
    columns.assign({0});
    J.leftCols<3>().setIdentity();
    for (int k = pair.joint; k >= 0; k = u.skeleton.joints[k].parent)
      if (u.slot[k] >= 0) {
        for (int a = 0; a < 3; ++a)
          J.col(u.slot[k] + a) = axes[k].col(a).cross(X - posed[k].translation());
        columns.push_back(u.slot[k]);
      }
    for (const int a : columns) {
      n.b.segment<3>(a) += pair.weight * J.middleCols<3>(a).transpose() * r;
      const Mat3 weighted = pair.weight * J.middleCols<3>(a).transpose();
      for (const int c : columns)
        if (c <= a) n.A.block<3, 3>(a, c) += weighted.lazyProduct(J.middleCols<3>(c));
    }
    n.energy += pair.weight * r.squaredNorm();
  }
  return n;
}

}  // namespace

Pose within_limits(const Pose& user, Pose pose, const EulerLimits& limits) {
  const Vec3 moved = pose.root_position - user.root_position;
  if (moved.norm() > limits.max_translation)
    pose.root_position = user.root_position + moved * (limits.max_translation / moved.norm());
  for (std::size_t j = 0; j < pose.rotations.size(); ++j) {
    if (!limits.free[j]) {
      pose.rotations[j] = user.rotations[j];
      continue;
    }
    Eigen::AngleAxisd turn(user.rotations[j].conjugate() * pose.rotations[j]);
    if (turn.angle() > limits.max_rotation) {
      turn.angle() = limits.max_rotation;
      pose.rotations[j] = user.rotations[j] * Quat(turn);
    }
    pose.rotations[j].normalize();
  }
  return pose;
}

Pose solve_pose(const Skeleton& skeleton, const Pose& user, const Pose& start,
                const std::vector<PointPair>& pairs, const EulerLimits& limits) {
  const Unknowns u(skeleton, user, limits.free);
  Eigen::VectorXd x = u.values(start);
  const double most_turn = std::min(limits.max_rotation, kMostRotation);
  // Constraints c ≤ 0, each of the squared length of three unknowns: (|x|² / most² − 1) / 2.
  std::vector<std::pair<int, double>> bounds = {{0, limits.max_translation}};
  for (int j = 0; j < skeleton.size(); ++j)
    if (u.slot[j] >= 0) bounds.emplace_back(u.slot[j], most_turn);
  Eigen::VectorXd multiplier = Eigen::VectorXd::Zero(bounds.size());
  double weight = 0;
  for (const PointPair& pair : pairs) weight += pair.weight;
  // The penalty's scale: a bound overrun by a tenth costs about what the pairs do.
  double penalty = 0;
  for (int outer = 0; outer < 4; ++outer) {
    for (int step = 0; step < 3; ++step) {
      Normal n = normal_equations(u, x, pairs);
      if (penalty == 0) penalty = std::max(n.energy, 1e-9 * weight);
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        const auto [at, most] = bounds[i];
        if (most <= 0) {  // nothing may move at all
          n.A.block(at, 0, 3, u.size).setZero();
          n.A.block(0, at, u.size, 3).setZero();
          n.A.block<3, 3>(at, at).setIdentity();
          n.b.segment<3>(at) = x.segment<3>(at);
          continue;
        }
        const Vec3 g = x.segment<3>(at) / (most * most);
        const double c = (x.segment<3>(at).squaredNorm() / (most * most) - 1) / 2;
        const double push = std::max(0.0, multiplier[i] + penalty * c);
        if (push == 0) continue;
        n.b.segment<3>(at) += push * g;
        n.A.block<3, 3>(at, at) +=
            penalty * g * g.transpose() + push / (most * most) * Mat3::Identity();
      }
      // Marquardt's damping; the floor keeps angles that the pairs leave open (twist) where they
      // are.
      const double floor = 1e-5 * std::max(n.A.diagonal().maxCoeff(), 1e-12);
      n.A.diagonal() += 1e-3 * n.A.diagonal() + Eigen::VectorXd::Constant(u.size, floor);
      const Eigen::VectorXd change = n.A.ldlt().solve(n.b);
      if (!change.allFinite()) break;
      x -= change;
    }
    bool inside = true;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const auto [at, most] = bounds[i];
      if (most <= 0) continue;
      const double c = (x.segment<3>(at).squaredNorm() / (most * most) - 1) / 2;
      multiplier[i] = std::max(0.0, multiplier[i] + penalty * c);
      inside &= c < 1e-3;
    }
    if (inside) break;
    penalty *= 4;
  }
  // The augmented Lagrangian nears the limits; the last step puts the pose within them exactly.
  return within_limits(user, u.pose(x), limits);
}

}  // namespace artisketch

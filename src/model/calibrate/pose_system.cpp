#include "model/calibrate/pose_system.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "base/trigonometry.h"

namespace artisketch {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// exp(v + d) ≈ exp(J d) exp(v): the left Jacobian of the rotation vector.
Mat3 left_jacobian(const Vec3& v) {
  const double angle = v.norm();
  const Mat3 K = cross_matrix(v);
  if (angle < 1e-4) return Mat3::Identity() + K / 2 + K * K / 6;
  return Mat3::Identity() + K * ((1 - cosine(angle)) / (angle * angle)) +
         K * K * ((angle - sine(angle)) / (angle * angle * angle));
}

// Just inside, so that rounding on the way to a quaternion and back stays within the limit.
constexpr double kJustInside = 1 - 1e-9;
constexpr double kAtLimit = 1 - 1e-6;  // of a limit: it is reached
constexpr double kStiff = 1e6;         // of a spring that stands for a limit, against all others

Vec3 clamped(const Vec3& v, double bound) {
  const double length = v.norm();
  return length > bound * kJustInside ? Vec3(v * (bound * kJustInside / length)) : v;
}

}  // namespace

Quat rotation_by(const Vec3& v) {
  const double angle = v.norm();
  if (angle == 0) return Quat::Identity();
  const Vec3 axis = v / angle * sine(angle / 2);
  return {cosine(angle / 2), axis.x(), axis.y(), axis.z()};
}

PoseChange no_change(const Document& document) {
  FrameChange none;
  none.rotation.assign(document.skeleton.size(), Vec3::Zero());
  return PoseChange(document.frames.size(), none);
}

Pose changed(const Pose& pose, const FrameChange& change) {
  Pose moved = pose;
  for (std::size_t j = 0; j < moved.rotations.size(); ++j)
    if (!change.rotation[j].isZero(0))
      moved.rotations[j] = (pose.rotations[j] * rotation_by(change.rotation[j])).normalized();
  moved.root_position += change.translation;
  return moved;
}

double prior_energy(const PoseChange& change, const PosePrior& prior) {
  double turns = 0, shifts = 0, depths = 0, scales = 0;
  for (std::size_t f = 0; f < change.size(); ++f) {
    const FrameChange& frame = change[f];
    const double share = prior.share(int(f)), per = 1 / (share * share);
    for (const Vec3& turn : frame.rotation) turns += per * turn.squaredNorm();
    shifts += per * frame.translation.head<2>().squaredNorm();
    depths += per * frame.translation.z() * frame.translation.z();
    scales += per * frame.log_scale * frame.log_scale;
  }
  return turns / (prior.rotation * prior.rotation) +
         shifts / (prior.translation * prior.translation) + depths / (prior.depth * prior.depth) +
         scales / (prior.log_scale * prior.log_scale);
}

PoseSystem::PoseSystem(const Document& document, PoseFreedom freedom)
    : document_(document), freedom_(std::move(freedom)), node_of_(document.skeleton.size(), -1) {
  const Skeleton& skeleton = document.skeleton;
  for (int f = 0; f < int(document.frames.size()); ++f) {
    const std::vector<char>& turns = freedom_.joint[f];
    if (freedom_.frame[f] || std::count(turns.begin(), turns.end(), 1) > 0) moving_.push_back(f);
  }
  for (int j = 0; j < skeleton.size(); ++j) {
    const bool ever = std::any_of(moving_.begin(), moving_.end(), [&](int f) {
      return freedom_.joint[f][j] || (j == 0 && freedom_.frame[f]);
    });
    if (!ever) continue;
    Node node;
    node.joint = j;
    node.width = j == 0 ? kMotion : 3;
    node_of_[j] = int(nodes_.size());
    for (int a = j; a >= 0; a = skeleton.joints[a].parent)
      if (node_of_[a] >= 0) node.chain.push_back(node_of_[a]);
    nodes_.push_back(std::move(node));
  }
}

void PoseSystem::assemble(const PoseChange& change, const MotionSystems& parts) {
  const Skeleton& skeleton = document_.skeleton;
  const int frames = int(document_.frames.size()), moving = int(moving_.size());
  // What each joint's motion does to all that hangs on it, one system per joint.
  below_.resize(skeleton.size());
  for (MotionSystem& system : below_) system.clear(frames);
  for (const auto& [joint, system] : parts) {
    below_[joint].H += system.H;
    below_[joint].g += system.g;
  }
  for (int j = skeleton.size() - 1; j > 0; --j) {
    below_[skeleton.joints[j].parent].H += below_[j].H;
    below_[skeleton.joints[j].parent].g += below_[j].g;
  }
  std::vector<std::vector<Transform>> posed;
  for (int f = 0; f < frames; ++f)
    posed.push_back(posed_joints(skeleton, changed(document_.frames[f].pose, change[f])));
  std::vector<std::vector<Directions>> S;
  for (const Node& node : nodes_) S.push_back(directions(node, change, posed));

  MatrixXd HS;  // a subtree's system in its node's unknowns on one side
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    const MotionSystem& system = below_[node.joint];
    HS.resize(kMotion * frames, node.width * moving);
    node.gradient.resize(node.width * moving);
    for (int m = 0; m < moving; ++m) {
      const int at = kMotion * moving_[m];
      HS.middleCols(node.width * m, node.width).noalias() =
          system.H.middleCols<kMotion>(at) * S[n][m];
      node.gradient.segment(node.width * m, node.width) =
          S[n][m].transpose() * system.g.segment<kMotion>(at);
    }
    node.blocks.resize(node.chain.size());
    for (std::size_t i = 0; i < node.chain.size(); ++i) {
      const Node& other = nodes_[node.chain[i]];
      node.blocks[i].resize(node.width * moving, other.width * moving);
      for (int m = 0; m < moving; ++m)
        node.blocks[i].middleCols(other.width * m, other.width).noalias() =
            HS.middleRows<kMotion>(kMotion * moving_[m]).transpose() * S[node.chain[i]][m];
    }
  }
}

std::vector<PoseSystem::Directions> PoseSystem::directions(
    const Node& node, const PoseChange& change,
    const std::vector<std::vector<Transform>>& posed) const {
  const int parent = document_.skeleton.joints[node.joint].parent;
  std::vector<Directions> result;
  for (const int f : moving_) {
    Directions S = Directions::Zero(kMotion, node.width);
    if (freedom_.joint[f][node.joint]) {
      const Mat3 user = document_.frames[f].pose.rotations[node.joint].toRotationMatrix();
      const Mat3 turn = (parent < 0 ? Mat3(user) : Mat3(posed[f][parent].linear() * user)) *
                        left_jacobian(change[f].rotation[node.joint]);
      S.topLeftCorner<3, 3>() = turn;
      S.block<3, 3>(3, 0) = cross_matrix(posed[f][node.joint].translation()) * turn;
    }
    if (node.joint == 0 && freedom_.frame[f]) {
      S.block<3, 3>(3, 3).setIdentity();
      if (freedom_.scale) S(6, 6) = 1;
    }
    result.push_back(std::move(S));
  }
  return result;
}

// A stiff spring along what would only press against a limit that is reached.
void PoseSystem::hold_at_limits(const Node& node, const PoseChange& change, const VectorXd& pull,
                                MatrixXd& diagonal) const {
  const auto hold = [&](int at, const Vec3& v, double limit) {
    if (v.norm() < limit * kAtLimit || pull.segment<3>(at).dot(v) <= 0 || v.isZero(0)) return;
    const Vec3 outward = v.normalized();
    diagonal.block<3, 3>(at, at) +=
        kStiff * diagonal.block<3, 3>(at, at).trace() * outward * outward.transpose();
  };
  for (int m = 0; m < int(moving_.size()); ++m) {
    const FrameChange& frame = change[moving_[m]];
    hold(node.width * m, frame.rotation[node.joint], freedom_.max_rotation);
    if (node.joint == 0) hold(node.width * m + 3, frame.translation, freedom_.max_translation);
  }
}

PoseChange PoseSystem::stepped(const PoseChange& change, const PosePrior& prior, double damping) {
  const int n = int(nodes_.size()), moving = int(moving_.size());
  std::vector<std::vector<MatrixXd>>& A = factor_;
  A.resize(n);
  std::vector<VectorXd> x(n);
  for (int k = 0; k < n; ++k) {
    const Node& node = nodes_[k];
    A[k] = node.blocks;
    x[k] = -node.gradient;
    const auto pull = [&, k](int i, double value, double width) {
      A[k][0](i, i) += 1 / (width * width);
      x[k][i] -= value / (width * width);
    };
    for (int m = 0; m < moving; ++m) {
      const int at = node.width * m;
      const FrameChange& frame = change[moving_[m]];
      const double share = prior.share(moving_[m]);
      for (int i = 0; i < 3; ++i)
        pull(at + i, frame.rotation[node.joint][i], share * prior.rotation);
      if (node.joint != 0) continue;
      for (int i = 0; i < 3; ++i)
        pull(at + 3 + i, frame.translation[i], share * (i < 2 ? prior.translation : prior.depth));
      pull(at + 6, frame.log_scale, share * prior.log_scale);
    }
    A[k][0].diagonal() *= 1 + damping;
    hold_at_limits(node, change, x[k], A[k][0]);
  }
  // Leaves first: each node is eliminated from its ancestors, which its chain couples already. The
  // lower triangle of A[k][0] becomes its Cholesky factor.
  for (int k = n - 1; k >= 0; --k) {
    const std::vector<int>& chain = nodes_[k].chain;
    Eigen::LLT<Eigen::Ref<MatrixXd>> in_place(A[k][0]);
    const auto L = A[k][0].triangularView<Eigen::Lower>();
    L.solveInPlace(x[k]);
    for (std::size_t i = 1; i < chain.size(); ++i) L.solveInPlace(A[k][i]);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      x[chain[i]].noalias() -= A[k][i].transpose() * x[k];
      for (std::size_t j = i; j < chain.size(); ++j)
        A[chain[i]][j - i].noalias() -= A[k][i].transpose() * A[k][j];
    }
  }
  for (int k = 0; k < n; ++k) {
    const std::vector<int>& chain = nodes_[k].chain;
    for (std::size_t i = 1; i < chain.size(); ++i) x[k].noalias() -= A[k][i] * x[chain[i]];
    A[k][0].triangularView<Eigen::Lower>().transpose().solveInPlace(x[k]);
  }
  PoseChange result = change;
  for (int k = 0; k < n; ++k) {
    const Node& node = nodes_[k];
    for (int m = 0; m < moving; ++m) {
      const int at = node.width * m, f = moving_[m];
      Vec3& turn = result[f].rotation[node.joint];
      if (freedom_.joint[f][node.joint])
        turn = clamped(turn + x[k].segment<3>(at), freedom_.max_rotation);
      if (node.joint != 0 || !freedom_.frame[f]) continue;
      result[f].translation =
          clamped(result[f].translation + x[k].segment<3>(at + 3), freedom_.max_translation);
      if (freedom_.scale) result[f].log_scale += x[k][at + 6];
    }
  }
  return result;
}

double PoseSystem::expected_energy(const PosePrior& prior) const {
  double sum = 0;
  for (const Node& node : nodes_)
    for (int m = 0; m < int(moving_.size()); ++m) {
      const auto diagonal = node.blocks[0].diagonal().segment(node.width * m, node.width);
      sum += diagonal.head<3>().sum() * prior.rotation * prior.rotation;
      if (node.joint != 0) continue;
      sum += diagonal.segment<2>(3).sum() * prior.translation * prior.translation;
      sum += diagonal[5] * prior.depth * prior.depth;
      sum += diagonal[6] * prior.log_scale * prior.log_scale;
    }
  return sum;
}

}  // namespace artisketch

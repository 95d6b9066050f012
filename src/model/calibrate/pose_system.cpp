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
    const int parent = skeleton.joints[j].parent;
    if (parent >= 0) node_of_[j] = node_of_[parent];
    const bool ever = std::any_of(moving_.begin(), moving_.end(), [&](int f) {
      return freedom_.joint[f][j] || (j == 0 && freedom_.frame[f]);
    });
    if (!ever) continue;
    Node node;
    node.joint = j;
    node.parent = node_of_[j];
    node.width = j == 0 ? kMotion : 3;
    node_of_[j] = int(nodes_.size());
    nodes_.push_back(std::move(node));
  }
  eliminated_.resize(nodes_.size());
}

void PoseSystem::assemble(const PoseChange& change, const MotionSystems& parts) {
  const Skeleton& skeleton = document_.skeleton;
  const int moving = int(moving_.size());
  for (Node& node : nodes_) node.own.clear(moving);
  for (const auto& [joint, system] : parts) {
    if (node_of_[joint] < 0) continue;
    MotionSystem& own = nodes_[node_of_[joint]].own;
    for (int m = 0; m < moving; ++m) {
      own.g.segment<kMotion>(kMotion * m) += system.g.segment<kMotion>(kMotion * moving_[m]);
      for (int n = 0; n < moving; ++n)
        own.H.block<kMotion, kMotion>(kMotion * m, kMotion * n) +=
            system.H.block<kMotion, kMotion>(kMotion * moving_[m], kMotion * moving_[n]);
    }
  }
  std::vector<std::vector<Transform>> posed;
  for (std::size_t f = 0; f < document_.frames.size(); ++f)
    posed.push_back(posed_joints(skeleton, changed(document_.frames[f].pose, change[f])));
  for (Node& node : nodes_) node.S = directions(node, change, posed);
  sum_up();
}

void PoseSystem::sum_up() {
  const int moving = int(moving_.size());
  using Block = Eigen::Matrix<double, kMotion, kMotion>;
  std::vector<std::vector<Block>> H(nodes_.size());  // of each frame with itself
  std::vector<VectorXd> g;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    for (int m = 0; m < moving; ++m)
      H[n].push_back(nodes_[n].own.H.block<kMotion, kMotion>(kMotion * m, kMotion * m));
    g.push_back(nodes_[n].own.g);
  }
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    node.gradient.resize(node.width * moving);
    node.diagonal.resize(node.width * moving);
    for (int m = 0; m < moving; ++m) {
      const Directions& S = node.S[m];
      node.gradient.segment(node.width * m, node.width) =
          S.transpose() * g[n].segment<kMotion>(kMotion * m);
      node.diagonal.segment(node.width * m, node.width) = (S.transpose() * H[n][m] * S).diagonal();
      if (node.parent >= 0) H[node.parent][m] += H[n][m];
    }
    if (node.parent >= 0) g[node.parent] += g[n];
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

// A stiff spring along what would only press against a limit that is reached. diagonal: of the
// system, damped.
void PoseSystem::hold_at_limits(const Node& node, const PoseChange& change, const VectorXd& pull,
                                VectorXd diagonal, MatrixXd& D) const {
  const auto hold = [&](int at, const Vec3& v, double limit) {
    if (v.norm() < limit * kAtLimit || pull.segment<3>(at).dot(v) <= 0 || v.isZero(0)) return;
    const Vec3 outward = v.normalized();
    D.block<3, 3>(at, at) += kStiff * diagonal.segment<3>(at).sum() * outward * outward.transpose();
  };
  for (int m = 0; m < int(moving_.size()); ++m) {
    const FrameChange& frame = change[moving_[m]];
    hold(node.width * m, frame.rotation[node.joint], freedom_.max_rotation);
    if (node.joint == 0) hold(node.width * m + 3, frame.translation, freedom_.max_translation);
  }
}

void PoseSystem::pull_and_damp(const Node& node, const PoseChange& change, const PosePrior& prior,
                               double damping, MatrixXd& D, VectorXd& d) const {
  const Eigen::Index unknowns = node.diagonal.size();
  D.setZero(unknowns, unknowns);
  d.setZero(unknowns);
  const auto pull = [&](int i, double value, double width) {
    D(i, i) += 1 / (width * width);
    d[i] += value / (width * width);
  };
  for (int m = 0; m < int(moving_.size()); ++m) {
    const int at = node.width * m;
    const FrameChange& frame = change[moving_[m]];
    const double share = prior.share(moving_[m]);
    for (int i = 0; i < 3; ++i) pull(at + i, frame.rotation[node.joint][i], share * prior.rotation);
    if (node.joint != 0) continue;
    for (int i = 0; i < 3; ++i)
      pull(at + 3 + i, frame.translation[i], share * (i < 2 ? prior.translation : prior.depth));
    pull(at + 6, frame.log_scale, share * prior.log_scale);
  }
  const VectorXd whole = (node.diagonal + D.diagonal()) * (1 + damping);
  D.diagonal() = whole - node.diagonal;
  hold_at_limits(node, change, -(node.gradient + d), whole, D);
}

// Leaves node k's parent a system in its own motion.
void PoseSystem::eliminate(int k, const MatrixXd& D, const VectorXd& d) {
  const Node& node = nodes_[k];
  Eliminated& here = eliminated_[k];
  const auto& [H, g] = here.system;
  const int moving = int(moving_.size()), width = node.width;
  here.Y.resize(width * moving, kMotion * moving);
  here.L = D;
  here.z = d;
  for (int m = 0; m < moving; ++m) {
    here.Y.middleRows(width * m, width).noalias() =
        node.S[m].transpose() * H.middleRows<kMotion>(kMotion * m);
    here.z.segment(width * m, width) += node.S[m].transpose() * g.segment<kMotion>(kMotion * m);
  }
  for (int m = 0; m < moving; ++m)
    here.L.middleCols(width * m, width).noalias() +=
        here.Y.middleCols<kMotion>(kMotion * m) * node.S[m];
  Eigen::LLT<Eigen::Ref<MatrixXd>> in_place(here.L);
  const auto L = here.L.triangularView<Eigen::Lower>();
  L.solveInPlace(here.Y);
  L.solveInPlace(here.z);
  if (node.parent < 0) return;
  MotionSystem& above = eliminated_[node.parent].system;
  above.H += H;
  above.H.noalias() -= here.Y.transpose() * here.Y;
  above.g += g;
  above.g.noalias() -= here.Y.transpose() * here.z;
}

PoseChange PoseSystem::stepped(const PoseChange& change, const PosePrior& prior, double damping) {
  const int moving = int(moving_.size());
  MatrixXd D;
  VectorXd d;
  for (std::size_t k = 0; k < nodes_.size(); ++k) eliminated_[k].system = nodes_[k].own;
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    pull_and_damp(nodes_[k], change, prior, damping, D, d);
    eliminate(int(k), D, d);
  }
  PoseChange result = change;
  std::vector<VectorXd> motions;  // per node, of all that hangs on it
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    const Eliminated& here = eliminated_[k];
    VectorXd motion = node.parent < 0 ? VectorXd::Zero(kMotion * moving) : motions[node.parent];
    VectorXd x = -here.z;
    x.noalias() -= here.Y * motion;
    here.L.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
    for (int m = 0; m < moving; ++m)
      motion.segment<kMotion>(kMotion * m) += node.S[m] * x.segment(node.width * m, node.width);
    motions.push_back(std::move(motion));
    move(node, x, result);
  }
  return result;
}

void PoseSystem::move(const Node& node, const VectorXd& x, PoseChange& result) const {
  for (int m = 0; m < int(moving_.size()); ++m) {
    const int at = node.width * m, f = moving_[m];
    Vec3& turn = result[f].rotation[node.joint];
    if (freedom_.joint[f][node.joint])
      turn = clamped(turn + x.segment<3>(at), freedom_.max_rotation);
    if (node.joint != 0 || !freedom_.frame[f]) continue;
    result[f].translation =
        clamped(result[f].translation + x.segment<3>(at + 3), freedom_.max_translation);
    if (freedom_.scale) result[f].log_scale += x[at + 6];
  }
}

double PoseSystem::expected_energy(const PosePrior& prior) const {
  double sum = 0;
  for (const Node& node : nodes_)
    for (int m = 0; m < int(moving_.size()); ++m) {
      const auto diagonal = node.diagonal.segment(node.width * m, node.width);
      sum += diagonal.head<3>().sum() * prior.rotation * prior.rotation;
      if (node.joint != 0) continue;
      sum += diagonal.segment<2>(3).sum() * prior.translation * prior.translation;
      sum += diagonal[5] * prior.depth * prior.depth;
      sum += diagonal[6] * prior.log_scale * prior.log_scale;
    }
  return sum;
}

}  // namespace artisketch

// The unknowns of calibration: small motions of every joint in every frame, and what they do to the
// parts.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "model/calibrate.h"

namespace artisketch {

// How far one frame's pose stands from the user's.
struct FrameChange {
  std::vector<Vec3> rotation;  // per joint: the user's rotation, then this rotation vector
  Vec3 translation = Vec3::Zero();
  double log_scale = 0;
};
using PoseChange = std::vector<FrameChange>;  // one per frame

PoseChange no_change(const Document& document);
Pose changed(const Pose& pose, const FrameChange& change);  // unmoved joints keep their bits

// A motion of a part in one frame, in world axes at the world's origin: x' = x + ω × x + u, and the
// frame's scale grows by the factor 1 + s. Order: ω, u, s.
inline constexpr int kMotion = 7;
using Motion = Eigen::Matrix<double, kMotion, 1>;

// Least squares in the motions of one part: energy ≈ e + 2 gᵀm + mᵀHm, with kMotion entries of m per
// frame.
struct MotionSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  explicit MotionSystem(int frames = 0)
      : H(Eigen::MatrixXd::Zero(kMotion * frames, kMotion * frames)),
        g(Eigen::VectorXd::Zero(kMotion * frames)) {}
};

// Widths of the prior that pulls to the user's poses.
struct PosePrior {
  std::vector<double> rotation;  // radians, per joint
  double translation = 1;        // units
  double log_scale = 0.1;
};

// Collects the parts' systems down the skeleton into one in the pose's unknowns (the composite
// bodies of Featherstone 2008, section 6), and solves it by a block Cholesky factorisation from the
// leaves to the root, which fills in nothing: joints are coupled with their ancestors only.
class PoseSystem {
 public:
  // free[f][j]: joint j may turn in frame f. The root moves and scales where it's free at all.
  PoseSystem(const Document& document, const PoseBounds& bounds, const PosePrior& prior,
             std::vector<std::vector<bool>> free, bool scale);

  double prior_energy(const PoseChange& change) const;

  // parts: (joint, its system), at the change given.
  void assemble(const PoseChange& change, std::span<const std::pair<int, MotionSystem>> parts);
  // The step of Levenberg and Marquardt with damping μ (relative to the diagonal), kept within the
  // bounds. Directions against a bound that is reached are left out.
  PoseChange stepped(const PoseChange& change, double damping) const;

  double trace_rotation() const;
  void set_prior(const PosePrior& prior) { prior_ = prior; }
  double trace_translation() const;
  // Diagonal 3×3 block of joint j's rotation in frame f, without the prior.
  Mat3 rotation_information(int joint, int frame) const;

  const std::vector<std::vector<bool>>& free() const { return free_; }

 private:
  struct Node {
    int joint = 0;
    int width = 3;                  // unknowns per frame
    std::vector<int> chain;         // nodes from this one up to the root, this one first
    std::vector<Eigen::MatrixXd> blocks;  // with each node of the chain
    Eigen::VectorXd gradient;
  };
  // Per frame: the motion of all below a node that each of its unknowns makes, 7 × width.
  using Directions = Eigen::Matrix<double, kMotion, Eigen::Dynamic, 0, kMotion, kMotion>;
  std::vector<Directions> directions(const Node& node, const PoseChange& change,
                                     const std::vector<std::vector<Transform>>& posed) const;

  const Document& document_;
  PoseBounds bounds_;
  PosePrior prior_;
  std::vector<std::vector<bool>> free_;
  bool scale_ = false;
  int frames_ = 0;
  std::vector<Node> nodes_;       // parents before children
  std::vector<int> node_of_;      // per joint, −1: never free
};

}  // namespace artisketch

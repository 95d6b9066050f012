// The unknowns of calibration: small motions of every joint in every frame, and what they do to the
// parts.
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "document/document.h"

namespace artisketch {

// How far one frame's pose stands from the user's.
struct FrameChange {
  std::vector<Vec3> rotation;  // per joint: the user's rotation, then this rotation vector
  Vec3 translation = Vec3::Zero();
  double log_scale = 0;
};
using PoseChange = std::vector<FrameChange>;  // one per frame

Quat rotation_by(const Vec3& v);  // about v, by its length in radians

PoseChange no_change(const Document& document);
Pose changed(const Pose& pose, const FrameChange& change);  // unturned joints keep their bits

// A motion of a part in one frame, in world axes at the world's origin: x' = x + ω × x + u, and the
// frame's scale grows by the factor 1 + s. Order: ω, u, s.
inline constexpr int kMotion = 7;
using PartMotion = Eigen::Matrix<double, kMotion, 1>;

// Least squares in the motions of one part: energy ≈ e + 2 gᵀm + mᵀHm, with kMotion entries of m
// per frame.
struct MotionSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  explicit MotionSystem(int frames = 0) { clear(frames); }
  void clear(int frames) {  // keeps its memory where the frames are as many as before
    H.setZero(kMotion * frames, kMotion * frames);
    g.setZero(kMotion * frames);
  }
};
using MotionSystems = std::vector<std::pair<int, MotionSystem>>;  // joints and their systems

// How far users' poses are off, as standard deviations per axis: the prior that pulls to them.
struct PosePrior {
  double rotation = radians(5);  // radians, of each joint in its parent's axes
  double translation = 1;        // units, of the root, across the real camera's axis
  double depth = 1;              // units, of the root, along it
  double log_scale = 0.1;
  double first = 1;  // the share of these widths that the first frame gets, > 0
  double share(int frame) const { return frame == 0 ? first : 1; }
};

// Which unknowns there are.
struct PoseFreedom {
  double max_rotation = 0;               // radians
  double max_translation = 0;            // units
  std::vector<char> frame;               // the frame's root may move
  std::vector<std::vector<char>> joint;  // [frame][joint]: the joint may turn
  bool scale = false;                    // frames that move find their scale, too
};

// The parts' systems as one in the pose's unknowns, solved in time linear in the joints, whatever
// tree they are: a joint's motion is its parent's and that of its own unknowns, so that these are
// eliminated from the leaves to the root, each leaving a system in its parent's motion alone
// (Featherstone 2008, chapter 7: articulated bodies).
class PoseSystem {
 public:
  PoseSystem(const Document& document, PoseFreedom freedom);

  void assemble(const PoseChange& change, const MotionSystems& parts);

  // A step of Levenberg and Marquardt with the prior, damped by `damping` times the diagonal, and
  // cut to the limits exactly. Pulls against a limit that is reached are left out of the system.
  PoseChange stepped(const PoseChange& change, const PosePrior& prior, double damping);

  // The energy that pose errors of one standard deviation would make, by the system assembled.
  double expected_energy(const PosePrior& prior) const;

  const PoseFreedom& freedom() const { return freedom_; }

 private:
  // Per frame that moves: the motion of all that hangs on a node for each of its unknowns, 7 ×
  // width.
  using Directions = Eigen::Matrix<double, kMotion, Eigen::Dynamic, 0, kMotion, kMotion>;
  // A joint that may move in some frame, with the joints on it that never do.
  struct Node {
    int joint = 0;
    int parent = -1;   // the node that it hangs on; −1: what stands still
    int width = 3;     // unknowns per frame that moves: a rotation; a motion of the root
    MotionSystem own;  // of its parts, in the frames that move
    std::vector<Directions> S;
    Eigen::VectorXd gradient;  // of the energy by its unknowns
    Eigen::VectorXd diagonal;  // of the system in all unknowns
  };
  // One elimination, kept from step to step for its memory. With LLᵀ = SᵀHS + D, D what a node's
  // unknowns add by themselves: Y = L⁻¹SᵀH and z = L⁻¹(Sᵀg + d), by which the node's unknowns
  // follow from its parent's motion.
  struct Eliminated {
    MotionSystem system;  // the node's and what its children leave of theirs
    Eigen::MatrixXd L, Y;
    Eigen::VectorXd z;
  };

  std::vector<Directions> directions(const Node& node, const PoseChange& change,
                                     const std::vector<std::vector<Transform>>& posed) const;
  void sum_up();  // gradients and diagonals, of all that hangs on each node
  // What a node's unknowns add by themselves: the prior, its damping, the limits.
  void pull_and_damp(const Node& node, const PoseChange& change, const PosePrior& prior,
                     double damping, Eigen::MatrixXd& D, Eigen::VectorXd& d) const;
  void hold_at_limits(const Node& node, const PoseChange& change, const Eigen::VectorXd& pull,
                      Eigen::VectorXd diagonal, Eigen::MatrixXd& D) const;
  void eliminate(int k, const Eigen::MatrixXd& D, const Eigen::VectorXd& d);
  void move(const Node& node, const Eigen::VectorXd& x, PoseChange& result) const;

  const Document& document_;
  PoseFreedom freedom_;
  std::vector<int> moving_;   // frames in which anything may move
  std::vector<Node> nodes_;   // parents before children
  std::vector<int> node_of_;  // per joint: the one that it moves with; −1: it stands still
  std::vector<Eliminated> eliminated_;
};

double prior_energy(const PoseChange& change, const PosePrior& prior);

}  // namespace artisketch

// Least energy over poses: the rays' misses, weighed by their noise, the landmarks and a prior that
// pulls to the user's poses, by Levenberg and Marquardt over all joints and frames at once.
#pragma once

#include "model/calibrate/landmark_residuals.h"
#include "model/calibrate/pose_system.h"
#include "model/calibrate/ray_residuals.h"

namespace artisketch {

// Landmarks that hold what silhouettes leave open: outlines' centroids are off their landmark's
// image by a tenth of the outline's size, landmarks off their bone by a twelfth of the part's
// radius (characters at their true poses).
inline constexpr LandmarkLoss kHoldingLandmarks{100, 150};

// What is minimised.
struct PoseEnergy {
  double noise = 1;  // divides the rays' energy, unit() squared; 0: no rays
  double reach = 0;  // of the rays' kernel, unit(); 0: plain squares
  LandmarkLoss landmarks = kHoldingLandmarks;
};

struct SolvedPoses {
  PoseChange change;
  double energy = 0;
};

class PoseSolver {
 public:
  // Keeps references to document, residuals and run.
  PoseSolver(const Document& document, const RayResiduals& residuals, PoseFreedom freedom,
             const PosePrior& prior, Run& run);

  std::vector<Pose> poses(const PoseChange& change) const;
  std::vector<double> scales(const PoseChange& change) const;
  Placement at(const PoseChange& change) const {
    return placed(document_, poses(change), scales(change));
  }

  double energy(const PoseChange& change, const PoseEnergy& what) const;
  // From `start` until two steps in turn gain less than a thousandth, at most `most` steps.
  SolvedPoses minimise(PoseChange start, const PoseEnergy& what, int most);
  int iterations() const { return iterations_; }

  // The prior as wide as the poses `user` seem to be off: the prior given, narrowed until pose
  // errors of its size would make as much of the rays' energy as there is (the method of moments).
  // Depth and scale stay as they are: they tell in the outlines' sizes only.
  void narrow_prior(const PoseChange& user);
  const PosePrior& prior() const { return prior_; }

 private:
  double evaluate(const PoseChange& change, const PoseEnergy& what, MotionSystems* systems) const;

  const Document& document_;
  const RayResiduals& residuals_;
  PoseSystem system_;
  PosePrior prior_;
  Run& run_;
  MotionSystems systems_;
  int iterations_ = 0;
};

}  // namespace artisketch

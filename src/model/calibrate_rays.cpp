// Calibration without voxels: how far contour rays miss the parts' hulls, by Levenberg–Marquardt
// over all joints and frames at once, with a prior that pulls to the user's poses.
//
// Silhouettes leave much open (the twist of a limb, the depth at which a part sits on its bone),
// and drawings disagree with themselves. So
// - the prior is as wide as the silhouettes say that the poses are off (their energy at the user's
//   poses against what errors of one degree would make): poses that are right already stay;
// - landmarks about the middles of bones say, weakly, what silhouettes leave open;
// - Geman–McClure kernels, narrowed step by step, let contours that contradict all others go;
// - of several starts the one that ends with least energy is taken.
#include <algorithm>
#include <cmath>

#include "model/calibrate.h"
#include "model/landmark_residuals.h"
#include "model/pose_system.h"
#include "model/ray_residuals.h"

namespace artisketch {
namespace {

constexpr double kRayStep = 3;             // units of the drawing between rays
constexpr int kMostRays = 32;              // of one contour
constexpr int kIterations = 30;            // of one stage, at most
constexpr double kSettled = 1e-3;          // an energy that falls by less ends a stage
constexpr double kWide = 12, kNarrow = 4;  // pixels: where the kernels let go
constexpr double kNoise = 10;  // pixels²: what the stages take a ray's error for at first
constexpr double kLeastNoise = 1.5, kMostNoise = 40;
constexpr double kNoisePerMean = 200;  // the noise that the mean robust error at the end speaks for
constexpr double kPriorShare = 0.27;  // of the limits: the prior's standard deviation at its widest
constexpr double kPriorScale = 0.05;  // standard deviation of a frame's log scale

// Landmarks that hold what silhouettes leave open, and those that lead a start.
constexpr LandmarkLoss kKeep{100, 150}, kLead{10, 0};

struct Stage {
  double noise = 1;  // of the rays
  double reach = 0;  // of the rays' kernel, units; 0: plain squares
  LandmarkLoss landmarks;
};

struct Solved {
  PoseChange change;
  double energy = 0;
};

class Solver {
 public:
  Solver(const Document& document, const RayResiduals& residuals, PoseFreedom freedom, Run& run)
      : document_(document),
        residuals_(residuals),
        system_(document, std::move(freedom)),
        run_(run) {}
  PosePrior prior;
  int iterations = 0;
  const PoseSystem& system() const { return system_; }

  Placement at(const PoseChange& change) const {
    std::vector<Pose> poses;
    std::vector<double> scales;
    for (std::size_t f = 0; f < document_.frames.size(); ++f) {
      poses.push_back(changed(document_.frames[f].pose, change[f]));
      scales.push_back(document_.frames[f].scale * std::exp(change[f].log_scale));
    }
    return placed(document_, poses, scales);
  }
  double energy(const PoseChange& change, const Stage& stage,
                std::vector<std::pair<int, MotionSystem>>* systems) const {
    const Placement placement = at(change);
    double sum = prior_energy(change, prior);
    if (systems) systems->clear();
    if (stage.noise > 0) {
      sum += residuals_.evaluate(placement, {stage.reach, 0}, systems) / stage.noise;
      if (systems)
        for (auto& [joint, system] : *systems) {
          system.H /= stage.noise;
          system.g /= stage.noise;
        }
    }
    return sum +
           landmark_energy(residuals_, document_.skeleton, placement, stage.landmarks, systems);
  }
  void linearise(const PoseChange& change, const Stage& stage) {
    energy(change, stage, &parts_);
    system_.assemble(change, parts_);
  }
  Solved minimise(PoseChange start, const Stage& stage, int most) {
    Solved best{std::move(start), 0};
    best.energy = energy(best.change, stage, &parts_);
    system_.assemble(best.change, parts_);
    double damping = 1e-3;
    for (int i = 0; i < most && !run_.cancelled(); ++i) {
      PoseChange trial = system_.stepped(best.change, prior, damping);
      const double e = energy(trial, stage, &parts_);
      ++iterations;
      if (e < best.energy) {
        const bool done = e > best.energy * (1 - kSettled);
        best.change = std::move(trial);
        best.energy = e;
        damping = std::max(damping / 5, 1e-6);
        if (done) break;
        system_.assemble(best.change, parts_);
      } else {
        damping *= 8;
        if (damping > 1e4) break;
      }
    }
    return best;
  }

 private:
  const Document& document_;
  const RayResiduals& residuals_;
  PoseSystem system_;
  Run& run_;
  std::vector<std::pair<int, MotionSystem>> parts_;
};

// Which of the unknowns may move: frames but the first, and joints that shared contours hang on.
PoseFreedom freedom_of(const Document& document) {
  const PoseLimits limits = pose_limits(document);
  PoseFreedom freedom;
  freedom.max_rotation = limits.max_rotation;
  freedom.max_translation = limits.max_translation;
  freedom.scale = document.calibration.scale;
  const auto shared = shared_contours(document);
  const int joints = document.skeleton.size();
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    freedom.frame.push_back(f > 0 || document.calibration.free_first_frame);
    freedom.joint.emplace_back(joints, 0);
    for (int j = joints - 1; j >= 0; --j)
      if (freedom.frame[f] && shared[f][j])
        for (int a = j; a >= 0; a = document.skeleton.joints[a].parent) freedom.joint[f][a] = 1;
    for (const int j : document.calibration.locked) freedom.joint[f][j] = 0;
  }
  return freedom;
}

// The prior, as wide as the user's poses seem to be off: their energy against what a prior of full
// width would make on average.
PosePrior prior_of(Solver& solver, const PoseChange& user, const PoseFreedom& freedom) {
  PosePrior prior{kPriorShare * freedom.max_rotation, kPriorShare * freedom.max_translation,
                  kPriorScale};
  solver.prior = prior;
  const Stage rays_alone;
  const double energy = solver.energy(user, rays_alone, nullptr);
  solver.linearise(user, rays_alone);
  // Twice, since errors also hide where silhouettes don't show them.
  const double share =
      std::sqrt(std::clamp(2 * energy / solver.system().expected_energy(prior), 1e-4, 1.0));
  prior.rotation *= share;
  prior.translation *= share;
  prior.log_scale *= share;
  return prior;
}

// The best of three starts: the user's poses by narrowing kernels, the landmarks' poses likewise,
// and the user's poses with the narrow kernel at once.
Solved best_start(Solver& solver, const PoseChange& user) {
  const Stage plain{kNoise, 0, kKeep}, wide{kNoise, kWide, kKeep}, narrow{kNoise, kNarrow, kKeep};
  const auto refined = [&](PoseChange start) {
    Solved s = solver.minimise(std::move(start), plain, kIterations);
    s = solver.minimise(std::move(s.change), wide, kIterations);
    return solver.minimise(std::move(s.change), narrow, kIterations);
  };
  const Stage landmarks{0, 0, kLead};
  const Solved starts[] = {refined(user),
                           refined(solver.minimise(user, landmarks, kIterations).change),
                           solver.minimise(user, narrow, kIterations)};
  return *std::min_element(std::begin(starts), std::end(starts),
                           [](const Solved& a, const Solved& b) { return a.energy < b.energy; });
}

}  // namespace

Result<Calibration> calibrate_rays(const Document& document, Run& run) {
  const RayResiduals residuals(document, kRayStep, kMostRays);
  const PoseFreedom freedom = freedom_of(document);
  Solver solver(document, residuals, freedom, run);
  const PoseChange user = no_change(document);
  solver.prior = prior_of(solver, user, freedom);
  Solved best = best_start(solver, user);
  run.report(0.7);
  // What the rays still miss by tells their noise: twice more, with the rays weighed by it.
  for (int i = 0; i < 2; ++i) {
    const double mean = residuals.evaluate(solver.at(best.change), {kNarrow, 0}, nullptr) /
                        residuals.contour_length();
    const double noise = std::clamp(kNoisePerMean * mean, kLeastNoise, kMostNoise);
    best = solver.minimise(std::move(best.change), {noise, kNarrow, kKeep}, kIterations);
  }
  if (run.cancelled()) return cancelled();
  Calibration result;
  result.energy_before = residuals.evaluate(solver.at(user), {kNarrow, 0}, nullptr);
  result.energy_after = residuals.evaluate(solver.at(best.change), {kNarrow, 0}, nullptr);
  result.iterations = solver.iterations;
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    result.poses.push_back(changed(document.frames[f].pose, best.change[f]));
    result.scales.push_back(document.frames[f].scale * std::exp(best.change[f].log_scale));
  }
  return result;
}

}  // namespace artisketch

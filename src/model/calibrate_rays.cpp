// Calibration without voxels: how far contour rays miss the parts' hulls, by Levenberg–Marquardt
// over all joints and frames at once.
//
// Silhouettes leave much open (the twist of a limb, where in its depth a part sits on its bone),
// and drawings contradict themselves. So, besides the rays,
// - a prior pulls to the user's poses, no wider than the silhouettes say that these are off: poses
//   that are right already stay where they are;
// - landmarks near the middle of their bones say, weakly, what silhouettes don't;
// - kernels that narrow step by step let contours go that contradict all others;
// - several starts are followed, and the end with the least energy is taken;
// - the rays' noise is measured on what they leave, and the end refined with it.
#include <algorithm>
#include <cmath>
#include <string>

#include "model/calibration_words.h"
#include "model/landmark_residuals.h"
#include "model/pose_system.h"

namespace artisketch {
namespace {

constexpr double kRayStep = 3;  // units of the drawing between rays; a unit is about a pixel
constexpr int kMostRays = 32;   // of one contour

// Deviations of the prior at its widest, of the limits that the document sets: users seem to be off
// by anything up to the limit or a little less, in any direction.
constexpr double kDeviation = 0.27;
constexpr double kScaleDeviation = 0.05;
constexpr double kNarrowest = 0.01;   // of the widest
constexpr double kPriorVariance = 2;  // times the variance measured: errors hide in open angles

// Energy per standard deviation: a contour's error of a pixel all along some ten of it.
constexpr double kNoise = 10, kLeastNoise = 1.5, kMostNoise = 40;
constexpr double kNoisePerMiss = 300;      // times the mean square by which rays miss at the end
constexpr double kWide = 12, kNarrow = 4;  // units: reaches of the robust kernels

// Centroids of outlines are off their landmark's image by a tenth of the outline's size, and
// landmarks off their bone by a twelfth of the part's radius (characters at their true poses).
constexpr LandmarkLoss kLandmarks{100, 150};

constexpr int kMostSteps = 30, kMostLandmarkSteps = 20;
constexpr double kSettled = 1e-3;  // relative gain of a step that ends a stage
constexpr int kRefinements = 2;

// A frame moves if it can be compared in at least this share of the parts that others can be.
constexpr double kEnoughParts = 0.25;
// A joint without a contour moves where the parts below it would miss by more than this otherwise.
constexpr double kNeed = 1.5;  // units, root mean square

struct Stage {
  double noise = kNoise;  // divides the rays' energy; 0: without rays
  double reach = 0;       // of their kernel, units; 0: plain squares
  LandmarkLoss landmarks = kLandmarks;
};

struct Solved {
  PoseChange change;
  double energy = 0;
};

class Solver {
 public:
  Solver(const Document& document, const RayResiduals& rays, PoseFreedom freedom, Run& run)
      : document_(document), rays_(rays), system_(document, std::move(freedom)), run_(run) {
    const PoseFreedom& free = system_.freedom();
    prior_ = {kDeviation * free.max_rotation, kDeviation * free.max_translation, kScaleDeviation};
  }

  int iterations() const { return iterations_; }
  std::vector<Pose> poses(const PoseChange& change) const;
  std::vector<double> scales(const PoseChange& change) const;
  Placement at(const PoseChange& change) const {
    return placed(document_, poses(change), scales(change));
  }
  // Mean square by which rays miss, with the narrow kernel, in unit()².
  double miss(const PoseChange& change) const {
    return rays_.evaluate(at(change), {kNarrow, 0}, nullptr) /
           std::max(rays_.contour_length(), 1e-9);
  }

  void narrow_prior(const PoseChange& user);
  Solved minimise(const PoseChange& start, const Stage& stage, int most_steps);
  Solved follow(const PoseChange& start);
  Solved best_of_starts(const PoseChange& user);

 private:
  double energy(const PoseChange& change, const Stage& stage);  // and its system, in parts_

  const Document& document_;
  const RayResiduals& rays_;
  PoseSystem system_;
  Run& run_;
  PosePrior prior_;
  std::vector<std::pair<int, MotionSystem>> parts_;
  int iterations_ = 0;
};

std::vector<Pose> Solver::poses(const PoseChange& change) const {
  std::vector<Pose> poses;
  for (std::size_t f = 0; f < change.size(); ++f)
    poses.push_back(changed(document_.frames[f].pose, change[f]));
  return poses;
}

std::vector<double> Solver::scales(const PoseChange& change) const {
  std::vector<double> scales;
  for (std::size_t f = 0; f < change.size(); ++f)
    scales.push_back(document_.frames[f].scale * std::exp(change[f].log_scale));
  return scales;
}

double Solver::energy(const PoseChange& change, const Stage& stage) {
  const Placement placement = at(change);
  parts_.clear();
  double sum = prior_energy(change, prior_);
  if (stage.noise > 0) {
    sum += rays_.evaluate(placement, {stage.reach, 0}, &parts_) / stage.noise;
    for (auto& [joint, system] : parts_) {
      system.H /= stage.noise;
      system.g /= stage.noise;
    }
  }
  return sum + landmark_energy(rays_, document_.skeleton, placement, stage.landmarks, &parts_);
}

// The prior's width by the method of moments: the rays' energy at the user's poses against what
// errors of the widest prior's size would make of it.
void Solver::narrow_prior(const PoseChange& user) {
  const double found = energy(user, {1, 0, {}});
  system_.assemble(user, parts_);
  const double expected = system_.expected_energy(prior_);
  const double variance = expected > 0 ? kPriorVariance * found / expected : 1;
  const double width = std::sqrt(std::clamp(variance, kNarrowest * kNarrowest, 1.0));
  prior_.rotation *= width;
  prior_.translation *= width;
  prior_.log_scale *= width;
}

Solved Solver::minimise(const PoseChange& start, const Stage& stage, int most_steps) {
  Solved best{start, energy(start, stage)};
  system_.assemble(best.change, parts_);
  double damping = 1e-3;
  for (int i = 0; i < most_steps && damping < 1e4 && !run_.cancelled(); ++i) {
    PoseChange trial = system_.stepped(best.change, prior_, damping);
    const double trial_energy = energy(trial, stage);
    ++iterations_;
    if (!(trial_energy < best.energy)) {
      damping *= 8;
      continue;
    }
    const bool settled = trial_energy > best.energy * (1 - kSettled);
    best = {std::move(trial), trial_energy};
    if (settled) break;
    damping = std::max(damping / 5, 1e-6);
    system_.assemble(best.change, parts_);
  }
  return best;
}

Solved Solver::follow(const PoseChange& start) {
  const PoseChange plain = minimise(start, {kNoise, 0}, kMostSteps).change;
  const PoseChange wide = minimise(plain, {kNoise, kWide}, kMostSteps).change;
  return minimise(wide, {kNoise, kNarrow}, kMostSteps);
}

Solved Solver::best_of_starts(const PoseChange& user) {
  Solved best = minimise(user, {kNoise, kNarrow}, kMostSteps);  // contradicting contours: stay near
  run_.report(0.2);
  const auto take = [&](Solved other) {
    if (other.energy < best.energy) best = std::move(other);
  };
  take(follow(user));
  run_.report(0.5);
  take(follow(minimise(user, {0, 0}, kMostLandmarkSteps).change));
  run_.report(0.8);
  for (int i = 0; i < kRefinements; ++i) {
    const double noise = std::clamp(kNoisePerMiss * miss(best.change), kLeastNoise, kMostNoise);
    best = minimise(best.change, {noise, kNarrow}, kMostSteps);
  }
  return best;
}

// ---------------------------------------------------------------- what may move

// Frames that show too few of the parts that others show keep the user's poses.
std::vector<char> frames_that_move(const Document& document,
                                   const std::vector<std::vector<char>>& shared,
                                   std::vector<std::string>& warnings) {
  std::vector<int> parts;
  for (const std::vector<char>& frame : shared)
    parts.push_back(int(std::count(frame.begin(), frame.end(), 1)));
  const int most = *std::max_element(parts.begin(), parts.end());
  std::vector<char> moves;
  for (int f = 0; f < int(parts.size()); ++f) {
    const bool enough = parts[f] > 0 && parts[f] >= kEnoughParts * most;
    moves.push_back(enough && (f > 0 || document.calibration.free_first_frame));
    if (!enough)
      warnings.push_back(
          frame_words(document, f) + ": just " + std::to_string(parts[f]) +
          " of its parts can be compared with other frames; its pose stays as given");
  }
  return moves;
}

// Joints turn where their own contour can be compared.
PoseFreedom freedom_of(const Document& document, const std::vector<std::vector<char>>& shared,
                       std::vector<char> moves) {
  const PoseLimits limits = pose_limits(document);
  PoseFreedom freedom;
  freedom.max_rotation = limits.max_rotation;
  freedom.max_translation = limits.max_translation;
  freedom.scale = document.calibration.scale;
  freedom.frame = std::move(moves);
  freedom.joint = shared;
  for (std::size_t f = 0; f < freedom.joint.size(); ++f) {
    if (!freedom.frame[f]) freedom.joint[f].assign(freedom.joint[f].size(), 0);
    for (const int joint : document.calibration.locked) freedom.joint[f][joint] = 0;
  }
  return freedom;
}

// Frees joints without a contour in a frame where the parts below them, as posed, miss their hulls
// there. Returns whether there were any.
bool free_where_needed(const Document& document, const RayResiduals& rays,
                       const Placement& placement, PoseFreedom& freedom) {
  const int joints = document.skeleton.size(), frames = int(document.frames.size());
  // Sums of squared misses, and their number, of all parts below each joint.
  std::vector<std::vector<double>> sum(frames, std::vector<double>(joints)), count = sum;
  for (const RayResiduals::Part& part : rays.parts()) {
    const auto misses = rays.misses(part, placement);
    for (std::size_t v = 0; v < misses.size(); ++v)
      for (int j = part.joint; j >= 0; j = document.skeleton.joints[j].parent)
        for (const double squared : misses[v]) {
          sum[part.views[v].frame][j] += squared;
          ++count[part.views[v].frame][j];
        }
  }
  bool any = false;
  std::vector<char> locked(joints, 0);
  for (const int joint : document.calibration.locked) locked[joint] = 1;
  const double need = kNeed * rays.unit() * kNeed * rays.unit();
  for (int f = 0; f < frames; ++f)
    for (int j = 0; j < joints; ++j)
      if (freedom.frame[f] && !freedom.joint[f][j] && !locked[j] && sum[f][j] > need * count[f][j])
        freedom.joint[f][j] = any = true;
  return any;
}

}  // namespace

Result<Calibration> calibrate_rays(const Document& document, Run& run) {
  Calibration result;
  const RayResiduals rays(document, kRayStep, kMostRays);
  const auto shared = shared_contours(document);
  PoseFreedom freedom =
      freedom_of(document, shared, frames_that_move(document, shared, result.warnings));
  const PoseChange user = no_change(document);
  const auto solve = [&](const PoseFreedom& free) {
    Solver solver(document, rays, free, run);
    solver.narrow_prior(user);
    const Solved best = solver.best_of_starts(user);
    const double pixels2 = rays.unit() * rays.unit();
    result.energy_before = solver.miss(user) * pixels2;
    result.energy_after = solver.miss(best.change) * pixels2;
    result.iterations += solver.iterations();
    result.poses = solver.poses(best.change);
    result.scales = solver.scales(best.change);
  };
  solve(freedom);
  if (!run.cancelled() &&
      free_where_needed(document, rays, placed(document, result.poses, result.scales), freedom))
    solve(freedom);
  if (run.cancelled()) return cancelled();
  run.report(1);
  return result;
}

}  // namespace artisketch

#include "model/calibrate/pose_solver.h"

#include <algorithm>
#include <cmath>

namespace artisketch {
namespace {

constexpr double kSettled = 1e-3;      // an energy that falls by less
constexpr int kSettledSteps = 2;       // so often in turn ends it: one step may be cut short
constexpr double kNarrowest = 0.01;    // of a prior's width
constexpr double kHiddenVariance = 2;  // times what shows: errors hide in open angles, too

}  // namespace

PoseSolver::PoseSolver(const Document& document, const RayResiduals& residuals, PoseFreedom freedom,
                       const PosePrior& prior, Run& run)
    : document_(document),
      residuals_(residuals),
      system_(document, std::move(freedom)),
      prior_(prior),
      run_(run) {}

std::vector<Pose> PoseSolver::poses(const PoseChange& change) const {
  std::vector<Pose> poses;
  for (std::size_t f = 0; f < change.size(); ++f)
    poses.push_back(changed(document_.frames[f].pose, change[f]));
  return poses;
}

std::vector<double> PoseSolver::scales(const PoseChange& change) const {
  std::vector<double> scales;
  for (std::size_t f = 0; f < change.size(); ++f)
    scales.push_back(document_.frames[f].scale * std::exp(change[f].log_scale));
  return scales;
}

double PoseSolver::energy(const PoseChange& change, const PoseEnergy& what) const {
  return evaluate(change, what, nullptr);
}

double PoseSolver::evaluate(const PoseChange& change, const PoseEnergy& what,
                            MotionSystems* systems) const {
  const Placement placement = at(change);
  double sum = prior_energy(change, prior_);
  if (systems) residuals_.clear(*systems, int(change.size()));
  if (what.noise > 0) sum += residuals_.evaluate(placement, what.reach, 1 / what.noise, systems);
  return sum + landmark_energy(residuals_, document_, placement, what.landmarks, systems);
}

SolvedPoses PoseSolver::minimise(PoseChange start, const PoseEnergy& what, int most) {
  SolvedPoses best{std::move(start), 0};
  best.energy = evaluate(best.change, what, &systems_);
  system_.assemble(best.change, systems_);
  double damping = 1e-3;
  int slow = 0;
  for (int i = 0; i < most && damping < 1e4 && !run_.cancelled(); ++i) {
    PoseChange trial = system_.stepped(best.change, prior_, damping);
    const double energy = evaluate(trial, what, &systems_);
    ++iterations_;
    if (!(energy < best.energy)) {
      damping *= 8;
      continue;
    }
    slow = energy > best.energy * (1 - kSettled) ? slow + 1 : 0;
    best = {std::move(trial), energy};
    if (slow >= kSettledSteps) break;
    damping = std::max(damping / 5, 1e-6);
    system_.assemble(best.change, systems_);
  }
  return best;
}

void PoseSolver::narrow_prior(const PoseChange& user) {
  const double found = evaluate(user, {1, 0, {0, 0}}, &systems_);
  system_.assemble(user, systems_);
  const double expected = system_.expected_energy(prior_);
  const double variance = expected > 0 ? kHiddenVariance * found / expected : 1;
  const double width = std::sqrt(std::clamp(variance, kNarrowest * kNarrowest, 1.0));
  prior_.rotation *= width;
  prior_.translation *= width;
}

}  // namespace artisketch

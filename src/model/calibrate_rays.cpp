// Calibration without voxels: Levenberg–Marquardt over all joints and frames at once on how far
// contour rays miss the hull, with a prior to the user's poses.
#include <cmath>
#include <cstdlib>

#include "model/pose_parameters.h"
#include "model/ray_residuals.h"

namespace artisketch {
double env(const char* n, double d) { const char* s = getenv(n); return s ? atof(s) : d; }
namespace {

struct Solved {
  PoseChange change;
  double energy = 0;
  int iterations = 0;
};

Solved minimise(const RayResiduals& residuals, PoseSystem& system, PoseChange start,
                const RayLoss& loss, int most_iterations) {
  std::vector<std::pair<int, MotionSystem>> parts;
  Solved best{std::move(start)};
  best.energy = residuals.evaluate(best.change, loss, &parts) + system.prior_energy(best.change);
  system.assemble(best.change, parts);
  double damping = 1e-3;
  for (int i = 0; i < most_iterations; ++i) {
    PoseChange trial = system.stepped(best.change, damping);
    const double energy = residuals.evaluate(trial, loss, &parts) + system.prior_energy(trial);
    ++best.iterations;
    if (energy < best.energy) {
      const bool done = energy > best.energy * (1 - env("TOL", 1e-3));
      best.change = std::move(trial);
      best.energy = energy;
      damping = std::max(damping / 5, 1e-6);
      if (done) break;
      system.assemble(best.change, parts);
    } else {
      damping *= 8;
      if (damping > 1e4) break;
    }
  }
  return best;
}

}  // namespace

Result<Calibration> calibrate_rays(const Document& document, Run& run) {
  (void)run;
  RayOptions options;
  options.rays_per_contour = int(env("RAYS", 32));
  RayResiduals residuals(document, options);
  const PoseBounds bounds = pose_bounds(document);
  PosePrior prior;
  const double sigma = env("SIG", 0.27);
  for (const double most : bounds.rotation) prior.rotation.push_back(sigma * most);
  prior.translation = sigma * bounds.translation;
  // energies are in pixels² per pixel of contour: bring to noise
  const double k = env("NOISE", 10);
  for (double& w : prior.rotation) w *= 1 / std::sqrt(k);
  prior.translation /= std::sqrt(k);
  const auto shared = shared_parts(document);
  const int n = document.skeleton.size();
  std::vector<std::vector<bool>> free(document.frames.size(), std::vector<bool>(n, false));
  for (std::size_t f = 0; f < document.frames.size(); ++f)
    for (int j = n - 1; j >= 0; --j) {
      if (bounds.moves[f] && shared[f][j])
        for (int a = j; a >= 0; a = document.skeleton.joints[a].parent) free[f][a] = true;
    }
  PoseSystem system(document, bounds, prior, free, document.calibration.scale);
  const PoseChange user = no_change(document);
  {
    std::vector<std::pair<int, MotionSystem>> parts;
    const double e = residuals.evaluate(user, RayLoss{env("MC", 0), 0}, &parts);
    system.assemble(user, parts);
    const double predicted = system.trace_rotation() * prior.rotation[0] * prior.rotation[0] * k +
                             system.trace_translation() * prior.translation * prior.translation * k;
    const double ratio = e / predicted;
    if (getenv("VERB")) printf("   sigma estimate %.2f deg (clamp %.2f)\n", degrees(std::sqrt(ratio * k) * prior.rotation[0]), degrees(std::sqrt(k) * prior.rotation[0]));
    const double f = std::sqrt(std::clamp(env("MOM", 1) * ratio, 1e-4, 1.0));
    if (env("EB", 1) > 0) {
      for (double& w : prior.rotation) w *= f;
      prior.translation *= f;
      system.set_prior(prior);
    }
  }
  const double lm = k * env("LMK", 0), bn = k * env("BONEK", 0);
  const RayLoss plain{0, lm, true, bn}, wide{12, lm, true, bn}, narrow{4, lm, true, bn},
      landmark{0, k * env("LM", 10), false, k * env("BONE", 0)};
  Calibration result;
  int its = 0;
  const auto refine = [&](PoseChange start) {
    Solved s = minimise(residuals, system, start, plain, int(env("IT", 30)));
    its += s.iterations;
    s = minimise(residuals, system, s.change, wide, int(env("IT", 30)));
    its += s.iterations;
    s = minimise(residuals, system, s.change, narrow, int(env("IT", 30)));
    its += s.iterations;
    return s;
  };
  std::vector<Solved> all;
  const int mask = int(env("STARTS", 7));
  if (mask & 1) all.push_back(refine(user));
  if (mask & 2) {
    Solved s = minimise(residuals, system, user, landmark, 20);
    its += s.iterations;
    if (mask & 8) all.push_back(s); else
    all.push_back(refine(s.change));
  }
  if (mask & 4) {
    all.push_back(minimise(residuals, system, user, narrow, 40));
    its += all.back().iterations;
  }
  const Solved* best = &all[0];
  for (const Solved& s : all)
    if (s.energy < best->energy) best = &s;
  double W = 0;
  for (const auto& p : residuals.parts())
    for (const auto& v : p.views) W += v.weight * v.points.size();
  if (getenv("VERB"))
    printf("   mean square at user's %.3f robust %.3f, at best %.3f\n", residuals.evaluate(user, plain, nullptr) / W,
           residuals.evaluate(user, narrow, nullptr) / W,
           residuals.evaluate(best->change, narrow, nullptr) / W);
  if (getenv("VERB"))
    for (const Solved& s : all) printf("   E %.2f (prior %.2f)\n", s.energy, system.prior_energy(s.change));
  result.energy_before = residuals.evaluate(user, narrow, nullptr);
  result.energy_after = residuals.evaluate(best->change, narrow, nullptr);
  result.iterations = its;
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    result.poses.push_back(changed(document.frames[f].pose, best->change[f]));
    result.scales.push_back(document.frames[f].scale * std::exp(best->change[f].log_scale));
  }
  return result;
}

}  // namespace artisketch

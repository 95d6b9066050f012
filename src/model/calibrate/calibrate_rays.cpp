// Calibration without voxels: how far contour rays miss the parts' hulls, by Levenberg–Marquardt
// over all joints and frames at once, with a prior that pulls to the user's poses.
//
// Silhouettes leave much open (the twist of a limb, the depth at which a part sits on its bone),
// and drawings disagree with themselves. So
// - the prior is as wide as the silhouettes say that the poses are off: poses that are right
//   already stay;
// - landmarks about the middles of bones say, weakly, what silhouettes leave open;
// - Geman–McClure kernels, narrowed step by step, let contours that contradict all others go;
// - several starts are tried, each to its end, since a start that looks well may end badly, and a
//   millionth of a pixel may decide which looks best: the one that ends with least energy is taken;
// - at each end, joints whose parts still miss are turned out of that minimum, one at a time with
//   all that hangs on them, or their limbs begun anew, and let fall into a better one;
// - the rays' noise is measured on what is left, and the end refined with it: drawings that
//   disagree by pixels say little against the poses given, however well turning bones would explain
//   them; nor is the first frame's pose then better known than theirs, and its limbs move, too.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/at_once.h"
#include "base/trigonometry.h"
#include "document/place_words.h"
#include "model/calibrate/calibration_words.h"
#include "model/calibrate/pose_solver.h"
#include "model/one_order.h"

namespace artisketch {
namespace {

constexpr double kRayStep = 3;   // units of the drawing between rays
constexpr int kMostRays = 32;    // of one contour
constexpr int kIterations = 30;  // of one stage, at most
constexpr double kSameMinimum =
    1e-3;  // starts whose energies differ by less: as far as one settles
constexpr double kWide = 12, kNarrow = 4;  // pixels: where the kernels let go
constexpr double kNoise = 10;  // pixels²: what the stages take a ray's error for at first
constexpr double kLeastNoise = 0.1;
constexpr double kNoisePerMean = 200;  // the noise that the mean robust error at the end speaks for
constexpr int kRefinements = 4;        // with the noise measured
// The mean robust error at the end, unit()², that counts as half a contradiction: rendered figures
// leave 0.001 to 0.02 of it, people's drawings 0.6 to 1.4. Drawings that contradict each other
// wholly are twice as noisy as their errors tell, since poses have given way to them already.
constexpr double kContradicted = 0.15;
// Of the prior's width, what the first frame's pose then gets, which was set with the most care;
// and what moves nothing that would show.
constexpr double kFirstShare = 0.5, kLeastFirstShare = 0.02;
// Times what they weigh else, landmarks weigh so much more where drawings contradict each other
// wholly: a part drawn longer or wider has its middle where it had it.
constexpr double kMiddlesLast = 2;
constexpr double kPriorShare = 0.27;  // of the limits: the prior's standard deviation at its widest
constexpr double kPriorScale = 0.05;  // standard deviation of a frame's log scale

constexpr LandmarkLoss kLead{10, 0};  // landmarks that lead a start
constexpr PoseEnergy kPlain{kNoise, 0}, kWideKernel{kNoise, kWide}, kNarrowKernel{kNoise, kNarrow};

// A frame moves if it can be compared in at least this share of the parts that others can be.
constexpr double kEnoughParts = 0.25;

// Turns out of a minimum: so far about each axis, for at most so many parts in their frames, those
// that miss by so many times what most do.
constexpr double kOutstanding = 5;
constexpr double kTurn = radians(25);
constexpr int kMostTurned = 12;
constexpr int kTurnIterations = 12;
constexpr std::size_t kMostFinished = 3;  // of the ways to turn a joint

constexpr int kHoldIterations = 10;
constexpr std::size_t kMostHeld = 24;  // joints without contours, looked at one by one

// ---------------------------------------------------------------- what may move

// Frames that show too few of the parts that others show keep the user's poses; so does the first,
// unless it's asked for.
std::vector<char> frames_that_move(const Document& document,
                                   const std::vector<std::vector<char>>& shared, bool first,
                                   std::vector<std::string>& warnings) {
  std::vector<int> parts;
  for (const std::vector<char>& frame : shared)
    parts.push_back(int(std::count(frame.begin(), frame.end(), 1)));
  const int most = *std::max_element(parts.begin(), parts.end());
  std::vector<char> moves;
  for (int f = 0; f < int(parts.size()); ++f) {
    const bool enough = parts[f] > 0 && parts[f] >= kEnoughParts * most;
    moves.push_back(enough && (f > 0 || first));
    if (!enough && !document.frames[f].contours.empty())
      warnings.push_back(frame_words(document, f) + ": just " + std::to_string(parts[f]) +
                         " of its parts can be compared with other frames: its pose stays as " +
                         "given");
  }
  return moves;
}

// Joints may turn where contours that can be compared hang on them.
PoseFreedom freedom_of(const Document& document, bool first, std::vector<std::string>& warnings) {
  const PoseLimits limits = pose_limits(document);
  const auto shared = shared_contours(document);
  PoseFreedom freedom;
  freedom.max_rotation = limits.max_rotation;
  freedom.max_translation = limits.max_translation;
  freedom.scale = document.calibration.scale;
  freedom.frame = frames_that_move(document, shared, first, warnings);
  const int joints = document.skeleton.size();
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    freedom.joint.emplace_back(joints, 0);
    for (int j = joints - 1; j >= 0; --j)
      if (freedom.frame[f] && shared[f][j])
        for (int a = j; a >= 0; a = document.skeleton.joints[a].parent) freedom.joint[f][a] = 1;
    for (const int j : document.calibration.locked) freedom.joint[f][j] = 0;
  }
  return freedom;
}

// ---------------------------------------------------------------- starts

// Three starts, or fewer where some come to the same, the best first: the user's poses by narrowing
// kernels, the landmarks' poses likewise, and the user's poses with the narrow kernel at once.
std::vector<SolvedPoses> starts_of(const PoseSolver& solver, const PoseChange& user, int threads,
                                   int& iterations) {
  const auto narrowed = [&](PoseSolver& by, PoseChange start) {
    SolvedPoses s = by.minimise(std::move(start), kPlain, kIterations);
    s = by.minimise(std::move(s.change), kWideKernel, kIterations);
    return by.minimise(std::move(s.change), kNarrowKernel, kIterations);
  };
  const PoseEnergy landmarks{0, 0, kLead};
  constexpr int kStarts = 3;
  std::vector<PoseSolver> solvers(kStarts, solver);
  std::vector<SolvedPoses> starts(kStarts);
  at_once(kStarts, threads, [&](int i) {
    PoseSolver& by = solvers[i];
    starts[i] = i == 0   ? narrowed(by, user)
                : i == 1 ? narrowed(by, by.minimise(user, landmarks, kIterations).change)
                         : by.minimise(user, kNarrowKernel, kIterations);
  });
  for (const PoseSolver& by : solvers) iterations += by.iterations();
  std::stable_sort(starts.begin(), starts.end(),
                   [](const SolvedPoses& a, const SolvedPoses& b) { return a.energy < b.energy; });
  const auto same = [](const SolvedPoses& a, const SolvedPoses& b) {
    return b.energy <= a.energy * (1 + kSameMinimum);
  };
  starts.erase(std::unique(starts.begin(), starts.end(), same), starts.end());
  return starts;
}

// ---------------------------------------------------------------- turns out of minima

struct Missed {
  int joint = 0, frame = 0;
  double energy = 0;  // robust, of the part's rays from that frame
};

// Parts in frames that may move whose rays miss by much more than most parts' do, and by more than
// a drawing's noise; the worst first.
std::vector<Missed> missed(const RayResiduals& residuals, const Placement& placement,
                           const PoseFreedom& freedom) {
  std::vector<Missed> all;
  std::vector<double> energies;
  const double c2 = kNarrow * kNarrow * residuals.unit() * residuals.unit();
  for (const RayResiduals::Part& part : residuals.parts()) {
    const auto misses = residuals.misses(part, placement);
    for (std::size_t v = 0; v < misses.size(); ++v) {
      Missed one{part.joint, part.views[v].frame, 0};
      for (const double e : misses[v]) one.energy += part.views[v].weight * e * c2 / (c2 + e);
      energies.push_back(one.energy);
      if (freedom.joint[one.frame][one.joint]) all.push_back(one);
    }
  }
  if (energies.empty()) return all;
  const auto middle = energies.begin() + std::ptrdiff_t(energies.size() / 2);
  std::nth_element(energies.begin(), middle, energies.end());
  const double much = std::max(kNoise, kOutstanding * *middle);
  all.erase(
      std::remove_if(all.begin(), all.end(), [&](const Missed& one) { return one.energy <= much; }),
      all.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const Missed& a, const Missed& b) { return a.energy > b.energy; });
  return all;
}

// The rotation vector of one rotation after another, cut to the limit.
Vec3 composed(const Vec3& first, const Vec3& then, double limit) {
  Quat q = rotation_by(first) * rotation_by(then);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double half_sine = q.vec().norm();
  if (half_sine < 1e-12) return Vec3::Zero();
  return q.vec() / half_sine * std::min(2 * arctangent(half_sine, q.w()), limit);
}

// Rotations of a joint in one frame that may lead to another minimum: about its bone, toward and
// away from the camera, in the picture, the bone mirrored in depth (which an orthographic camera
// can hardly tell), and the user's.
std::vector<Vec3> turned(const Vec3& now, const Mat3& axes, const Vec3& bone, double limit) {
  const Vec3 view = axes.transpose() * Vec3::UnitZ();
  const Vec3 along = bone.isZero(0) ? view.unitOrthogonal() : bone.normalized();
  const Vec3 across =
      along.cross(view).norm() > 1e-3 ? along.cross(view).normalized() : along.unitOrthogonal();
  const double depth = arctangent(along.dot(view), along.cross(view).norm());
  std::vector<Vec3> all = {Vec3::Zero(), composed(now, -2 * depth * across, limit)};
  for (const Vec3& axis : {along, across, Vec3(along.cross(across))})
    for (const double angle : {kTurn, -kTurn}) all.push_back(composed(now, angle * axis, limit));
  return all;
}

// Joints from one on outward.
std::vector<char> outward_of(const Skeleton& skeleton, int joint) {
  std::vector<char> outward(skeleton.size(), 0);
  for (int j = joint; j < skeleton.size(); ++j)
    outward[j] =
        j == joint || (skeleton.joints[j].parent >= 0 && outward[skeleton.joints[j].parent]);
  return outward;
}

// The joint that the limb of a joint begins with: below the last fork.
int start_of_limb(const Skeleton& skeleton, int joint) {
  for (int up = skeleton.joints[joint].parent; up > 0 && skeleton.children(up).size() == 1;
       up = skeleton.joints[joint].parent)
    joint = up;
  return joint;
}

// Rotations from one joint on outward in all frames, all else as it is, from the best of several
// starts. Returns nothing if none is better.
class Outward {
 public:
  Outward(const Document& document, const RayResiduals& residuals, const PoseFreedom& freedom,
          const PosePrior& prior, const PoseChange& from, int joint, Run& run)
      : outward_(outward_of(document.skeleton, joint)),
        residuals_(residuals.of(outward_)),
        run_(run),
        solver_(document, residuals_, only(freedom), prior, run),
        best_{from, solver_.energy(from, kNarrowKernel)},
        before_(best_.energy) {}

  // A few steps show which of them lead anywhere: those alone go on to the end.
  void start_at(std::vector<PoseChange> starts) {
    std::vector<SolvedPoses> tried(starts.size());
    at_once(int(starts.size()), run_.threads, [&](int i) {
      PoseSolver solver = solver_;
      tried[i] = solver.minimise(std::move(starts[i]), kWideKernel, kTurnIterations / 3);
      tried[i].energy = solver.energy(tried[i].change, kNarrowKernel);
    });
    std::stable_sort(tried.begin(), tried.end(), [](const SolvedPoses& a, const SolvedPoses& b) {
      return a.energy < b.energy;
    });
    if (tried.size() > kMostFinished) tried.resize(kMostFinished);
    at_once(int(tried.size()), run_.threads, [&](int i) {
      PoseSolver solver = solver_;
      tried[i] = solver.minimise(std::move(tried[i].change), kNarrowKernel, kTurnIterations);
    });
    for (SolvedPoses& end : tried)
      if (end.energy < best_.energy) best_ = std::move(end);
  }
  // The user's rotations in one frame; as they are and led by landmarks.
  void start_at_users(const PoseChange& from, int frame) {
    PoseChange start = from;
    for (std::size_t j = 0; j < outward_.size(); ++j)
      if (outward_[j]) start[frame].rotation[j].setZero();
    PoseChange led = solver_.minimise(start, {0, 0, kLead}, kTurnIterations).change;
    start_at({std::move(start), std::move(led)});
  }
  Placement at(const PoseChange& change) const { return solver_.at(change); }
  std::optional<PoseChange> better() const {
    if (best_.energy >= before_ - 1) return std::nullopt;
    return best_.change;
  }

 private:
  PoseFreedom only(PoseFreedom freedom) const {
    for (std::size_t f = 0; f < freedom.frame.size(); ++f) {
      freedom.frame[f] = 0;
      for (std::size_t j = 0; j < outward_.size(); ++j)
        if (!outward_[j]) freedom.joint[f][j] = 0;
    }
    return freedom;
  }

  std::vector<char> outward_;
  RayResiduals residuals_;
  Run& run_;
  PoseSolver solver_;
  SolvedPoses best_;
  double before_;
};

// A part's joint turned in the frame that it misses in, or else its whole limb begun anew there.
std::optional<PoseChange> turned_out(const Document& document, const RayResiduals& residuals,
                                     const PoseFreedom& freedom, const PosePrior& prior,
                                     const PoseChange& from, const Missed& where, Run& run) {
  Outward joint(document, residuals, freedom, prior, from, where.joint, run);
  const Vec3 now = from[where.frame].rotation[where.joint];
  const Mat3 axes = joint.at(from).posed[where.frame][where.joint].linear();
  const Vec3 bone = middle_of_bones(document, where.joint);
  std::vector<PoseChange> starts;
  for (const Vec3& rotation : turned(now, axes, bone, freedom.max_rotation)) {
    starts.push_back(from);
    starts.back()[where.frame].rotation[where.joint] = rotation;
  }
  joint.start_at(std::move(starts));
  if (auto better = joint.better()) return better;
  Outward limb(document, residuals, freedom, prior, from,
               start_of_limb(document.skeleton, where.joint), run);
  limb.start_at_users(from, where.frame);
  return limb.better();
}

// Rounds of turns until none helps; all joints are fitted again after each.
SolvedPoses out_of_minima(PoseSolver& solver, const Document& document,
                          const RayResiduals& residuals, const PoseFreedom& freedom,
                          SolvedPoses best, Run& run) {
  int left = kMostTurned;
  for (bool any = true; any && left > 0;) {
    any = false;
    PoseChange change = best.change;
    for (const Missed& one : missed(residuals, solver.at(change), freedom)) {
      if (run.cancelled() || left-- <= 0) break;
      if (auto better =
              turned_out(document, residuals, freedom, solver.prior(), change, one, run)) {
        change = std::move(*better);
        any = true;
      }
    }
    if (!any) break;
    SolvedPoses s = solver.minimise(std::move(change), kNarrowKernel, kIterations);
    if (s.energy < best.energy) best = std::move(s);
  }
  return best;
}

// ---------------------------------------------------------------- joints without contours

// Holds joints without a contour in a frame at the user's rotation where that costs next to
// nothing, so that they move only where what hangs on them needs it: all at once, else one by one,
// those that moved least first.
SolvedPoses unneeded_held(const Document& document, const RayResiduals& residuals,
                          PoseFreedom freedom, const PosePrior& prior, const PoseEnergy& what,
                          SolvedPoses best, Run& run) {
  const auto shared = shared_contours(document);
  std::vector<std::pair<int, int>> moved;  // frame, joint
  for (int f = 0; f < int(best.change.size()); ++f)
    for (int j = 1; j < document.skeleton.size(); ++j)
      if (freedom.joint[f][j] && !shared[f][j]) moved.emplace_back(f, j);
  std::stable_sort(moved.begin(), moved.end(), [&](const auto& a, const auto& b) {
    return best.change[a.first].rotation[a.second].squaredNorm() <
           best.change[b.first].rotation[b.second].squaredNorm();
  });
  best.energy = PoseSolver(document, residuals, freedom, prior, run).energy(best.change, what);
  const auto hold = [&](auto first, auto last) {
    PoseFreedom held = freedom;
    PoseChange start = best.change;
    for (auto one = first; one != last; ++one) {
      held.joint[one->first][one->second] = 0;
      start[one->first].rotation[one->second].setZero();
    }
    PoseSolver solver(document, residuals, held, prior, run);
    SolvedPoses s = solver.minimise(std::move(start), what, kHoldIterations);
    if (s.energy > best.energy + double(last - first)) return false;
    best = std::move(s);
    freedom = std::move(held);
    return true;
  };
  if (moved.empty() || hold(moved.begin(), moved.end())) return best;
  if (moved.size() > kMostHeld) moved.resize(kMostHeld);
  for (auto one = moved.begin(); one != moved.end() && !run.cancelled(); ++one) hold(one, one + 1);
  return best;
}

Document with_frames_of(Document document, const std::vector<int>& order) {
  std::vector<Frame> frames;
  for (const int f : order) frames.push_back(std::move(document.frames[f]));
  document.frames = std::move(frames);
  return document;
}

template <class T>
std::vector<T> as_given(std::vector<T> in_order, const std::vector<int>& order) {
  std::vector<T> given(in_order.size());
  for (std::size_t i = 0; i < order.size(); ++i) given[order[i]] = std::move(in_order[i]);
  return given;
}

}  // namespace

Result<Calibration> calibrate_rays(const Document& given, Run& run) {
  Calibration result;
  freedom_of(given, given.calibration.free_first_frame, result.warnings);
  const std::vector<int> order = frames_in_one_order(given);
  const Document document = with_frames_of(given, order);
  const RayResiduals residuals = RayResiduals(document, kRayStep, kMostRays).thinned();
  std::vector<std::string> said;  // above, of the drawings as they are numbered
  const PoseFreedom freedom = freedom_of(document, document.calibration.free_first_frame, said);
  // A limit of nothing is a prior of next to nothing: widths are divided by.
  constexpr double kLeastTurn = 1e-6;   // radians
  constexpr double kLeastShift = 1e-3;  // pixels
  const double shift =
      kPriorShare * std::max(freedom.max_translation, kLeastShift * pixel_size(document));
  const PosePrior widest{kPriorShare * std::max(freedom.max_rotation, kLeastTurn), shift, shift,
                         kPriorScale};
  PoseSolver solver(document, residuals, freedom, widest, run);
  const PoseChange user = no_change(document);
  solver.narrow_prior(user);
  const std::vector<SolvedPoses> starts = starts_of(solver, user, run.threads, result.iterations);
  run.report(0.4);
  SolvedPoses best = starts.front();
  for (const SolvedPoses& start : starts) {
    SolvedPoses end = out_of_minima(solver, document, residuals, freedom, start, run);
    if (end.energy < best.energy) best = std::move(end);
  }
  run.report(0.8);
  const auto robust = [&](const PoseChange& change) {
    return residuals.evaluate(solver.at(change), kNarrow, 1, nullptr);
  };
  const double left = robust(best.change) / residuals.contour_length();
  const double contradiction = left * left / (left * left + kContradicted * kContradicted);
  PoseFreedom loose = freedom;
  PosePrior prior = solver.prior();
  if (const double share = kFirstShare * contradiction;
      !document.calibration.free_first_frame && share > kLeastFirstShare) {
    std::vector<std::string> said_already;
    loose = freedom_of(document, true, said_already);
    // Where it stands and which way it faces stay: nothing else says which side is the front, and
    // a body would tip away to explain what differs in size.
    loose.frame[0] = loose.joint[0][0] = 0;
    prior.first = share;
  }
  PoseSolver fine(document, residuals, loose, prior, run);
  PoseEnergy measured = kNarrowKernel;
  measured.landmarks.centroid *= 1 + kMiddlesLast * contradiction;
  measured.landmarks.bone *= 1 + kMiddlesLast * contradiction;
  for (int i = 0; i < kRefinements; ++i) {
    const double mean = robust(best.change) / residuals.contour_length();
    measured.noise = std::max(kNoisePerMean * (1 + contradiction) * mean, kLeastNoise);
    best = fine.minimise(std::move(best.change), measured, kIterations);
  }
  best = unneeded_held(document, residuals, loose, prior, measured, std::move(best), run);
  if (run.cancelled()) return cancelled();
  result.energy_before = robust(user);
  result.energy_after = robust(best.change);
  result.iterations += solver.iterations() + fine.iterations();
  result.poses = as_given(solver.poses(best.change), order);
  result.scales = as_given(solver.scales(best.change), order);
  return result;
}

}  // namespace artisketch

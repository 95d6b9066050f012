// Calibration as the paper has it (Levi & Gotsman 2013, section 2): frames are added one by one;
// the newest one's pose is refined until its contour rays meet those of all earlier frames.
//
// We read it so: correspondences are voxel pairs, for each pair of the newest frame and an earlier
// one both ways (a ray of the one against the voxels that the other hits); how many frames hit a
// voxel is counted over all of them. A pair's two points are the ray's own point and the hit
// voxel's. Where a ray runs through a voxel that the other frame hits as well, the pair is at rest
// and holds.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "base/at_once.h"
#include "base/golden_section.h"
#include "model/calibrate/calibrate.h"
#include "model/calibrate/euler_solver.h"
#include "model/calibrate/ray_voxels.h"
#include "model/stages.h"

namespace artisketch {
namespace {

constexpr int kVoxels[] = {24, 48, 96};  // along a part's cube, from coarse to fine
constexpr int kLevels = 3;
constexpr int kIterations = 15;    // at most, of each level
constexpr int kDollyEvery = 3;     // iterations between searches along the view axis
constexpr double kLambda = 1.5;    // cost of a frame that doesn't hit the voxel, in voxels
constexpr double kSettled = 2e-4;  // of a part's cube: smaller moves end the iterations

// One part as one frame sees it.
struct Sight {
  PartView view;
  std::vector<Vec2> pixels;  // along the contours, about a voxel apart
};

struct PartRays {
  int joint = 0;
  VoxelCube cube;
  std::vector<Sight> earlier;
  Sight newest;
  std::vector<VoxelRays> earlier_rays;  // of each sight
  std::vector<HitCount> earlier_count;  // one: of all earlier sights together
};

std::vector<Vec2> pixels_along(const std::vector<Polyline>& contours, double step) {
  std::vector<Vec2> pixels;
  for (const Polyline& line : contours) {
    const Polyline even = resampled(line, step);
    pixels.insert(pixels.end(), even.points.begin(), even.points.end());
  }
  return pixels;
}

VoxelRays voxels_of(const VoxelCube& cube, const Sight& sight) {
  const bool line = sight.view.camera.camera.type == Camera::Type::orthographic;
  VoxelRays rays;
  for (const Vec2& pixel : sight.pixels)
    rays.push_back(voxels_along(cube, sight.view.ray(pixel), line));
  return rays;
}

// The intersection centroid: the point nearest to the rays through the contours' centroids, which
// the part's voxels are laid around.
Vec3 intersection_centroid(const std::vector<const PartView*>& views, const Vec3& joint) {
  constexpr double kToJoint = 1e-3;  // parallel rays leave the depth to the joint
  NearestToRays nearest(joint, kToJoint);
  for (const PartView* view : views) nearest.add(view->ray(centroid(view->contours)));
  return nearest.point();
}

// The parts that the newest frame shares with earlier ones, their rays through `side`³ voxels.
std::vector<PartRays> shared_parts(const Document& document, int newest, int side) {
  std::vector<PartRays> shared;
  for (Part& part : parts_of(document)) {
    PartRays rays;
    rays.joint = part.joint;
    std::vector<const PartView*> views;
    for (const PartView& view : part.views)
      if (view.frame <= newest) views.push_back(&view);
    if (views.size() < 2 || views.back()->frame != newest) continue;
    const Vec3 middle = intersection_centroid(views, part.origin);
    double diameter = 0;
    for (const PartView* view : views)
      diameter = std::max(diameter,
                          bounds(view->contours).diagonal().norm() / view->pixels_per_unit(middle));
    // Room for contours that don't meet yet.
    const double edge = 1.6 * diameter;
    rays.cube = {middle - Vec3::Constant(edge / 2), edge / side, side};
    for (const PartView* view : views) {
      const double step = std::max(0.5, rays.cube.cell * view->pixels_per_unit(middle));
      Sight sight{*view, pixels_along(view->contours, step)};
      if (view->frame == newest)
        rays.newest = std::move(sight);
      else
        rays.earlier.push_back(std::move(sight));
    }
    for (const Sight& sight : rays.earlier)
      rays.earlier_rays.push_back(voxels_of(rays.cube, sight));
    rays.earlier_count.emplace_back(rays.cube);
    for (const VoxelRays& sight : rays.earlier_rays) rays.earlier_count[0].add(sight);
    shared.push_back(std::move(rays));
  }
  return shared;
}

struct Matches {
  std::vector<PointPair> pairs;
  double energy = 0;  // mean squared distance of the pairs, in pixels²
};

// Adds the best pair of every `stride`-th ray of `from` with a voxel that `to` hits, as the points
// of the two frames, in part space: add(pair, of from, of to).
template <class Add>
void pair_up(const PartRays& part, const Sight& from, const VoxelRays& rays, const HitVoxels& to,
             int stride, const Add& add) {
  const double cell = part.cube.cell, reach = 0.5 * cell * part.cube.side;
  for (std::size_t i = 0; i < rays.size(); i += stride) {
    const Ray ray = from.view.ray(from.pixels[i]);
    const HitVoxels::Pair pair = to.best_pair(rays[i], ray, kLambda * cell, reach);
    if (pair.on_ray < 0) {
      add(pair, Vec3::Zero(), Vec3::Zero());
      continue;
    }
    const Vec3 hit = part.cube.centre(pair.hit);
    add(pair, ray.at((hit - ray.origin).dot(ray.direction)), hit);
  }
}

struct PartMatches {
  std::vector<PointPair> pairs;
  double sum = 0, count = 0;  // of squared distances, pixels²
};

// The pairs of the newest frame, posed by its view's motion, with every earlier one, both ways.
// `stride` takes every so many-th pixel.
PartMatches match_part(const PartRays& part, int stride) {
  PartMatches out;
  const PartView& view = part.newest.view;
  const double reach = 0.5 * part.cube.cell * part.cube.side;
  const double scale = view.pixels_per_unit(part.cube.origin + Vec3::Constant(reach));
  const auto add = [&](const HitVoxels::Pair& pair, const Vec3& earlier, const Vec3& newest) {
    const bool rests = pair.distance == 0 && pair.on_ray >= 0;
    const double apart = rests             ? 0
                         : pair.on_ray < 0 ? reach * scale
                                           : (earlier - newest).norm() * scale;
    out.sum += apart * apart;
    ++out.count;
    if (pair.on_ray < 0) return;
    // Pairs at rest are closer than the voxels can tell: they hold the point where it is.
    out.pairs.push_back({part.joint, rests ? newest : earlier, view.to_world * newest, 1});
  };
  const VoxelRays newest_rays = voxels_of(part.cube, part.newest);
  HitCount all = part.earlier_count[0];
  all.add(newest_rays);
  const HitVoxels newest_hits(part.cube, newest_rays, all);
  for (std::size_t s = 0; s < part.earlier.size(); ++s) {
    const HitVoxels earlier_hits(part.cube, part.earlier_rays[s], all);
    pair_up(part, part.newest, newest_rays, earlier_hits, stride,
            [&](const auto& pair, const Vec3& from, const Vec3& to) { add(pair, to, from); });
    pair_up(part, part.earlier[s], part.earlier_rays[s], newest_hits, stride,
            [&](const auto& pair, const Vec3& from, const Vec3& to) { add(pair, from, to); });
  }
  return out;
}

Matches match(const std::vector<PartRays>& parts, int stride, int threads) {
  std::vector<PartMatches> each(parts.size());
  at_once(int(parts.size()), threads, [&](int p) { each[p] = match_part(parts[p], stride); });
  Matches out;
  double sum = 0, count = 0;
  for (const PartMatches& part : each) {
    out.pairs.insert(out.pairs.end(), part.pairs.begin(), part.pairs.end());
    sum += part.sum;
    count += part.count;
  }
  out.energy = count ? sum / count : 0;
  return out;
}

void pose_newest(std::vector<PartRays>& parts, const Skeleton& skeleton, const Pose& pose) {
  const std::vector<Transform> to_world = skinning_transforms(skeleton, pose);
  for (PartRays& part : parts) part.newest.view.to_world = to_world[part.joint];
}

// A document of one drawn joint that is the root needs no skeleton: the rigid motion that brings
// its points onto the rays has a closed form (Procrustes; Umeyama 1991).
Pose procrustes(const Skeleton& skeleton, const Pose& user, const std::vector<PointPair>& pairs,
                const EulerLimits& limits) {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  double weight = 0;
  for (const PointPair& pair : pairs) {
    from += pair.weight * pair.rest;
    to += pair.weight * pair.world;
    weight += pair.weight;
  }
  from /= weight;
  to /= weight;
  Mat3 covariance = Mat3::Zero();
  for (const PointPair& pair : pairs)
    covariance += pair.weight * (pair.world - to) * (pair.rest - from).transpose();
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 flip = Mat3::Identity();
  flip(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  Pose pose = user;
  const Mat3 R = svd.matrixU() * flip * svd.matrixV().transpose();
  if (limits.free[0]) pose.rotations[0] = Quat(R).normalized();
  pose.root_position = to + pose.rotations[0] * (skeleton.joints[0].offset - from);
  return within_limits(user, pose, limits);
}

// The dolly: the root's place along the view axis, which the pairs determine poorly in perspective
// (moving away looks like shrinking). Golden-section search over the pairs' energy.
Pose dollied(const Document& document, std::vector<PartRays>& parts, const Pose& user,
             const Pose& pose, const EulerLimits& limits, double span, int threads) {
  const auto moved = [&](double z) {
    Pose p = pose;
    p.root_position.z() += z;
    return within_limits(user, p, limits);
  };
  const auto energy = [&](double z) {
    pose_newest(parts, document.skeleton, moved(z));
    return match(parts, 3, threads).energy;
  };
  constexpr int kSteps = 7;
  const Minimum best = golden_section(-span, span, kSteps, energy);
  return best.value < energy(0) ? moved(best.at) : pose;
}

struct Refined {
  Pose pose;
  double before = 0, after = 0;
  int iterations = 0;
};

// Refines frame `newest` against all frames before it. document holds the poses found so far.
Result<Refined> refine(const Document& document, int newest, const Pose& user,
                       const EulerLimits& limits, Run& run) {
  Refined out{document.frames[newest].pose, 0, 0, 0};
  double best_energy = std::numeric_limits<double>::infinity();
  Pose best = out.pose;
  double span = 0;
  for (int level = 0; level < kLevels; ++level) {
    const int side = kVoxels[level];
    std::vector<PartRays> parts = shared_parts(document, newest, side);
    if (parts.empty()) return out;
    double cube = 0;
    for (const PartRays& part : parts) cube = std::max(cube, part.cube.cell * side);
    const bool single = parts.size() == 1 && parts[0].joint == 0;
    // The finest voxels would tell no more of the depth, at a dozen times the cost.
    const bool searching = document.camera.type == Camera::Type::perspective && level + 1 < kLevels;
    span = level == 0 ? cube / 4 : span / 2;
    // Energies of two resolutions don't compare: each starts anew from the coarser one's best.
    Pose pose = best;
    best_energy = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kIterations; ++i) {
      if (run.cancelled()) return cancelled();
      pose_newest(parts, document.skeleton, pose);
      const Matches matches = match(parts, 1, run.threads);
      if (level == 0 && i == 0) out.before = matches.energy;
      if (matches.energy < best_energy) {
        best_energy = matches.energy;
        best = pose;
      }
      if (i == kIterations || matches.pairs.empty()) break;
      const Pose next = single ? procrustes(document.skeleton, user, matches.pairs, limits)
                               : solve_pose(document.skeleton, user, pose, matches.pairs, limits);
      double change = (next.root_position - pose.root_position).norm() / cube;
      for (std::size_t j = 0; j < next.rotations.size(); ++j)
        change = std::max(change, next.rotations[j].angularDistance(pose.rotations[j]));
      pose = next;
      ++out.iterations;
      if (searching && i % kDollyEvery == kDollyEvery - 1) {
        pose = dollied(document, parts, user, pose, limits, span, run.threads);
        span *= 0.8;
      } else if (!searching && change < kSettled) {
        break;
      }
      run.report((level + double(i + 1) / kIterations) / kLevels);
    }
  }
  out.pose = best;
  out.after = best_energy;
  return out;
}

}  // namespace

Result<Calibration> calibrate_paper(const Document& document, Run& run) {
  Calibration out;
  if (document.calibration.scale)
    out.warnings.push_back(
        "the paper's method finds no drawing's scale: those given stay; --method rays finds them");
  Document found = document;
  const PoseLimits allowed = pose_limits(document);
  const EulerLimits limits{allowed.max_rotation, allowed.max_translation, allowed.free};
  const double from = run.from, to = run.to;
  const int frames = int(document.frames.size());
  for (int f = 1; f < frames; ++f) {
    run.now.item = document.frames[f].name;
    run.now.part = f;
    run.now.parts = frames;
    run.from = from + (to - from) * (f - 1) / (frames - 1);
    run.to = from + (to - from) * f / (frames - 1);
    const Result<Refined> refined = refine(found, f, document.frames[f].pose, limits, run);
    if (!refined) return refined.error();
    found.frames[f].pose = refined->pose;
    out.energy_before += refined->before;
    out.energy_after += refined->after;
    out.iterations += refined->iterations;
  }
  run.from = from;
  run.to = to;
  for (const Frame& frame : found.frames) {
    out.poses.push_back(frame.pose);
    out.scales.push_back(frame.scale);
  }
  return out;
}

}  // namespace artisketch

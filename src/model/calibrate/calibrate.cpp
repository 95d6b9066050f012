#include "model/calibrate/calibrate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/blocking.h"
#include "model/calibrate/calibration_words.h"
#include "model/calibrate/ray_residuals.h"
#include "model/one_order.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

constexpr double kMaxRotation = radians(40);  // users' poses are 8 to 15° off, bad ones 30
constexpr double kMaxTranslation = 0.25;      // of the rest pose's size

}  // namespace

PoseLimits pose_limits(const Document& document) {
  PoseLimits limits;
  limits.max_rotation = document.calibration.max_rotation.value_or(kMaxRotation);
  Box3 box;
  for (const Vec3& p : rest_positions(document.skeleton)) box.extend(p);
  limits.max_translation = document.calibration.max_translation.value_or(
      kMaxTranslation * std::max(box.diagonal().norm(), 1e-3));
  limits.free.assign(document.skeleton.size(), 0);
  for (const int joint : drawn_joints(document)) limits.free[joint] = 1;
  for (const int joint : document.calibration.locked) limits.free[joint] = 0;
  return limits;
}

std::vector<std::vector<char>> shared_contours(const Document& document) {
  const int joints = document.skeleton.size();
  std::vector<std::vector<char>> shared(document.frames.size(), std::vector<char>(joints, 0));
  std::vector<int> frames_of(joints, 0);
  for (std::size_t f = 0; f < document.frames.size(); ++f)
    for (const Contour& contour : document.frames[f].contours)
      if (contour.line.closed && !shared[f][contour.joint]) {
        shared[f][contour.joint] = 1;
        ++frames_of[contour.joint];
      }
  for (std::vector<char>& frame : shared)
    for (int j = 0; j < joints; ++j)
      if (frames_of[j] < 2) frame[j] = 0;
  return shared;
}

double calibration_scale(const Document& document) {
  return std::max(1.0, shape_scale(document) / 2);
}

std::vector<int> ends_of_bones(const Document& document, int joint) {
  std::vector<int> ends = document.skeleton.children(joint);
  std::erase_if(ends, [&](int child) { return role_of(document, child) != Role::body; });
  return ends;
}

Vec3 middle_of_bones(const Document& document, int joint) {
  const std::vector<int> children = ends_of_bones(document, joint);
  Vec3 sum = Vec3::Zero();
  for (const int child : children) sum += document.skeleton.joints[child].offset / 2;
  return children.empty() ? sum : Vec3(sum / double(children.size()));
}

std::vector<Coverage> coverage(const Document& document, const RayResiduals& rays,
                               std::span<const Pose> poses, std::span<const double> scales) {
  const Placement placement = placed(document, poses, scales);
  std::map<std::pair<int, int>, Coverage> all;
  for (int f = 0; f < int(document.frames.size()); ++f)
    for (const Contour& contour : document.frames[f].contours)
      if (contour.line.closed) all[{contour.joint, f}] = {contour.joint, f, 1, 0};
  for (const RayResiduals::Part& part : rays.parts()) {
    const std::vector<std::vector<double>> misses = rays.misses(part, placement);
    for (std::size_t v = 0; v < misses.size(); ++v) {
      double met = 0, sum = 0;
      for (const double squared : misses[v]) {
        met += squared <= kTouch * kTouch;
        sum += squared;
      }
      if (misses[v].empty()) continue;  // no rays: nothing speaks against it
      Coverage& one = all[{part.joint, part.views[v].frame}];
      one.share = met / double(misses[v].size());
      one.miss = std::sqrt(sum / double(misses[v].size()));
    }
  }
  std::vector<Coverage> list;
  for (const auto& [key, one] : all) list.push_back(one);
  return list;
}

double mean_share(std::span<const Coverage> all) {
  double sum = 0;
  for (const Coverage& one : all) sum += one.share;
  return all.empty() ? 1 : sum / double(all.size());
}

namespace {

Calibration unmoved(const Document& document) {
  Calibration result;
  for (const Frame& frame : document.frames) {
    result.poses.push_back(frame.pose);
    result.scales.push_back(frame.scale);
  }
  return result;
}

// Why there is nothing to calibrate, or nothing.
std::string nothing_to_compare(const Document& document) {
  if (document.frames.size() < 2)
    return "one frame alone: there is nothing to calibrate its pose against";
  for (const std::vector<char>& frame : shared_contours(document))
    for (const char shared : frame)
      if (shared) return "";
  return "no joint has closed contours in two frames: there is nothing to calibrate poses by";
}

// What a method is asked for are poses and scales alone: comparing, refusing what is worse, and
// explaining are the same for all.
Result<Calibration> calibrate_by(Method method, const Document& document, Run& run) {
  switch (method) {
    case Method::paper:
      return calibrate_paper(document, run);
    case Method::rays:
      return calibrate_rays(document, run);
  }
  return calibrate_rays(document, run);
}

// Of a document whose outlines and joints are in one order, drawn `scale` times as large as given.
Result<Calibration> calibrate_ordered(const Document& document, const CalibrateOptions& options,
                                      double scale, Run& run) {
  Calibration result = unmoved(document);
  const RayResiduals rays = rays_to_compare(document);
  const std::vector<Coverage> before = coverage(document, rays, result.poses, result.scales);
  std::vector<Coverage> after = before;
  if (const std::string why = nothing_to_compare(document); !why.empty()) {
    result.warnings.push_back(why);
  } else {
    Result<Calibration> found = calibrate_by(options.method, document, run);
    if (!found) return found.error();
    after = coverage(document, rays, found->poses, found->scales);
    if (mean_share(after) < mean_share(before)) {
      // Least energy need not be most agreement where drawings contradict each other.
      found->poses = std::move(result.poses);
      found->scales = std::move(result.scales);
      found->energy_after = found->energy_before;
      after = before;
      found->warnings.push_back(
          "no poses were found that the drawings agree with better than with "
          "yours: they stay");
    }
    result = std::move(*found);
    explain(document, rays, after, scale, result);
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    result.coverage.push_back({before[i].joint, before[i].frame, before[i].share, after[i].share});
  return result;
}

}  // namespace

Result<Calibration> calibrate(const Document& document, const CalibrateOptions& options, Run& run) {
  fix_blocking();
  const std::vector<int> order = joints_in_one_order(document.skeleton);
  const Document drawn = with_shaping_contours(document);
  const double scale = calibration_scale(drawn);
  Result<Calibration> found = calibrate_ordered(
      in_one_order(with_joints_in(scaled(drawn, scale), order)), options, scale, run);
  if (!found) return found.error();
  return with_joints_in(std::move(*found), inverse(order));
}

}  // namespace artisketch

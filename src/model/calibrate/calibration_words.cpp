#include "model/calibrate/calibration_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include <Eigen/Geometry>

#include "base/words.h"
#include "document/place_words.h"
#include "model/calibrate/drawn_size.h"

namespace artisketch {
namespace {

// A limit counts as reached within a thousandth.
constexpr double kReached = 0.999;
// A part cannot agree where less than this share of its contour's rays meet its hull and they miss
// it by more than this many of the drawing's pixels.
constexpr double kDisagreeingShare = 0.8, kDisagreeingMiss = 3;
constexpr double kSameSide = 0.17;    // sine of the angle between views that show the same side
constexpr double kOtherLength = 0.1;  // relative difference of lengths that is worth saying
// An angle is open where an error of 10° costs less than the noise of a drawing does: a pixel's
// deviation all along a stretch of contour this long.
constexpr double kOpenAngle = radians(10);
constexpr double kNoise = 10;      // square pixels times pixels
constexpr double kEndOn = 0.95;    // cosine: a bone that points at the camera
constexpr double kOffJoint = 0.2;  // of a leaf's radius: its middle shows where it points

std::string quoted(const Document& document, int joint) {
  return "'" + document.skeleton.joints[joint].name + "'";
}

std::string rounded(double value) {
  return std::to_string(std::lround(value));
}

// ---------------------------------------------------------------- changes and limits

void measure_changes(const Document& document, Calibration& result) {
  const PoseLimits limits = pose_limits(document);
  for (int f = 0; f < int(document.frames.size()); ++f) {
    const Pose& user = document.frames[f].pose;
    const Pose& found = result.poses[f];
    std::string reached;
    for (int j = 0; j < document.skeleton.size(); ++j) {
      const double angle = user.rotations[j].angularDistance(found.rotations[j]);
      if (angle > result.largest_rotation) {
        result.largest_rotation = angle;
        result.largest_rotation_joint = j;
      }
      if (angle > 0 && angle >= kReached * limits.max_rotation)
        reached += (reached.empty() ? "" : ", ") + quoted(document, j);
    }
    const double shift = (found.root_position - user.root_position).norm();
    result.largest_translation = std::max(result.largest_translation, shift);
    if (!reached.empty())
      result.warnings.push_back(frame_words(document, f) + ": " + reached + " turned as far as " +
                                "calibration.max_rotation allows (" +
                                rounded(degrees(limits.max_rotation)) +
                                "°): pose it nearer to the drawing, or allow more");
    if (shift > 0 && shift >= kReached * limits.max_translation)
      result.warnings.push_back(frame_words(document, f) + ": the root moved as far as " +
                                "calibration.max_translation allows: place the figure nearer to " +
                                "the drawing, or allow more");
  }
}

// At the artist's poses: calibration tips bodies away to explain what differs in size.
void name_sizes(const Document& document, const RayResiduals& rays, Calibration& result) {
  std::vector<Pose> poses;
  for (const Frame& frame : document.frames) poses.push_back(frame.pose);
  const std::vector<DrawnSize> sizes = drawn_sizes(rays, placed(document, poses, result.scales));
  for (std::string& line : drawn_size_words(document, sizes, result.scales))
    result.warnings.push_back(std::move(line));
}

// ---------------------------------------------------------------- drawings that cannot agree

// Extent of a part's contour along an axis through its middle, both in the joint's axes, in units.
std::pair<double, double> extent(const RayResiduals::Part& part, const RayResiduals::View& view,
                                 const Placement& placement, const Vec3& axis) {
  const Transform to_part = placement.posed[view.frame][part.joint].inverse();
  const FrameCamera& camera = placement.cameras[view.frame];
  const Vec3 middle = to_part.inverse() * part.middle(placement);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2& p : view.points) {
    const Ray ray = camera.ray(p);
    const Vec3 X = to_part * ray.at((middle - ray.origin).dot(ray.direction));
    low = std::min(low, axis.dot(X));
    high = std::max(high, axis.dot(X));
  }
  return {low, high};
}

Vec3 direction_of(const RayResiduals::Part& part, const RayResiduals::View& view,
                  const Placement& placement) {
  const Transform& to_world = placement.posed[view.frame][part.joint];
  return to_world.linear().transpose() * placement.cameras[view.frame].ray(view.centroid).direction;
}

// Two views of a part share one axis, across both directions: along it they must show it alike.
// The words for the frame in which a part differs most from the one given.
std::string differing_most(const Document& document, const RayResiduals::Part& part,
                           const RayResiduals::View& view, const Placement& placement,
                           double scale) {
  double most = 0;
  std::string words;
  const Vec3 d = direction_of(part, view, placement);
  for (const RayResiduals::View& other : part.views) {
    const Vec3 axis = d.cross(direction_of(part, other, placement));
    if (other.frame == view.frame || axis.norm() < kSameSide) continue;
    const auto [low, high] = extent(part, view, placement, axis.normalized());
    const auto [other_low, other_high] = extent(part, other, placement, axis.normalized());
    const double off = std::max(std::abs(low - other_low), std::abs(high - other_high));
    if (off <= most) continue;
    most = off;
    const double length = high - low, other_length = other_high - other_low;
    const double differ = std::abs(length - other_length) / std::max(length, other_length);
    const Vec3 middle = placement.posed[view.frame][part.joint] * part.middle(placement);
    words = " cannot agree with " + frame_words(document, other.frame) + ": its contours " +
            (differ > kOtherLength
                 ? "differ by " + rounded(100 * differ) + " % in length"
                 : "stand " +
                       rounded(off * placement.cameras[view.frame].pixels_per_unit(middle.z()) /
                               scale) +
                       " px apart") +
            "; redraw one of them, or check the joint's poses";
  }
  return words;
}

void name_contradictions(const Document& document, const RayResiduals& rays,
                         std::span<const Coverage> after, double scale, Calibration& result) {
  const Placement placement = placed(document, result.poses, result.scales);
  for (const RayResiduals::Part& part : rays.parts()) {
    // One line per part: where it misses most.
    const RayResiduals::View* worst = nullptr;
    double most = kDisagreeingMiss * rays.unit();
    for (const Coverage& one : after)
      for (const RayResiduals::View& view : part.views)
        if (one.joint == part.joint && one.frame == view.frame && one.share < kDisagreeingShare &&
            one.miss > most) {
          worst = &view;
          most = one.miss;
        }
    if (!worst) continue;
    const std::string words = differing_most(document, part, *worst, placement, scale);
    result.warnings.push_back(
        frame_words(document, worst->frame) + ": " + quoted(document, part.joint) +
        (words.empty() ? " cannot agree with the other frames: its contour misses them by " +
                             rounded(most / scale) + " px; redraw it, or check the joint's poses"
                       : words));
  }
}

// ---------------------------------------------------------------- angles left open

enum class Turn { twist, swing, plane };

// The axes that a part may turn about, in the joint's axes, by what a person sees of them: about
// its bone, in the picture, toward the camera. A bone that points at the camera, or no bone, leaves
// fewer kinds.
std::vector<std::pair<Turn, Vec3>> turns_of(const Vec3& bone, const Vec3& to_camera) {
  const double along = bone.isZero(0) ? 1 : std::abs(bone.normalized().dot(to_camera));
  const Vec3 across =
      along < kEndOn ? bone.cross(to_camera).normalized() : to_camera.unitOrthogonal();
  std::vector<std::pair<Turn, Vec3>> turns = {{Turn::swing, across}};
  if (along < kEndOn) {
    turns.push_back({Turn::twist, bone.normalized()});
    turns.push_back({Turn::plane, across.cross(bone).normalized()});
  } else {
    turns.push_back({Turn::swing, across.cross(to_camera)});
    turns.push_back({bone.isZero(0) ? Turn::plane : Turn::twist, to_camera});
  }
  return turns;
}

std::string listed(const std::set<int>& numbers) {
  std::string words;
  for (const int n : numbers) words += (words.empty() ? "" : ", ") + std::to_string(n);
  return words;
}

// Small eigenvalues of the normal matrix would tell open angles, too, but not all of them: a round
// part's rays slide along its outline as it turns, which no first derivative shows. So each angle
// is tried.
void name_open_angles(const Document& document, const RayResiduals& rays, Calibration& result) {
  const RayResiduals few = rays.thinned();
  Placement placement = placed(document, result.poses, result.scales);
  const double noise = kNoise * rays.unit() * rays.unit();
  std::map<std::pair<int, Turn>, std::set<int>> open;  // frames by joint and kind
  for (const RayResiduals::Part& part : few.parts()) {
    const bool locked = std::count(document.calibration.locked.begin(),
                                   document.calibration.locked.end(), part.joint) > 0;
    if (locked) continue;
    const Vec3 middle = part.middle(placement);
    Vec3 bone = part.bone;
    if (bone.isZero(0) && middle.norm() > kOffJoint * part.radius) bone = middle;
    const double cost = few.cost(part, placement, std::numeric_limits<double>::infinity());
    for (const RayResiduals::View& view : part.views) {
      if (view.frame == 0 && !document.calibration.free_first_frame) continue;
      Transform& posed = placement.posed[view.frame][part.joint];
      const Transform found = posed;
      for (const auto& [kind, axis] : turns_of(bone, -direction_of(part, view, placement)))
        for (const double angle : {kOpenAngle, -kOpenAngle}) {
          posed = found * Eigen::AngleAxisd(angle, axis);
          const bool cheap = few.cost(part, placement, cost + noise) < cost + noise;
          posed = found;
          if (!cheap) continue;
          open[{part.joint, kind}].insert(view.frame + 1);
          break;
        }
    }
  }
  for (const auto& [key, frames] : open) {
    const std::string of = " of " + quoted(document, key.first);
    result.undetermined.push_back((key.second == Turn::twist ? "twist" + of + " about its bone"
                                   : key.second == Turn::swing
                                       ? "swing" + of + " toward the camera or away"
                                       : "turn" + of + " in the picture") +
                                  ", " + plural(frames.size(), "frame") + " " + listed(frames));
  }
}

}  // namespace

void explain(const Document& document, const RayResiduals& rays, std::span<const Coverage> after,
             double scale, Calibration& result) {
  measure_changes(document, result);
  name_sizes(document, rays, result);
  name_contradictions(document, rays, after, scale, result);
  name_open_angles(document, rays, result);
}

}  // namespace artisketch

#include "model/calibration_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <Eigen/Eigenvalues>

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
constexpr double kNoise = 10;  // square pixels times pixels
constexpr double kInset = 1;   // pixels: rays that just touch the hull count, too

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

// ---------------------------------------------------------------- drawings that cannot agree

// Extent of a part's contour along an axis through its middle, both in the joint's axes, in units.
std::pair<double, double> extent(const RayResiduals::Part& part, const RayResiduals::View& view,
                                 const Placement& placement, const Vec3& axis) {
  const Transform to_part = placement.posed[view.frame][part.joint].inverse();
  const FrameCamera& camera = placement.cameras[view.frame];
  const Vec3 middle = to_part.inverse() * part.middle;
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
                           const RayResiduals::View& view, const Placement& placement) {
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
    const Vec3 middle = placement.posed[view.frame][part.joint] * part.middle;
    words =
        " cannot agree with " + frame_words(document, other.frame) + ": its contours " +
        (differ > kOtherLength
             ? "differ by " + rounded(100 * differ) + " % in length"
             : "stand " + rounded(off * placement.cameras[view.frame].pixels_per_unit(middle.z())) +
                   " px apart") +
        "; redraw one of them, or check the joint's poses";
  }
  return words;
}

void name_contradictions(const Document& document, const RayResiduals& rays,
                         std::span<const Coverage> after, Calibration& result) {
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
    const std::string words = differing_most(document, part, *worst, placement);
    result.warnings.push_back(
        frame_words(document, worst->frame) + ": " + quoted(document, part.joint) +
        (words.empty() ? " cannot agree with the other frames: its contour misses them by " +
                             rounded(most) + " px; redraw it, or check the joint's poses"
                       : words));
  }
}

// ---------------------------------------------------------------- angles left open

enum class Turn { twist, swing, plane };

Turn kind_of(const Vec3& axis, const Vec3& along_bone, const Vec3& to_camera) {
  const double twist = std::abs(axis.dot(along_bone)), plane = std::abs(axis.dot(to_camera));
  if (twist > 0.7 && twist >= plane) return Turn::twist;
  return plane > 0.7 ? Turn::plane : Turn::swing;
}

void name_open_angles(const Document& document, const RayResiduals& rays, Calibration& result) {
  // The system at the poses found; a frame's joint may turn where its own contour is compared.
  Document found = with_poses(document, result);
  PoseFreedom freedom;
  freedom.joint = shared_contours(document);
  for (std::size_t f = 0; f < found.frames.size(); ++f)
    freedom.frame.push_back(f > 0 || document.calibration.free_first_frame);
  PoseSystem system(found, freedom);
  const Placement placement = placed(found, result.poses, result.scales);
  std::vector<std::pair<int, MotionSystem>> parts;
  rays.evaluate(placement, {0, kInset}, &parts);
  system.assemble(no_change(found), parts);

  std::map<std::pair<int, Turn>, std::string> open;  // frames by joint and kind
  for (const RayResiduals::Part& part : rays.parts()) {
    const bool locked = std::count(document.calibration.locked.begin(),
                                   document.calibration.locked.end(), part.joint) > 0;
    Vec3 bone = middle_of_bones(document.skeleton, part.joint);
    if (bone.isZero(0)) bone = part.middle;
    for (const RayResiduals::View& view : part.views) {
      if (locked || !freedom.frame[view.frame]) continue;
      const Eigen::SelfAdjointEigenSolver<Mat3> eigen(
          system.rotation_block(part.joint, view.frame));
      for (int i = 0; i < 3; ++i) {
        if (eigen.eigenvalues()[i] * kOpenAngle * kOpenAngle > kNoise) continue;
        const Turn kind = kind_of(eigen.eigenvectors().col(i), bone.normalized(),
                                  -direction_of(part, view, placement));
        std::string& frames = open[{part.joint, kind}];
        const std::string number = std::to_string(view.frame + 1);
        if (frames.empty())
          frames = number;
        else if (frames.substr(frames.find_last_of(' ') + 1) != number)
          frames += ", " + number;
      }
    }
  }
  for (const auto& [key, frames] : open) {
    const std::string of = " of " + quoted(document, key.first);
    result.undetermined.push_back(
        (key.second == Turn::twist   ? "twist" + of + " about its bone"
         : key.second == Turn::swing ? "swing" + of + " toward the camera or away"
                                     : "turn" + of + " in the picture") +
        (frames.find(',') == std::string::npos ? ", frame " : ", frames ") + frames);
  }
}

}  // namespace

std::string frame_words(const Document& document, int frame) {
  return "frame " + std::to_string(frame + 1) + " '" + document.frames[frame].name + "'";
}

void explain(const Document& document, const RayResiduals& rays, std::span<const Coverage> after,
             Calibration& result) {
  measure_changes(document, result);
  name_contradictions(document, rays, after, result);
  name_open_angles(document, rays, result);
}

}  // namespace artisketch

#include "figures/posed_by_hand.h"

#include <algorithm>
#include <cmath>

#include "document/camera.h"
#include "figures/random.h"

namespace artisketch::figures {
namespace {

// The world displacement that a camera sees as `seen` pixels, of a given length, on the side of the
// picture that z says.
Vec3 leaning(const Vec2& seen, double pixels_per_unit, double length, double z) {
  Vec3 d(seen.x() / pixels_per_unit, -seen.y() / pixels_per_unit, 0);
  const double across = d.norm();
  if (across >= length) return d * (length / across);
  d.z() = std::copysign(std::sqrt(length * length - across * across), z);
  return d;
}

Pose posed(const Document& truth, const Skeleton& skeleton, int f, const Hand& hand,
           Random& random) {
  const FrameCamera camera = frame_camera(truth, f);
  const std::vector<Transform> seen = posed_joints(truth.skeleton, truth.frames[f].pose);
  std::vector<Vec2> places;
  for (const Transform& joint : seen)
    places.push_back(camera.project(joint.translation()) +
                     hand.place_error_px * Vec2(random.gaussian(), random.gaussian()));
  Pose pose = truth.frames[f].pose;
  std::vector<Vec3> at(skeleton.size(), pose.root_position);
  std::vector<Quat> world(skeleton.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    if (parent >= 0) at[j] = at[parent] + world[parent] * skeleton.joints[j].offset;
    world[j] = Quat(seen[j].linear());
    const std::vector<int> children = skeleton.children(j);
    if (!children.empty()) {
      const int end = children.front();
      const Vec3 bone = world[j] * skeleton.joints[end].offset;
      const Vec3 now = leaning(places[end] - camera.project(at[j]),
                               camera.pixels_per_unit(at[j].z()), bone.norm(), bone.z());
      const double twist = f == 0 ? 0 : (random.chance(0.5) ? 1 : -1) * hand.twist_degrees;
      world[j] = Quat(Eigen::AngleAxisd(radians(twist), now.normalized())) *
                 Quat::FromTwoVectors(bone, now) * world[j];
    }
    pose.rotations[j] =
        (parent >= 0 ? world[parent].conjugate() * world[j] : world[j]).normalized();
  }
  return pose;
}

}  // namespace

Document posed_by_hand(const Document& truth, const Hand& hand, std::uint64_t seed) {
  Random random(seed * 2 + 2);
  Document given = truth;
  for (Joint& joint : given.skeleton.joints)
    joint.offset *= 1 + random.between(-hand.bone_error, hand.bone_error);
  for (int f = 0; f < int(given.frames.size()); ++f)
    given.frames[f].pose = posed(truth, given.skeleton, f, hand, random);
  given.calibration = {};  // nobody tells how far the poses are off
  return given;
}

}  // namespace artisketch::figures

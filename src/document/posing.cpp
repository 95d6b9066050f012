#include "document/posing.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace artisketch {
namespace {

constexpr double kNoLength = 1e-9;

// Turns posed joint `pivot` in the world by `turn`; its local rotation takes it up.
void turn_in_world(const Skeleton& skeleton, Pose& pose, int pivot, const Quat& turn) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  const int parent = skeleton.joints[pivot].parent;
  const Quat above = parent >= 0 ? Quat(posed[parent].rotation()) : Quat::Identity();
  pose.rotations[pivot] = (above.conjugate() * turn * Quat(posed[pivot].rotation())).normalized();
}

Vec3 place_of(const Skeleton& skeleton, const Pose& pose, int joint) {
  return posed_joints(skeleton, pose)[joint].translation();
}

// The bone that ends in `joint` points to `target` by the least turn.
void aim(const Skeleton& skeleton, Pose& pose, int joint, const Vec3& target) {
  const int pivot = skeleton.joints[joint].parent;
  const Vec3 start = place_of(skeleton, pose, pivot);
  const Vec3 from = place_of(skeleton, pose, joint) - start, to = target - start;
  if (from.norm() < kNoLength || to.norm() < kNoLength) return;
  turn_in_world(skeleton, pose, pivot, least_turn(from, to));
}

// The point of the ray that is within `reach` of the centre and nearest to the depth z: the
// nearest one to the centre, drawn in to the reach, where the ray passes it by.
Vec3 within_reach(const Ray& ray, const Vec3& centre, double reach, double z) {
  const double middle = (centre - ray.origin).dot(ray.direction);
  const Vec3 nearest = ray.at(middle);
  const double off = (nearest - centre).norm();
  if (off >= reach) return centre + (reach / off) * (nearest - centre);
  const double half = std::sqrt(reach * reach - off * off);
  return ray.at(std::clamp(ray.depth_at(z), middle - half, middle + half));
}

// Where the ray meets the sphere, on the side where `behind` says; as within_reach where it passes.
Vec3 on_sphere(const Ray& ray, const Vec3& centre, double radius, bool behind) {
  const double far = behind ? -1e9 : 1e9;  // the ray's point nearest to it lies on the sphere
  return within_reach(ray, centre, radius, centre.z() + far * radius);
}

}  // namespace

int start_of_bone(const Skeleton& skeleton, int joint) {
  const int parent = skeleton.joints[joint].parent;
  return skeleton.children(joint).empty() && parent >= 0 ? parent : joint;
}

int end_of_bone(const Skeleton& skeleton, int joint) {
  const std::vector<int> children = skeleton.children(joint);
  return children.empty() ? joint : children[0];
}

namespace {

// Bones above the joint up to where the body branches: that one carries more than the limb.
int bones_above(const Skeleton& skeleton, int joint) {
  int bones = 0;
  for (int j = skeleton.joints[joint].parent; j >= 0 && skeleton.children(j).size() < 2;
       j = skeleton.joints[j].parent)
    ++bones;
  return bones;
}

bool ends_limb(const Skeleton& skeleton, int joint) {
  if (bones_above(skeleton, joint) < 2) return false;
  const std::vector<int> children = skeleton.children(joint);
  // The mark at the tip of a hand turns the hand alone.
  if (children.empty()) return !ends_limb(skeleton, skeleton.joints[joint].parent);
  return std::all_of(children.begin(), children.end(),
                     [&](int child) { return skeleton.children(child).empty(); });
}

}  // namespace

int bones_dragged(const Skeleton& skeleton, int joint) {
  if (skeleton.joints[joint].parent < 0) return 0;
  return ends_limb(skeleton, joint) ? 2 : 1;
}

Pose with_joint_at(const Skeleton& skeleton, const Pose& pose, int joint, const Vec3& target,
                   int bones) {
  Pose next = pose;
  const int parent = skeleton.joints[joint].parent;
  if (parent < 0) {
    next.root_position = target;
    return next;
  }
  const int above = skeleton.joints[parent].parent;
  if (bones >= 2 && above >= 0) {
    const std::vector<Transform> posed = posed_joints(skeleton, pose);
    const Vec3 start = posed[above].translation(), middle = posed[parent].translation(),
               end = posed[joint].translation();
    const double a = (middle - start).norm(), b = (end - middle).norm();
    const Vec3 whole = target - start;
    const double c = std::clamp(whole.norm(), std::abs(a - b), a + b);
    if (a > kNoLength && b > kNoLength && c > kNoLength && whole.norm() > kNoLength) {
      // The middle lies on a circle about the line to the target: its point nearest to where the
      // middle is now. A straight limb bends away from the target's turn, within the paper.
      const Vec3 along = whole.normalized();
      const double foot = (a * a - b * b + c * c) / (2 * c);
      Vec3 side = (middle - start) - (middle - start).dot(along) * along;
      if (side.norm() < 1e-6 * a) side = along.cross(Vec3::UnitZ());
      if (side.norm() < 1e-6) side = along.cross(Vec3::UnitX());
      const double height = std::sqrt(std::max(0.0, a * a - foot * foot));
      aim(skeleton, next, parent, start + foot * along + height * side.normalized());
    }
  }
  aim(skeleton, next, joint, target);
  return next;
}

Pose with_joint_dragged(const Skeleton& skeleton, const Pose& pose, const FrameCamera& camera,
                        int joint, const Vec2& pixel) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  const auto place = [&](int j) { return Vec3(posed[j].translation()); };
  const Ray ray = camera.ray(pixel);
  const int bones = bones_dragged(skeleton, joint);
  if (bones == 0) return with_joint_at(skeleton, pose, joint, ray.at_z(place(joint).z()), bones);
  const int parent = skeleton.joints[joint].parent;
  const double length = (place(joint) - place(parent)).norm();
  if (bones == 2) {
    const int above = skeleton.joints[parent].parent;
    const double reach = length + (place(parent) - place(above)).norm();
    const Vec3 target = within_reach(ray, place(above), reach, place(joint).z());
    return with_joint_at(skeleton, pose, joint, target, bones);
  }
  const bool behind = place(joint).z() < place(parent).z();
  Pose next =
      with_joint_at(skeleton, pose, joint, on_sphere(ray, place(parent), length, behind), bones);
  const std::vector<int> children = skeleton.children(joint);
  if (children.size() != 1 || bones_dragged(skeleton, children[0]) != 2) return next;
  const int end = children[0];
  const Vec3 middle = place_of(skeleton, next, joint);
  const Vec3 target = on_sphere(camera.ray(camera.project(place(end))), middle,
                                (place(end) - place(joint)).norm(), place(end).z() < middle.z());
  return with_joint_at(skeleton, next, end, target, 1);
}

Pose with_bone_toward(const Skeleton& skeleton, const Pose& pose, const FrameCamera& camera,
                      int joint, const Vec2& pixel) {
  const Vec3 end = place_of(skeleton, pose, joint),
             start = place_of(skeleton, pose, skeleton.joints[joint].parent);
  const Vec3 target =
      on_sphere(camera.ray(pixel), start, (end - start).norm(), end.z() < start.z());
  return with_joint_at(skeleton, pose, joint, target, 1);
}

Pose with_joint_depth(const Skeleton& skeleton, const Pose& pose, const FrameCamera& camera,
                      int joint, double z) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  const auto place = [&](int j) { return Vec3(posed[j].translation()); };
  const Ray ray = camera.ray(camera.project(place(joint)));
  const int bones = bones_dragged(skeleton, joint);
  if (bones == 0) return with_joint_at(skeleton, pose, joint, ray.at_z(z), bones);
  const int parent = skeleton.joints[joint].parent;
  const Vec3 bone = place(joint) - place(parent);
  if (bones == 2) {
    const Vec3 start = place(skeleton.joints[parent].parent);
    const double reach = bone.norm() + (place(parent) - start).norm();
    return with_joint_at(skeleton, pose, joint, within_reach(ray, start, reach, z), bones);
  }
  Vec2 across = bone.head<2>();
  if (across.norm() < 1e-6 * bone.norm()) across = Vec2(0, -1);  // it pointed straight at the eye
  const double depth = std::clamp(z - place(parent).z(), -bone.norm(), bone.norm());
  across = across.normalized() * std::sqrt(std::max(0.0, bone.squaredNorm() - depth * depth));
  return with_joint_at(skeleton, pose, joint, place(parent) + Vec3(across.x(), across.y(), depth),
                       bones);
}

namespace {

// The bone that ends at a joint, turned in the world as turn_of(bone) says;
// a bone without length stays.
template <class TurnOf>
Pose with_bone_turned(const Skeleton& skeleton, const Pose& pose, int joint,
                      const TurnOf& turn_of) {
  const int pivot = skeleton.joints[joint].parent;
  if (pivot < 0) return pose;
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  const Vec3 bone = posed[joint].translation() - posed[pivot].translation();
  Pose next = pose;
  if (bone.norm() > kNoLength) turn_in_world(skeleton, next, pivot, turn_of(bone));
  return next;
}

}  // namespace

Pose with_bone_flipped(const Skeleton& skeleton, const Pose& pose, int joint) {
  return with_bone_turned(skeleton, pose, joint, [](const Vec3& bone) {
    return least_turn(bone, Vec3(bone.x(), bone.y(), -bone.z()));
  });
}

Pose with_bone_twisted(const Skeleton& skeleton, const Pose& pose, int joint, double angle) {
  return with_bone_turned(skeleton, pose, joint, [angle](const Vec3& bone) {
    return Quat(Eigen::AngleAxisd(angle, bone.normalized()));
  });
}

Pose with_body_turned(Pose pose, const Quat& turn) {
  if (!pose.rotations.empty()) pose.rotations[0] = (turn * pose.rotations[0]).normalized();
  return pose;
}

Quat ball_turn(const Vec2& from, const Vec2& to, double radius) {
  const auto on_ball = [radius](const Vec2& p) {
    // A hyperbola goes on smoothly where the ball ends.
    const double square = p.squaredNorm(), half = radius * radius / 2;
    const double z = square <= half ? std::sqrt(radius * radius - square) : half / p.norm();
    return Vec3(p.x(), -p.y(), z).normalized();
  };
  return least_turn(on_ball(from), on_ball(to));
}

Document with_pose_copied(Document document, int from, int to) {
  document.frames.at(to).pose.rotations = document.frames.at(from).pose.rotations;
  document.frames[to].set_joints = document.frames[from].set_joints;
  document.frames[to].posed = true;
  return document;
}

bool is_locked(const Document& document, int joint) {
  const std::vector<int>& locked = document.calibration.locked;
  return std::find(locked.begin(), locked.end(), joint) != locked.end();
}

Document with_lock(Document document, int joint, bool locked) {
  std::erase(document.calibration.locked, joint);
  if (locked) document.calibration.locked.push_back(joint);
  std::sort(document.calibration.locked.begin(), document.calibration.locked.end());
  return document;
}

}  // namespace artisketch

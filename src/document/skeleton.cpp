#include "document/skeleton.h"

#include <algorithm>

#include "base/ensure.h"

namespace artisketch {

int Skeleton::find(std::string_view name) const {
  for (int j = 0; j < size(); ++j)
    if (joints[j].name == name) return j;
  return -1;
}

std::vector<int> Skeleton::children(int joint) const {
  std::vector<int> found;
  for (int j = joint + 1; j < size(); ++j)
    if (joints[j].parent == joint) found.push_back(j);
  return found;
}

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  pose.rotations.assign(skeleton.size(), Quat::Identity());
  if (skeleton.size()) pose.root_position = skeleton.joints[0].offset;
  return pose;
}

bool same_pose(const Pose& a, const Pose& b) {
  return a.root_position == b.root_position &&
         std::equal(a.rotations.begin(), a.rotations.end(), b.rotations.begin(), b.rotations.end(),
                    [](const Quat& p, const Quat& q) { return p.coeffs() == q.coeffs(); });
}

std::vector<Vec3> rest_positions(const Skeleton& skeleton) {
  std::vector<Vec3> positions;
  positions.reserve(skeleton.size());
  for (const Joint& joint : skeleton.joints)
    positions.push_back(joint.parent < 0 ? joint.offset : positions[joint.parent] + joint.offset);
  return positions;
}

std::vector<Transform> posed_joints(const Skeleton& skeleton, const Pose& pose) {
  ensure(int(pose.rotations.size()) == skeleton.size(), "a rotation for every joint");
  std::vector<Transform> posed(skeleton.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    Transform t = joint.parent < 0 ? Transform(Eigen::Translation3d(pose.root_position))
                                   : posed[joint.parent] * Eigen::Translation3d(joint.offset);
    t.linear() = t.linear() * pose.rotations[j].toRotationMatrix();
    posed[j] = t;
  }
  return posed;
}

std::vector<Transform> skinning_transforms(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Transform> transforms = posed_joints(skeleton, pose);
  const std::vector<Vec3> rest = rest_positions(skeleton);
  for (int j = 0; j < skeleton.size(); ++j)
    transforms[j] = transforms[j] * Eigen::Translation3d(-rest[j]);
  return transforms;
}

std::vector<Bone> bones(const Skeleton& skeleton) {
  const std::vector<Vec3> rest = rest_positions(skeleton);
  std::vector<Bone> found;
  for (int j = 0; j < skeleton.size(); ++j)
    if (const int parent = skeleton.joints[j].parent; parent >= 0)
      found.push_back({parent, j, rest[parent], rest[j]});
  return found;
}

}  // namespace artisketch

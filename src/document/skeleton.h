// Joints, poses and forward kinematics. Conventions: FORMAT.md, "Skeleton and poses".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"

namespace artisketch {

struct Joint {
  std::string name;
  int parent = -1;             // index of an earlier joint; −1 for the root
  Vec3 offset = Vec3::Zero();  // from the parent in the rest pose, in units
  int mirror = -1;             // the joint's mirror image, may be itself; −1: none
  std::string unknown;         // fields of the file that this version doesn't know, as JSON
};

struct Skeleton {
  std::vector<Joint> joints;  // parents before children; joints[0] is the root
  int size() const { return int(joints.size()); }
  int find(std::string_view name) const;  // −1 where there is none
  std::vector<int> children(int joint) const;
};

struct Pose {
  Vec3 root_position = Vec3::Zero();  // world, units
  std::vector<Quat> rotations;        // one per joint, local, unit length
  std::string unknown;
};

Pose rest_pose(const Skeleton& skeleton);

// Whether two poses are the same to the last bit; what a file said besides doesn't count.
bool same_pose(const Pose& a, const Pose& b);

// Rest-space position of every joint.
std::vector<Vec3> rest_positions(const Skeleton& skeleton);

// posed(j) of FORMAT.md: each joint's frame in the world.
std::vector<Transform> posed_joints(const Skeleton& skeleton, const Pose& pose);

// posed(j) · rest(j)⁻¹: takes rest-space points bound to joint j to where they stand in the pose.
std::vector<Transform> skinning_transforms(const Skeleton& skeleton, const Pose& pose);

// A bone: the rest-space segment from a joint to one of its children.
struct Bone {
  int joint;  // whose part moves with it
  int child;
  Vec3 a, b;  // rest positions of joint and child
};
std::vector<Bone> bones(const Skeleton& skeleton);

}  // namespace artisketch

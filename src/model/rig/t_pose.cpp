#include "model/rig/t_pose.h"

#include <optional>

#include "base/rotation.h"
#include "model/rig/body_plan.h"
#include "model/rig/rig_profile.h"

namespace artisketch {
namespace {

// Turns in the world of every joint in the T-pose; a joint without its own goes with its parent.
class TPose {
 public:
  explicit TPose(const Skeleton& skeleton)
      : skeleton_(skeleton),
        rest_(rest_positions(skeleton)),
        plan_(body_plan_of(skeleton, rest_, false)),
        own_(std::size_t(skeleton.size())) {
    for (int side = 0; side < 2; ++side) {
      const LimbJoints &arm = plan_.arms[std::size_t(side)], &leg = plan_.legs[std::size_t(side)];
      const Vec3 out = (side == 0 ? 1 : -1) * Vec3::UnitX();
      point(arm.upper, arm.lower, out);
      point(arm.lower, arm.end, out);
      point(leg.upper, leg.lower, -Vec3::UnitY());
      point(leg.lower, leg.end, -Vec3::UnitY());
      if (leg.upper >= 0 && leg.lower >= 0 && leg.end >= 0) own_[leg.end] = Quat::Identity();
    }
  }

  Pose pose() const {
    Pose pose = rest_pose(skeleton_);
    const std::vector<Quat> turns = world();
    for (int j = 0; j < skeleton_.size(); ++j) {
      const int parent = skeleton_.joints[j].parent;
      const Quat above = parent < 0 ? Quat(Quat::Identity()) : turns[parent];
      pose.rotations[j] = (above.conjugate() * turns[j]).normalized();
    }
    // Straight legs are longer: the hips rise until the feet are where they were.
    const std::vector<Transform> posed = posed_joints(skeleton_, pose);
    double sunk = 0;
    int feet = 0;
    for (const LimbJoints& leg : plan_.legs)
      if (leg.end >= 0) sunk += rest_[leg.end].y() - posed[leg.end].translation().y(), ++feet;
    if (feet > 0) pose.root_position.y() += sunk / feet;
    return pose;
  }

  std::vector<Quat> world() const {
    std::vector<Quat> turns;
    for (int j = 0; j < skeleton_.size(); ++j) {
      const int parent = skeleton_.joints[j].parent;
      turns.push_back(own_[j].value_or(parent < 0 ? Quat(Quat::Identity()) : turns[parent]));
    }
    return turns;
  }

 private:
  void point(int joint, int to, const Vec3& way) {
    if (joint < 0 || to < 0) return;
    const Vec3 bone = rest_[to] - rest_[joint];
    constexpr double kNothing = 1e-9;
    if (bone.norm() > kNothing) own_[joint] = least_turn(bone, way);
  }

  const Skeleton& skeleton_;
  const std::vector<Vec3> rest_;
  const BodyPlan plan_;
  std::vector<std::optional<Quat>> own_;
};

}  // namespace

Model t_posed(const Model& model) {
  const TPose wanted(model.skeleton);
  const Pose pose = wanted.pose();
  const std::vector<Quat> turns = wanted.world();
  Model posed = model;
  posed.mesh.V = posed_vertices(model.mesh.V, model.weights, model.skeleton, pose);
  const std::vector<Transform> at = posed_joints(model.skeleton, pose);
  for (int j = 0; j < model.skeleton.size(); ++j) {
    Joint& joint = posed.skeleton.joints[j];
    joint.offset = at[j].translation();
    if (joint.parent >= 0) joint.offset -= at[joint.parent].translation();
  }
  // A joint's turn in the world was against the old rest pose: what led to the new one comes off.
  for (Clip& clip : posed.clips)
    for (Pose& key : clip.poses)
      for (int j = 0; j < model.skeleton.size(); ++j) {
        const int parent = model.skeleton.joints[j].parent;
        const Quat above = parent < 0 ? Quat(Quat::Identity()) : turns[parent];
        key.rotations[j] = (above * key.rotations[j] * turns[j].conjugate()).normalized();
      }
  return posed;
}

Result<Model> for_engine(const Model& model, std::string_view profile) {
  Result<Model> rigged = with_rig(model, profile);
  if (!rigged || profile == "rigify") return rigged;
  return t_posed(*rigged);
}

}  // namespace artisketch

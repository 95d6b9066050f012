#include "model/rig/puppet.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "model/rig/feet.h"

namespace artisketch {

Puppet::Puppet(const Skeleton& skeleton)
    : skeleton_(skeleton),
      rest_(rest_positions(skeleton)),
      figure_(body_plan_of(skeleton, rest_, false)) {
  find_legs();
  const std::vector<int>& trunk = figure_.trunk;
  if (trunk.size() > 1) {
    const Vec3 way = rest_[figure_.chest >= 0 ? figure_.chest : trunk.back()] - rest_[trunk[0]];
    level_ = std::abs(way.y()) < 0.5 * way.norm();
  }
  for (const Leg& leg : legs_) reach_ += leg.reach / double(legs_.size());
  if (legs_.empty()) {
    Box3 box;
    for (const Vec3& p : rest_) box.extend(p);
    reach_ = box.sizes().maxCoeff() / 2;
  }
}

bool Puppet::has_wings() const {
  return has_arms() && joint_name(skeleton_.joints[figure_.arms[0].upper].name).word.find("wing") !=
                           std::string::npos;
}

void Puppet::add_leg(LimbJoints limb, bool left, int row) {
  if (limb.upper < 0 || limb.lower < 0) return;
  if (limb.end < 0) limb.end = only_child(limb.lower);
  if (limb.end < 0) return;
  Leg leg;
  leg.limb = limb;
  leg.left = left;
  leg.row = row;
  leg.reach =
      (rest_[limb.lower] - rest_[limb.upper]).norm() + (rest_[limb.end] - rest_[limb.lower]).norm();
  leg.height = rest_[limb.end].y() - ground();
  leg.stand = rest_[limb.end];
  // Legs that are drawn spread or crossed stand under the hips, many as they are.
  if (!many_) leg.stand.x() = rest_[limb.upper].x();
  legs_.push_back(leg);
}

// As many legs as there are thighs; front legs are arms where the trunk lies.
void Puppet::find_legs() {
  std::vector<LimbJoints> extra[2];
  for (int j = 0; j < skeleton_.size(); ++j) {
    const JointName name = joint_name(skeleton_.joints[j].name);
    const int side = int(name.side) - 1;
    if (side < 0 || name.word != "thigh" || name.fore || j == figure_.legs[side].upper) continue;
    LimbJoints limb;
    limb.upper = j;
    limb.lower = only_child(j);
    extra[side].push_back(limb);
  }
  many_ = !extra[0].empty();
  for (int side = 0; side < 2; ++side) {
    add_leg(figure_.legs[std::size_t(side)], side == 0, 0);
    for (std::size_t i = 0; i < extra[side].size(); ++i)
      add_leg(extra[side][i], side == 0, int(i) + 1);
    if (!many_ && figure_.chest >= 0 && lies() && reaches_ground(figure_.arms[std::size_t(side)]))
      add_leg(figure_.arms[std::size_t(side)], side == 0, 1);
  }
}

int Puppet::only_child(int joint) const {
  const std::vector<int> children = skeleton_.children(joint);
  return children.empty() ? -1 : children[0];
}

bool Puppet::lies() const {
  const Vec3 way = rest_[figure_.chest] - rest_[figure_.hips];
  return std::abs(way.y()) < 0.5 * way.norm();
}

bool Puppet::reaches_ground(const LimbJoints& arm) const {
  return arm.end >= 0 && figure_.legs[0].end >= 0 && arm.upper >= 0 &&
         rest_[arm.end].y() - ground() < 0.4 * (rest_[arm.upper].y() - ground());
}

double Puppet::ground() const {
  double lowest = 0;
  for (const Vec3& p : rest_) lowest = std::min(lowest, p.y());
  return lowest < -0.02 ? lowest : 0;
}

Stance::Stance(const Puppet& body) : body_(body), turns_(body.rest().size(), std::nullopt) {
  for (const Leg& leg : body.legs()) feet_.push_back({leg.stand, Quat::Identity()});
}

void Stance::turn_trunk(const Quat& hips, const Quat& chest, const Quat& head) {
  const std::vector<int>& trunk = body_.figure().trunk;
  const int count = int(trunk.size());
  if (count == 0) return turn(0, hips);
  const int last = body_.figure().head >= 0 ? count - 1 : count;
  for (int i = 0; i < last; ++i)
    turn(trunk[i], last > 1 ? hips.slerp(double(i) / (last - 1), chest) : hips);
  if (body_.figure().head >= 0) turn(trunk.back(), head);
}

void Stance::hang_arm(int side, double out, double ahead, double bend) {
  const LimbJoints& arm = body_.figure().arms[std::size_t(side)];
  const double sign = side == 0 ? 1 : -1;
  const Vec3 upper = about_x(-ahead) * (about_z(sign * out) * -Vec3::UnitY());
  const Vec3 lower = about_x(-bend) * upper;
  point(arm.upper, arm.lower, upper);
  point(arm.lower, arm.end, lower);
}

Pose Stance::pose() const {
  const Skeleton& skeleton = body_.skeleton();
  Pose pose = rest_pose(skeleton);
  pose.root_position = skeleton.joints[0].offset + shift;
  std::vector<Quat> world(turns_.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    const Quat above = parent < 0 ? Quat(Quat::Identity()) : world[parent];
    world[j] = turns_[j].value_or(above);
    for (const Point& point : points_)
      if (point.joint == j) world[j] = pointed(point, above);
    pose.rotations[j] = (above.conjugate() * world[j]).normalized();
  }
  for (std::size_t i = 0; i < feet_.size(); ++i)
    put_limb(skeleton, body_.legs()[i].limb, feet_[i].ankle, feet_[i].turn, pose);
  return pose;
}

Quat Stance::pointed(const Point& point, const Quat& above) const {
  const Vec3 bone = body_.rest()[point.to] - body_.rest()[point.joint];
  const int chest = body_.figure().chest;
  const Quat base = chest >= 0 ? turns_[chest].value_or(Quat::Identity()) : Quat::Identity();
  return least_turn(above * bone, base * point.way) * above;
}

}  // namespace artisketch

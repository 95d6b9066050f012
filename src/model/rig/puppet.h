// A skeleton taken apart to be posed by hand's rules: which legs it stands on, and poses made of
// turns in the world with the feet put where they belong.
#pragma once

#include <optional>
#include <vector>

#include "model/rig/body_plan.h"
#include "model/stages.h"

namespace artisketch {

struct Leg {
  LimbJoints limb;
  double reach = 0;   // its two bones' length
  Vec3 stand;         // its ankle's place at rest, under its top as far as that goes
  double height = 0;  // of the ankle above the ground at rest
  bool left = false;
  int row = 0;  // from behind
};

// It refers to the skeleton.
class Puppet {
 public:
  explicit Puppet(const Skeleton& skeleton);

  const Skeleton& skeleton() const { return skeleton_; }
  const BodyPlan& figure() const { return figure_; }
  const std::vector<Vec3>& rest() const { return rest_; }
  const std::vector<Leg>& legs() const { return legs_; }
  bool stands_up() const { return legs_.size() == 2; }
  bool on_many_legs() const { return legs_.size() >= 4; }
  bool level() const { return level_; }    // its trunk lies
  double reach() const { return reach_; }  // a leg's, the measure of all ways
  bool has_arms() const {
    return !on_many_legs() && figure_.arms[0].lower >= 0 && figure_.arms[1].lower >= 0;
  }
  bool has_wings() const;  // they stay spread, as they are drawn

 private:
  void add_leg(LimbJoints limb, bool left, int row);
  void find_legs();
  int only_child(int joint) const;
  bool lies() const;
  bool reaches_ground(const LimbJoints& arm) const;
  double ground() const;

  const Skeleton& skeleton_;
  std::vector<Vec3> rest_;
  BodyPlan figure_;
  std::vector<Leg> legs_;
  bool many_ = false, level_ = false;
  double reach_ = 0;
};

// One pose in the making: turns in the world, the feet at last. It refers to the puppet.
class Stance {
 public:
  explicit Stance(const Puppet& body);

  Vec3 shift = Vec3::Zero();  // of the root from where it is at rest

  void turn(int joint, const Quat& q) {
    if (joint >= 0) turns_[joint] = q;
  }
  // The hips' and the chest's turns; what is between goes over from one to the other.
  void turn_trunk(const Quat& hips, const Quat& chest, const Quat& head);
  // An arm, by where its halves point in the chest's space: `out` degrees from hanging to the side,
  // `ahead` swung to the front, its elbow bent to the front by `bend`.
  void hang_arm(int side, double out, double ahead, double bend);
  // A joint turned so that its bone points somewhere in the chest's space.
  void point(int joint, int to, const Vec3& way) { points_.push_back({joint, to, way}); }
  void put_foot(std::size_t leg, const Vec3& ankle, const Quat& turn) {
    feet_[leg] = {ankle, turn};
  }

  Pose pose() const;

 private:
  struct Point {
    int joint, to;
    Vec3 way;
  };
  struct Foot {
    Vec3 ankle;
    Quat turn;
  };
  Quat pointed(const Point& point, const Quat& above) const;

  const Puppet& body_;
  std::vector<std::optional<Quat>> turns_;
  std::vector<Point> points_;
  std::vector<Foot> feet_;
};

}  // namespace artisketch

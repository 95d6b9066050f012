#include "model/rig/library.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>

#include "base/rotation.h"
#include "model/rig/body_plan.h"
#include "model/rig/feet.h"

namespace artisketch {
namespace {

constexpr double kKeys = 24;  // a second

Quat about_x(double angle) {
  return Quat(Eigen::AngleAxisd(radians(angle), Vec3::UnitX()));
}
Quat about_y(double angle) {
  return Quat(Eigen::AngleAxisd(radians(angle), Vec3::UnitY()));
}
Quat about_z(double angle) {
  return Quat(Eigen::AngleAxisd(radians(angle), Vec3::UnitZ()));
}
double wave(double phase) {
  return std::sin(2 * kPi * phase);
}
double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}
// 0 before a, 1 from b to c, 0 after d.
double plateau(double t, double a, double b, double c, double d) {
  return smooth((t - a) / (b - a)) * (1 - smooth((t - c) / (d - c)));
}

struct Leg {
  LimbJoints limb;
  double reach = 0;   // its two bones' length
  Vec3 stand;         // its ankle's place at rest, under its top as far as that goes
  double height = 0;  // of the ankle above the ground at rest
  bool left = false;
  int row = 0;  // from behind
};

// A skeleton taken apart for posing.
class Puppet {
 public:
  explicit Puppet(const Skeleton& skeleton)
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

  const Skeleton& skeleton() const { return skeleton_; }
  const BodyPlan& figure() const { return figure_; }
  const std::vector<Vec3>& rest() const { return rest_; }
  const std::vector<Leg>& legs() const { return legs_; }
  bool stands_up() const { return legs_.size() == 2; }
  bool on_many_legs() const { return legs_.size() >= 4; }
  bool level() const { return level_; }
  double reach() const { return reach_; }  // a leg's, the measure of all ways
  bool has_arms() const {
    return !on_many_legs() && figure_.arms[0].lower >= 0 && figure_.arms[1].lower >= 0;
  }
  // Wings stay spread, as they are drawn.
  bool has_wings() const {
    return has_arms() &&
           joint_name(skeleton_.joints[figure_.arms[0].upper].name).word.find("wing") !=
               std::string::npos;
  }

 private:
  void add_leg(LimbJoints limb, bool left, int row) {
    if (limb.upper < 0 || limb.lower < 0) return;
    if (limb.end < 0) limb.end = only_child(limb.lower);
    if (limb.end < 0) return;
    Leg leg;
    leg.limb = limb;
    leg.left = left;
    leg.row = row;
    leg.reach = (rest_[limb.lower] - rest_[limb.upper]).norm() +
                (rest_[limb.end] - rest_[limb.lower]).norm();
    leg.height = rest_[limb.end].y() - ground();
    leg.stand = rest_[limb.end];
    // Legs that are drawn spread or crossed stand under the hips, many as they are.
    if (!many_) leg.stand.x() = rest_[limb.upper].x();
    legs_.push_back(leg);
  }

  // As many legs as there are thighs; front legs are arms where the trunk lies.
  void find_legs() {
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
  int only_child(int joint) const {
    const std::vector<int> children = skeleton_.children(joint);
    return children.empty() ? -1 : children[0];
  }
  bool lies() const {
    const Vec3 way = rest_[figure_.chest] - rest_[figure_.hips];
    return std::abs(way.y()) < 0.5 * way.norm();
  }
  bool reaches_ground(const LimbJoints& arm) const {
    return arm.end >= 0 && figure_.legs[0].end >= 0 && arm.upper >= 0 &&
           rest_[arm.end].y() - ground() < 0.4 * (rest_[arm.upper].y() - ground());
  }
  double ground() const {
    double lowest = 0;
    for (const Vec3& p : rest_) lowest = std::min(lowest, p.y());
    return lowest < -0.02 ? lowest : 0;
  }

  const Skeleton& skeleton_;
  std::vector<Vec3> rest_;
  BodyPlan figure_;
  std::vector<Leg> legs_;
  bool many_ = false, level_ = false;
  double reach_ = 0;
};

// One pose in the making: turns in the world, the feet at last.
class Stance {
 public:
  explicit Stance(const Puppet& body) : body_(body), turns_(body.rest().size(), std::nullopt) {
    for (const Leg& leg : body.legs()) feet_.push_back({leg.stand, Quat::Identity()});
  }

  Vec3 shift = Vec3::Zero();  // of the root from where it is at rest

  void turn(int joint, const Quat& q) {
    if (joint >= 0) turns_[joint] = q;
  }
  // The hips' and the chest's turns; what is between goes over from one to the other.
  void turn_trunk(const Quat& hips, const Quat& chest, const Quat& head) {
    const std::vector<int>& trunk = body_.figure().trunk;
    const int count = int(trunk.size());
    if (count == 0) return turn(0, hips);
    const int last = body_.figure().head >= 0 ? count - 1 : count;
    for (int i = 0; i < last; ++i)
      turn(trunk[i], last > 1 ? hips.slerp(double(i) / (last - 1), chest) : hips);
    if (body_.figure().head >= 0) turn(trunk.back(), head);
  }
  // An arm, by where its halves point in the chest's space: `out` degrees from hanging to the side,
  // `ahead` swung to the front, its elbow bent to the front by `bend`.
  void hang_arm(int side, double out, double ahead, double bend) {
    const LimbJoints& arm = body_.figure().arms[std::size_t(side)];
    const double sign = side == 0 ? 1 : -1;
    const Vec3 upper = about_x(-ahead) * (about_z(sign * out) * -Vec3::UnitY());
    const Vec3 lower = about_x(-bend) * upper;
    point(arm.upper, arm.lower, upper);
    point(arm.lower, arm.end, lower);
  }
  // A joint turned so that its bone points somewhere in the chest's space.
  void point(int joint, int to, const Vec3& way) { points_.push_back({joint, to, way}); }

  void put_foot(std::size_t leg, const Vec3& ankle, const Quat& turn) {
    feet_[leg] = {ankle, turn};
  }

  Pose pose() const {
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

 private:
  struct Point {
    int joint, to;
    Vec3 way;
  };
  struct Foot {
    Vec3 ankle;
    Quat turn;
  };
  Quat pointed(const Point& point, const Quat& above) const {
    const Vec3 bone = body_.rest()[point.to] - body_.rest()[point.joint];
    const int chest = body_.figure().chest;
    const Quat base = chest >= 0 ? turns_[chest].value_or(Quat::Identity()) : Quat::Identity();
    return least_turn(above * bone, base * point.way) * above;
  }

  const Puppet& body_;
  std::vector<std::optional<Quat>> turns_;
  std::vector<Point> points_;
  std::vector<Foot> feet_;
};

// ---------------------------------------------------------------- gaits

struct Gait {
  double period;  // seconds, of a whole stride
  double length;  // of a stride, of a leg's length
  double stance;  // share of a stride in which a foot is on the ground
  double lift;    // of a foot, of a leg's length
  double bounce;  // of the body, of a leg's length: highest over a standing foot; < 0: lowest
  double lean, swing, elbow;  // degrees: the trunk ahead, arms, how they are bent
  double kick;                // degrees that a foot points down behind
  std::function<double(const Leg&)> phase;
};

// An ankle's way against the middle of its stance, and the foot's pitch, toes down.
struct Step {
  double ahead, up, pitch;
};
Step step_at(double phase, const Gait& gait, double length, double lift) {
  phase -= std::floor(phase);
  const double half = length * gait.stance / 2;
  const auto rising = [&](double t) { return gait.kick * smooth((t - 0.6) / 0.4); };
  if (phase < gait.stance) {
    const double t = phase / gait.stance;
    return {half - 2 * half * t, 0, rising(t)};
  }
  const double t = (phase - gait.stance) / (1 - gait.stance);
  // It leaves and meets the ground at the ground's own pace.
  const double pace = -2 * half / gait.stance * (1 - gait.stance);
  const double h00 = 2 * t * t * t - 3 * t * t + 1, h10 = t * t * t - 2 * t * t + t,
               h01 = -2 * t * t * t + 3 * t * t, h11 = t * t * t - t * t;
  return {-half * h00 + pace * h10 + half * h01 + pace * h11, lift * std::pow(std::sin(kPi * t), 2),
          gait.kick * (1 - smooth(t / 0.7)) - 12 * plateau(t, 0.5, 0.9, 0.9, 1)};
}

Pose gait_pose(const Puppet& body, const Gait& gait, const ClipStyle& style, double phase) {
  Stance stance(body);
  const double reach = body.reach();
  const double length = gait.length * style.stride * reach;
  const double lift = gait.lift * (0.5 + 0.5 * style.stride) * reach;
  // Twice a stride; lowest while the weight comes down on a foot.
  const double bob =
      gait.bounce * style.bounce * reach * std::cos(4 * kPi * (phase - gait.stance / 2));
  const double sway =
      body.stands_up() ? 0.04 * style.weight * reach * wave(phase - gait.stance / 2 + 0.25) : 0;
  // As low as the legs' farthest reach asks for.
  double sink = 0.01 * style.weight * reach;
  for (const Leg& leg : body.legs()) {
    const Vec3 top = body.rest()[leg.limb.upper];
    const double half = length * gait.stance / 2, room = 0.985 * leg.reach;
    const double side = std::hypot(std::abs(top.x() - leg.stand.x()) + std::abs(sway),
                                   body.on_many_legs() ? top.z() - leg.stand.z() : 0);
    const double tall =
        std::sqrt(std::max(0.1 * room * room, room * room - half * half - side * side));
    sink = std::max(sink, top.y() - leg.stand.y() - tall);
  }
  stance.shift = Vec3(sway, bob - sink - std::abs(gait.bounce * style.bounce * reach), 0);

  const double yaw = (body.level() ? 2 : 7) * style.stride * wave(phase + 0.25);
  const double roll = (body.level() ? 2 : 3) * style.weight * wave(phase - gait.stance / 2 + 0.25);
  const double lean = gait.lean * (0.6 + 0.4 * style.weight);
  const Quat hips = about_y(-yaw) * about_z(roll) * about_x(body.level() ? 0 : 0.4 * lean);
  const Quat chest = about_y(yaw) * about_z(-0.5 * roll) * about_x(body.level() ? 0 : lean);
  const double nod = body.level() ? 4 * style.bounce * std::cos(4 * kPi * phase) : 0;
  stance.turn_trunk(hips, chest, about_x(nod + (body.level() ? 0 : 0.3 * lean)));
  if (body.has_arms() && !body.has_wings())
    for (int side = 0; side < 2; ++side) {
      // Against the leg of its side.
      const double back = std::cos(2 * kPi * (phase + (side == 0 ? 0 : 0.5)));
      const double ahead = -gait.swing * style.stride * back + lean;
      stance.hang_arm(side, 20, ahead, gait.elbow + 0.35 * gait.swing * (1 - back) / 2);
    }
  if (body.has_wings())
    for (int side = 0; side < 2; ++side)
      stance.turn(body.figure().arms[std::size_t(side)].upper,
                  about_z((side == 0 ? 1 : -1) * 8 * wave(2 * phase)));
  const std::vector<int>& tail = body.figure().tail;
  for (std::size_t i = 0; i < tail.size(); ++i)
    stance.turn(tail[i], about_y(12 * wave(phase - 0.15 * double(i))));
  for (std::size_t i = 0; i < body.legs().size(); ++i) {
    const Leg& leg = body.legs()[i];
    const Step step = step_at(phase + gait.phase(leg), gait, length, lift);
    const bool toes = leg.limb.tip >= 0;
    const Quat turn = about_x(toes ? step.pitch : 0);
    // While the heel rises the toes keep their place: the ankle goes round them.
    Vec3 ankle = leg.stand;
    const Vec3 top = body.rest()[leg.limb.upper];
    ankle.z() = body.on_many_legs() ? leg.stand.z() : top.z() + 0.5 * (leg.stand.z() - top.z());
    if (toes && step.pitch > 0) {
      const Vec3 tip = body.rest()[leg.limb.tip] - body.rest()[leg.limb.end];
      ankle += tip - turn * tip;
    }
    ankle += Vec3(0, step.up, step.ahead);
    stance.put_foot(i, ankle, turn);
  }
  return stance.pose();
}

Gait walk_gait() {
  return {1.0, 1.15, 0.6, 0.13, 0.02,
          5,   24,   14,  26,   [](const Leg& leg) { return leg.left ? 0 : 0.5; }};
}
Gait run_gait() {
  return {0.64, 1.9, 0.36, 0.36, -0.06,
          14,   38,  75,   38,   [](const Leg& leg) { return leg.left ? 0 : 0.5; }};
}
Gait four_walk_gait() {
  return {
      1.1, 0.75, 0.66, 0.16, 0.012,
      0,   0,    0,    18,   [](const Leg& leg) {
            return (leg.left ? 0 : 0.5) + 0.75 * leg.row; }};
}
Gait trot_gait() {
  return {
      0.64, 1.0, 0.48, 0.24, 0.045,
      0,    0,   0,    24,   [](const Leg& leg) {
            return (leg.left ? 0 : 0.5) + 0.5 * leg.row; }};
}

// ---------------------------------------------------------------- on the spot

void rest_arms(const Puppet& body, Stance& stance, double breath, double out, double ahead,
               double bend) {
  if (!body.has_arms() || body.has_wings()) return;
  for (int side = 0; side < 2; ++side) stance.hang_arm(side, out + breath, ahead, bend);
}

void wag_tail(const Puppet& body, Stance& stance, double angle, double phase) {
  const std::vector<int>& tail = body.figure().tail;
  for (std::size_t i = 0; i < tail.size(); ++i)
    stance.turn(tail[i], about_y(angle * wave(phase - 0.12 * double(i))));
}

// Standing, and breathing.
void stand(const Puppet& body, const ClipStyle& style, double phase, Stance& stance) {
  const double breath = wave(phase);
  stance.shift.y() = -body.reach() * (0.012 * style.weight + 0.008 * style.bounce * (1 - breath));
  stance.turn_trunk(about_x(0), about_x((body.level() ? 0.6 : -1.5) * breath * style.stride),
                    about_x(1.5 * wave(phase - 0.1)) * about_y(4 * style.stride * wave(phase / 1)));
  rest_arms(body, stance, 1.5 * breath, 20, 3, 12);
  wag_tail(body, stance, 14 * style.stride, 2 * phase);
  if (body.legs().empty())  // what has no legs sways
    stance.shift.y() = 0.03 * style.bounce * body.reach() * breath;
}

Pose idle_pose(const Puppet& body, const ClipStyle& style, double phase) {
  Stance stance(body);
  stand(body, style, phase, stance);
  return stance.pose();
}

Pose wave_pose(const Puppet& body, const ClipStyle& style, double phase) {
  Stance stance(body);
  stand(body, style, phase, stance);
  const double up = plateau(phase, 0, 0.22, 0.78, 1);
  const double swings = up * wave(4 * phase);
  const LimbJoints& arm = body.figure().arms[0];
  const Vec3 hanging = about_z(20) * -Vec3::UnitY(), hanging_low = about_x(-12) * hanging;
  // Up beside the head, elbow out: there is room for a large one.
  const Vec3 raised = Vec3(1, 0.25, 0.25).normalized();
  const Vec3 greeting = about_z(-22 * style.stride * swings) * Vec3(0.35, 1, 0.2).normalized();
  const auto between = [up](const Vec3& from, const Vec3& to) -> Vec3 {
    return Quat::Identity().slerp(up, least_turn(from, to)) * from;
  };
  stance.point(arm.upper, arm.lower, between(hanging, raised));
  stance.point(arm.lower, arm.end, between(hanging_low, greeting));
  return stance.pose();
}

Pose jump_pose(const Puppet& body, const ClipStyle& style, double phase) {
  Stance stance(body);
  const double reach = body.reach();
  // Down, up off the ground, down again; times are shares of the clip.
  constexpr double kOff = 0.34, kLand = 0.66;
  const double crouch =
      plateau(phase, 0, 0.2, 0.22, kOff) + 0.8 * plateau(phase, kLand, 0.76, 0.78, 1);
  const double air = std::clamp((phase - kOff) / (kLand - kOff), 0.0, 1.0);
  const double height = 0.55 * style.bounce * reach * 4 * air * (1 - air);
  const double deep = 0.3 * std::min(1.8, 0.5 + 0.5 * style.weight) * reach;
  stance.shift.y() = height - deep * crouch - 0.012 * reach;
  stance.shift.z() = -0.12 * reach * crouch;
  const Quat bent = about_x(28 * crouch - 6 * (height > 0 ? 4 * air * (1 - air) : 0));
  stance.turn_trunk(about_x(14 * crouch), body.level() ? Quat(Quat::Identity()) : bent,
                    about_x(4 * crouch));
  if (body.has_arms() && !body.has_wings()) {
    const double thrown = plateau(phase, 0.24, 0.4, 0.6, 0.8);
    for (int side = 0; side < 2; ++side)
      stance.hang_arm(side, 20 + 25 * thrown, 3 - 35 * crouch + 95 * style.stride * thrown,
                      12 + 20 * crouch);
  }
  for (std::size_t i = 0; i < body.legs().size(); ++i) {
    const Leg& leg = body.legs()[i];
    const double tuck = 0.25 * 4 * air * (1 - air) * height;
    const double toes = 30 * plateau(phase, kOff - 0.04, kOff + 0.02, 0.5, kLand);
    // The heels leave the ground first: the ankle goes round the toes.
    const Quat turn = about_x(leg.limb.tip >= 0 ? toes : 0);
    Vec3 ankle = leg.stand + Vec3(0, height + tuck, 0);
    if (leg.limb.tip >= 0) {
      const Vec3 tip = body.rest()[leg.limb.tip] - body.rest()[leg.limb.end];
      ankle += tip - turn * tip;
    }
    stance.put_foot(i, ankle, turn);
  }
  return stance.pose();
}

// Down on a seat as high as the knees, some breaths there, and up again.
Pose sit_pose(const Puppet& body, const ClipStyle& style, double phase) {
  Stance stance(body);
  const double down = plateau(phase, 0, 0.3, 0.72, 1);
  const double moving = 4 * down * (1 - down);
  const Leg& leg = body.legs()[0];
  const double thigh = (body.rest()[leg.limb.lower] - body.rest()[leg.limb.upper]).norm();
  const double shin = (body.rest()[leg.limb.end] - body.rest()[leg.limb.lower]).norm();
  const double top = body.rest()[leg.limb.upper].y() - leg.stand.y();
  // Thighs level, shins upright.
  stance.shift.y() = -down * (top - shin) - 0.012 * body.reach();
  stance.shift.z() = -down * (thigh + body.rest()[leg.limb.upper].z() - leg.stand.z());
  const double lean = 30 * moving * (0.5 + 0.5 * style.weight) + 2 * wave(3 * phase) * down;
  stance.turn_trunk(about_x(0.5 * lean - 4 * down), about_x(lean), about_x(0.3 * lean));
  if (body.has_arms() && !body.has_wings())
    for (int side = 0; side < 2; ++side)
      stance.hang_arm(side, 20 - 4 * down, 3 + 22 * down + 0.8 * lean, 12 + 45 * down);
  return stance.pose();
}

// ---------------------------------------------------------------- the list

using Make = Pose (*)(const Puppet&, const ClipStyle&, double phase);
struct Row {
  LibraryClip clip;
  double period;  // seconds
  bool (*fits)(const Puppet&);
  Make pose;
};
const Row kRows[] = {
    {{"idle", "stands and breathes"}, 3, [](const Puppet&) { return true; }, idle_pose},
    {{"walk", "walks on the spot"},
     1.0,
     [](const Puppet& body) { return body.stands_up(); },
     [](const Puppet& body, const ClipStyle& style, double phase) {
       return gait_pose(body, walk_gait(), style, phase);
     }},
    {{"run", "runs on the spot"},
     0.64,
     [](const Puppet& body) { return body.stands_up(); },
     [](const Puppet& body, const ClipStyle& style, double phase) {
       return gait_pose(body, run_gait(), style, phase);
     }},
    {{"walk", "walks on the spot"},
     1.1,
     [](const Puppet& body) { return body.on_many_legs(); },
     [](const Puppet& body, const ClipStyle& style, double phase) {
       return gait_pose(body, four_walk_gait(), style, phase);
     }},
    {{"trot", "trots on the spot"},
     0.64,
     [](const Puppet& body) { return body.on_many_legs(); },
     [](const Puppet& body, const ClipStyle& style, double phase) {
       return gait_pose(body, trot_gait(), style, phase);
     }},
    {{"jump", "jumps up and lands"},
     1.3,
     [](const Puppet& body) { return body.stands_up(); },
     jump_pose},
    {{"wave", "waves its left hand"},
     2.4,
     [](const Puppet& body) { return body.has_arms() && !body.has_wings() && body.stands_up(); },
     wave_pose},
    {{"sit", "sits down and gets up"},
     3.2,
     [](const Puppet& body) { return body.stands_up() && !body.has_wings(); },
     sit_pose},
};

}  // namespace

std::vector<LibraryClip> library_clips(const Skeleton& skeleton) {
  const Puppet body(skeleton);
  std::vector<LibraryClip> fitting;
  for (const Row& row : kRows)
    if (row.fits(body)) fitting.push_back(row.clip);
  return fitting;
}

Result<Clip> library_clip(const Skeleton& skeleton, std::string_view name, const ClipStyle& style) {
  const Puppet body(skeleton);
  std::string fitting;
  for (const Row& row : kRows) {
    if (!row.fits(body)) continue;
    fitting += (fitting.empty() ? "" : ", ") + std::string(row.clip.name);
    if (name != row.clip.name) continue;
    Clip clip{row.clip.name, {}, {}};
    const double length = row.period / style.speed;
    const int keys = std::max(8, int(std::lround(length * kKeys)));
    for (int k = 0; k <= keys; ++k) {
      clip.times.push_back(length * k / keys);
      clip.poses.push_back(row.pose(body, style, double(k) / keys));
    }
    // To the last bit, so that it can go round.
    clip.poses.back() = clip.poses.front();
    return clip;
  }
  return bad_input("no clip '" + std::string(name) + "' fits this skeleton: there are " + fitting);
}

Animation animation_of(const Clip& clip) {
  constexpr double kTurn = 0.25;         // degrees
  constexpr double kMove = 0.002;        // of the root's height
  constexpr std::size_t kFarthest = 60;  // keys between two that stay
  const auto said_by = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = a + 1; k < b; ++k) {
      const double t = (clip.times[k] - clip.times[a]) / (clip.times[b] - clip.times[a]);
      const Pose &from = clip.poses[a], &to = clip.poses[b], &at = clip.poses[k];
      const Vec3 root = from.root_position + t * (to.root_position - from.root_position);
      if ((root - at.root_position).norm() > kMove * std::abs(clip.poses[0].root_position.y()))
        return false;
      for (std::size_t j = 0; j < at.rotations.size(); ++j)
        if (from.rotations[j].slerp(t, to.rotations[j]).angularDistance(at.rotations[j]) >
            radians(kTurn))
          return false;
    }
    return true;
  };
  Animation animation;
  animation.name = clip.name;
  const auto keep = [&](std::size_t k) {
    animation.keys.push_back({clip.times[k], clip.poses[k], ""});
  };
  keep(0);
  for (std::size_t last = 0; last + 1 < clip.poses.size();) {
    std::size_t next = last + 1;
    while (next + 1 < clip.poses.size() && next + 1 - last <= kFarthest && said_by(last, next + 1))
      ++next;
    keep(next);
    last = next;
  }
  return animation;
}

Result<ClipWish> clip_wish(const std::string& words) {
  ClipWish wish;
  const std::size_t colon = words.find(':');
  wish.name = words.substr(0, colon);
  const struct {
    const char* name;
    double* value;
  } settings[] = {{"speed", &wish.style.speed},
                  {"stride", &wish.style.stride},
                  {"bounce", &wish.style.bounce},
                  {"weight", &wish.style.weight}};
  for (std::size_t at = colon; at < words.size();) {
    const std::size_t end = std::min(words.find(',', at + 1), words.size());
    const std::string one = words.substr(at + 1, end - at - 1);
    const std::size_t equals = one.find('=');
    bool known = false;
    for (const auto& setting : settings) {
      if (equals == one.npos || one.substr(0, equals) != setting.name) continue;
      char* stop = nullptr;
      const std::string number = one.substr(equals + 1);
      *setting.value = std::strtod(number.c_str(), &stop);
      known = !number.empty() && *stop == 0 && *setting.value >= 0.1 && *setting.value <= 4;
    }
    if (!known)
      return bad_input("'" + one +
                       "': wanted speed, stride, bounce or weight, from 0.1 to 4, like " +
                       wish.name + ":stride=1.2");
    at = end;
  }
  return wish;
}

}  // namespace artisketch

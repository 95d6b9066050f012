// Clips that go: walks, runs, trots. The feet's ways come first; the body rides as high over them
// as its legs reach, as people and animals do, who spend least on a leg that is nearly straight.
#include "base/rotation.h"
#include "model/rig/clip_making.h"

namespace artisketch {
namespace {

struct Gait {
  double length;  // of a stride, of a leg's length
  double stance;  // share of a stride in which a foot is on the ground
  double behind;  // where the middle of a stance is behind the hips, of a leg's length
  double lift;    // of a foot, of a leg's length
  double early;   // when a swinging foot is highest: 1 half-way, less sooner
  double bounce;  // of the body, of a leg's length: highest over a standing foot; < 0: lowest
  double lean, swing, elbow;  // degrees: the trunk ahead, arms, how they are bent
  double kick, strike;        // degrees that a foot points down as it leaves, up as it meets
  double (*phase)(const Leg&);
};

double by_turns(const Leg& leg) {
  return leg.left ? 0 : 0.5;
}
// Each foot a quarter after the one before: hind left, front left, hind right, front right.
double by_quarters(const Leg& leg) {
  return by_turns(leg) + 0.75 * leg.row;
}
double by_diagonals(const Leg& leg) {
  return by_turns(leg) + 0.5 * leg.row;
}

// length, stance, behind, lift, early, bounce, lean, swing, elbow, kick, strike
constexpr Gait kWalk = {1.25, 0.6, 0, 0.13, 0.75, 0.018, 4, 24, 14, 42, 26, by_turns};
constexpr Gait kRun = {2.0, 0.36, 0.05, 0.36, 0.85, -0.035, 12, 38, 75, 46, 8, by_turns};
constexpr Gait kFourWalk = {0.75, 0.66, 0, 0.14, 0.85, 0.012, 0, 0, 0, 26, 6, by_quarters};
constexpr Gait kTrot = {1.0, 0.48, 0, 0.22, 0.85, 0.045, 0, 0, 0, 32, 6, by_diagonals};

// An ankle's way against the middle of its stance, and the foot's pitch, toes down.
struct Step {
  double ahead, up, pitch;
};
Step step_at(double phase, const Gait& gait, double length, double lift) {
  phase -= std::floor(phase);
  const double half = length * gait.stance / 2;
  if (phase < gait.stance) {
    const double t = phase / gait.stance;
    return {half - 2 * half * t, 0,
            gait.kick * smooth((t - 0.5) / 0.5) - gait.strike * (1 - smooth(t / 0.18))};
  }
  const double t = (phase - gait.stance) / (1 - gait.stance);
  // It leaves and meets the ground at the ground's own pace.
  const double pace = -2 * half / gait.stance * (1 - gait.stance);
  const double h00 = 2 * t * t * t - 3 * t * t + 1, h10 = t * t * t - 2 * t * t + t,
               h01 = -2 * t * t * t + 3 * t * t, h11 = t * t * t - t * t;
  return {-half * h00 + pace * h10 + half * h01 + pace * h11,
          lift * std::pow(std::sin(kPi * std::pow(t, gait.early)), 2),
          gait.kick * (1 - smooth(t / 0.7)) - gait.strike * smooth((t - 0.45) / 0.5)};
}

// How the body is turned and shifted at one time of a gait, but for its height.
struct Ride {
  double sway, yaw, roll, lean;
  Quat hips, chest;
};
Ride ride_at(const Puppet& body, const Gait& gait, const ClipStyle& style, double phase) {
  Ride ride;
  const double side = wave(phase - gait.stance / 2 + 0.25);
  ride.sway = body.stands_up() ? 0.04 * style.weight * body.reach() * side : 0;
  ride.yaw = (body.level() ? 2 : 7) * style.stride * wave(phase + 0.25);
  ride.roll = (body.level() ? 2 : 3) * style.weight * side;
  ride.lean = body.level() ? 0 : gait.lean * (0.6 + 0.4 * style.weight);
  ride.hips = about_y(-ride.yaw) * about_z(ride.roll) * about_x(0.4 * ride.lean);
  ride.chest = about_y(ride.yaw) * about_z(-0.5 * ride.roll) * about_x(ride.lean);
  return ride;
}

struct Foot {
  Vec3 ankle;
  Quat turn;
};
Foot foot_at(const Puppet& body, const Leg& leg, const Gait& gait, const ClipStyle& style,
             double phase) {
  const double length = gait.length * style.stride * body.reach();
  const double lift = gait.lift * (0.5 + 0.5 * style.stride) * body.reach();
  const Step step = step_at(phase + gait.phase(leg), gait, length, lift);
  const std::vector<Vec3>& rest = body.rest();
  Foot foot{leg.stand, Quat::Identity()};
  if (!body.on_many_legs()) {
    const double top = rest[leg.limb.upper].z();
    foot.ankle.z() = top + 0.5 * (leg.stand.z() - top);
  }
  if (leg.limb.tip >= 0) {
    // While the heel rises the toes keep their place, while the toes rise the heel does: the ankle
    // goes round them. No joint says where a heel is: a fifth as far behind as the toes are ahead.
    const Vec3 tip = rest[leg.limb.tip] - rest[leg.limb.end];
    // Large feet turn less: their ankles rise as far as a usual foot's over its ball.
    constexpr double kFoot = 0.2;  // of a leg's length
    foot.turn = about_x(step.pitch * std::min(1.0, kFoot * leg.reach / std::max(tip.norm(), 1e-9)));
    const Vec3 pivot = step.pitch > 0 ? tip : Vec3(-tip.x() / 5, tip.y(), -tip.z() / 5);
    foot.ankle += pivot - foot.turn * pivot;
  }
  foot.ankle += Vec3(0, step.up, step.ahead - gait.behind * body.reach());
  return foot;
}

double bob_at(const Puppet& body, const Gait& gait, const ClipStyle& style, double phase) {
  // Twice a stride.
  return gait.bounce * style.bounce * body.reach() * std::cos(4 * kPi * (phase - gait.stance / 2));
}

// How far the root may rise over where it is at rest with every leg reaching its foot.
double highest_at(const Puppet& body, const Gait& gait, const ClipStyle& style, double phase) {
  constexpr double kStretched = 0.997;  // of a leg's length: nobody walks on locked knees
  const std::vector<Vec3>& rest = body.rest();
  const Ride ride = ride_at(body, gait, style, phase);
  double highest = 1e300;
  for (const Leg& leg : body.legs()) {
    const Vec3 off = rest[leg.limb.upper] - rest[0];
    const Vec3 top =
        rest[0] + ride.sway * Vec3::UnitX() + (body.stands_up() ? Vec3(ride.hips * off) : off);
    const Vec3 ankle = foot_at(body, leg, gait, style, phase).ankle;
    const double room = kStretched * leg.reach;
    const double level = std::hypot(top.x() - ankle.x(), top.z() - ankle.z());
    // Long strides are more than any height lets the legs reach: they stay bent.
    const double tall = std::sqrt(std::max(0.3 * room * room, room * room - level * level));
    highest = std::min(highest, ankle.y() + tall - top.y());
  }
  return highest;
}

double height_of(const Puppet& body, const Gait& gait, const ClipStyle& style) {
  constexpr int kTimes = 48;
  double height = 1e300;
  for (int k = 0; k < kTimes; ++k) {
    const double phase = double(k) / kTimes;
    height =
        std::min(height, highest_at(body, gait, style, phase) - bob_at(body, gait, style, phase));
  }
  const double heavy = std::max(0.0, style.weight - 1);
  return height - 0.02 * heavy * body.reach();
}

Pose gait_pose(const Puppet& body, const Gait& gait, const ClipStyle& style, double phase) {
  Stance stance(body);
  const Ride ride = ride_at(body, gait, style, phase);
  stance.shift =
      Vec3(ride.sway, height_of(body, gait, style) + bob_at(body, gait, style, phase), 0);
  const double nod = body.level() ? 4 * style.bounce * std::cos(4 * kPi * phase) : 0.3 * ride.lean;
  stance.turn_trunk(ride.hips, ride.chest, about_x(nod));
  if (body.has_arms() && !body.has_wings())
    for (int side = 0; side < 2; ++side) {
      // Against the leg of its side.
      const double back = std::cos(2 * kPi * (phase + (side == 0 ? 0 : 0.5)));
      const double ahead = -gait.swing * style.stride * back + ride.lean;
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
    const Foot foot = foot_at(body, body.legs()[i], gait, style, phase);
    stance.put_foot(i, foot.ankle, foot.turn);
  }
  return stance.pose();
}

}  // namespace

Pose walk_pose(const Puppet& body, const ClipStyle& style, double phase) {
  return gait_pose(body, kWalk, style, phase);
}
Pose run_pose(const Puppet& body, const ClipStyle& style, double phase) {
  return gait_pose(body, kRun, style, phase);
}
Pose four_walk_pose(const Puppet& body, const ClipStyle& style, double phase) {
  return gait_pose(body, kFourWalk, style, phase);
}
Pose trot_pose(const Puppet& body, const ClipStyle& style, double phase) {
  return gait_pose(body, kTrot, style, phase);
}

}  // namespace artisketch

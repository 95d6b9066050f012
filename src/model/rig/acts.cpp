// Clips on the spot: standing, waving, jumping, sitting.
#include "base/rotation.h"
#include "model/rig/clip_making.h"

namespace artisketch {
namespace {

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

}  // namespace

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
  // Clear of a large head at its inmost, too.
  const Vec3 greeting = about_z(-20 * style.stride * swings) * Vec3(0.5, 1, 0.3).normalized();
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

}  // namespace artisketch

// The figures themselves.
#include <cmath>

#include "figures/builder.h"
#include "figures/random.h"

namespace artisketch::figures {
namespace {

// Copies of a left part's places and blobs on the right side.
Vec3 across(const Vec3& p, int side) {
  return {side * p.x(), p.y(), p.z()};
}

constexpr const char* kSides[] = {".L", ".R"};

}  // namespace

Figure ball_figure(double radius) {
  Builder builder("ball");
  builder.joint("ball", "", Vec3::Zero(), 0, {{ball(Vec3::Zero(), radius).in(0xe8553e)}, 0, {}});
  return builder.take();
}

Figure two_balls() {
  Builder builder("two_balls");
  builder.joint(
      "body", "", Vec3::Zero(), 0,
      {{ball({-0.25, 0, 0}, 0.35).in(0xe8553e), ball({0.35, 0.1, 0.05}, 0.25).in(0xf2b84b)},
       0.15,
       {}});
  return builder.take();
}

Figure heart() {
  Builder builder("heart");
  Solid solid;
  solid.blend = 0.004;
  for (const int side : {1, -1})  // from y = −0.5 to 0.5
    solid.blobs.push_back(limb({side * 0.225, 0.23, 0}, 0.27, {0, -0.455, 0}, 0.045).in(0xd93a4c));
  builder.joint("heart", "", Vec3::Zero(), 0, solid);
  return builder.take();
}

Figure capsule_arm() {
  Builder builder("capsule_arm");
  const Vec3 shoulder(0, 0, 0), elbow(0.5, 0, 0), wrist(0.95, 0, 0), tip(1.2, 0, 0);
  builder.joint("upper_arm", "", shoulder, 0,
                {{limb(shoulder, 0.14, elbow, 0.11).in(0x3f7fbf)}, 0, {}});
  builder.joint("forearm", "upper_arm", elbow, 60,
                {{limb(elbow, 0.11, wrist, 0.08).in(0xf0c8a0)}, 0, {}});
  builder.joint("hand", "forearm", wrist, 40,
                {{limb(wrist, 0.08, tip, 0.07).in(0xf0c8a0),
                  limb(wrist + Vec3(0.1, 0.02, 0.03), 0.04, wrist + Vec3(0.17, 0.12, 0.06), 0.035)
                      .in(0xf0c8a0)},
                 0.05,
                 {}});
  builder.tip("hand.tip", "hand", tip);
  return builder.take();
}

Figure human(std::uint64_t seed) {
  Random r(seed + 101);
  const unsigned skins[] = {0xf6cfa9, 0xc98a5b, 0x8a5a3b, 0xffdcc0};
  const unsigned cloths[] = {0xd9483b, 0x3f7fbf, 0x4a9a5b, 0x8a5fb0, 0xe0a030, 0x2f9f9f};
  const unsigned skin = skins[int(r.between(0, 4))], shirt = cloths[int(r.between(0, 6))],
                 trousers = cloths[int(r.between(0, 6))], shoe = 0x6b4632, hair = 0x4a3226;
  const double leg = r.around(0.78, 0.12), trunk = r.around(0.56, 0.06), arm = r.around(0.54, 0.06);
  const double stout = r.around(1, 0.25), head = r.around(0.2, 0.06);

  Builder b("human");
  const double hip = leg + 0.1, waist = hip + 0.38 * trunk, neck = hip + trunk;
  b.joint("hips", "", {0, hip, 0}, 0,
          {{ellipsoid({0, hip + 0.02, 0}, {0.17 * stout, 0.13, 0.125 * stout}).in(trousers),
            ellipsoid({0, waist - 0.06, 0.01}, {0.14 * stout, 0.12, 0.11 * stout}).in(trousers)},
           0.05,
           {}});
  b.joint("chest", "hips", {0, waist, 0}, 15,
          {{ellipsoid({0, waist, 0.01}, {0.145 * stout, 0.12, 0.115 * stout}).in(shirt),
            ellipsoid({0, neck - 0.15, 0}, {0.19 * stout, 0.17, 0.125 * stout}).in(shirt),
            limb({-0.13, neck - 0.08, -0.01}, 0.08, {0.13, neck - 0.08, -0.01}, 0.08).in(shirt),
            limb({0, neck - 0.06, 0}, 0.06, {0, neck + 0.04, 0.01}, 0.055).in(skin)},
           0.06,
           {}});
  const Vec3 crown(0, neck + 0.06 + 2 * head, 0);
  const Vec3 skull(0, neck + 0.04 + head, 0.02);
  Solid face{{ellipsoid(skull, {0.88 * head, head, 0.95 * head}).in(skin),
              limb({0, neck + 0.02, 0}, 0.055, {0, neck + 0.1, 0.01}, 0.06).in(skin),
              ball(skull + Vec3(0, -0.1 * head, 0.95 * head), 0.16 * head).in(skin)},
             0.04,
             {ball(skull + Vec3(0.35 * head, 0.12 * head, 0.9 * head), 0.13 * head).in(0x2a2024),
              ball(skull + Vec3(-0.35 * head, 0.12 * head, 0.9 * head), 0.13 * head).in(0x2a2024)}};
  if (r.chance(0.7)) {  // hair, as a thicker skullcap with a tuft
    face.blobs.push_back(ellipsoid(skull + Vec3(0, 0.18 * head, -0.14 * head),
                                   {0.95 * head, 0.98 * head, 0.95 * head})
                             .in(hair));
    face.blobs.push_back(limb(skull + Vec3(0, head, 0.1), 0.06,
                              skull + Vec3(r.around(0, 0.1), 1.3 * head, 0.16), 0.02)
                             .in(hair));
  }
  if (r.chance(0.35))  // a hat's brim
    face.blobs.push_back(
        ellipsoid(skull + Vec3(0, 0.6 * head, 0), {1.4 * head, 0.16 * head, 1.4 * head})
            .in(trousers));
  b.joint("head", "chest", {0, neck, 0}, 25, std::move(face));
  b.tip("head.tip", "head", crown);

  const double sleeve = r.around(0.075, 0.012) * stout, wrist_radius = r.around(0.05, 0.006);
  const double thigh = r.around(0.105, 0.015) * stout, ankle_radius = r.around(0.06, 0.008);
  for (int s = 0; s < 2; ++s) {
    const int side = s == 0 ? 1 : -1;
    const std::string end = kSides[s];
    const auto at = [&](double x, double y, double z) { return across({x, y, z}, side); };
    const double x = 0.19 * stout, y = neck - 0.08;
    const Vec3 shoulder = at(x, y, 0), elbow = at(x + 0.5 * arm, y, -0.01),
               wrist = at(x + 0.96 * arm, y, 0);
    const Vec3 fingers = at(x + 0.96 * arm + 0.17, y, 0.01);
    const double elbow_radius = (sleeve + wrist_radius) / 2;
    b.joint("upper_arm" + end, "chest", shoulder, 45,
            {{limb(shoulder, sleeve, elbow, elbow_radius).in(shirt)}, 0, {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 50,
            {{limb(elbow, elbow_radius, wrist, wrist_radius).in(skin)}, 0, {}});
    b.joint("hand" + end, "forearm" + end, wrist, 25,
            {{limb(wrist, wrist_radius, wrist + at(0.04, 0, 0), 0.05).in(skin),
              ellipsoid(wrist + at(0.09, 0, 0.005), {0.085, 0.045, 0.055}).in(skin),
              limb(wrist + at(0.05, 0, 0.03), 0.028, wrist + at(0.1, 0.01, 0.085), 0.022).in(skin)},
             0.03,
             {}});
    b.tip("hand.tip" + end, "hand" + end, fingers);
  }
  for (int s = 0; s < 2; ++s) {
    const int side = s == 0 ? 1 : -1;
    const std::string end = kSides[s];
    const auto at = [&](double x, double y, double z) { return across({x, y, z}, side); };
    const double x = 0.095 * stout;
    const Vec3 top = at(x, hip - 0.03, 0), knee = at(x, 0.1 + 0.5 * leg, 0.015),
               ankle = at(x, 0.1, -0.01);
    const double knee_radius = 0.5 * (thigh + ankle_radius);
    b.joint("thigh" + end, "hips", top, 35,
            {{limb(top, thigh, knee, knee_radius).in(trousers)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 35,
            {{limb(knee, knee_radius, ankle, ankle_radius).in(trousers)}, 0, {}});
    b.joint("foot" + end, "shin" + end, ankle, 15,
            {{limb(ankle, 1.08 * ankle_radius, ankle + at(0, -0.03, 0.02), 0.065).in(shoe),
              ellipsoid(ankle + at(0, -0.045, 0.075), {0.07, 0.055, 0.14}).in(shoe)},
             0.04,
             {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.05, 0.2));
  }
  b.pair_mirrors();
  return b.take();
}

Figure quadruped(std::uint64_t seed) {
  Random r(seed + 202);
  const unsigned furs[] = {0xe07b39, 0x9a7350, 0xd8c3a0, 0x7d8590};
  const unsigned fur = furs[int(r.between(0, 4))], pale = 0xfff3e0, dark = 0x3a2b28;
  const double leg = r.around(0.55, 0.12), length = r.around(0.7, 0.12), stout = r.around(1, 0.2);
  const double muzzle = r.around(0.2, 0.07), tail = r.around(0.45, 0.15);
  const double y = leg + 0.12, girth = 0.17 * stout;

  Builder b("quadruped");
  b.joint("body", "", {0, y, -length / 2}, 0,
          {{ellipsoid({0, y, -length / 2}, {girth, girth * 1.05, girth * 1.2}).in(fur),
            limb({0, y, -length / 2}, 0.9 * girth, {0, y, -0.02}, 0.85 * girth).in(fur)},
           0.05,
           {}});
  b.joint("chest", "body", {0, y, 0}, 15,
          {{ellipsoid({0, y, 0.08}, {1.02 * girth, 1.15 * girth, 1.3 * girth}).in(fur),
            limb({0, y + 0.04, 0.15}, 0.6 * girth, {0, y + 0.2, 0.28}, 0.5 * girth).in(fur)},
           0.08,
           {ellipsoid({0, y - 0.1, 0.3}, {0.1, 0.16, 0.12}).in(pale)}});
  const Vec3 neck(0, y + 0.21, 0.28), skull = neck + Vec3(0, 0.09, 0.1);
  Solid face{
      {ellipsoid(skull, {0.155, 0.135, 0.15}).in(fur), limb(neck, 0.5 * girth, skull, 0.09).in(fur),
       limb(skull + Vec3(0, -0.05, 0.08), 0.075, skull + Vec3(0, -0.07, 0.08 + muzzle), 0.035)
           .in(fur)},
      0.05,
      {ball(skull + Vec3(0, -0.06, 0.08 + muzzle + 0.03), 0.032).in(dark)}};
  for (const int side : {1, -1}) {
    face.blobs.push_back(limb(skull + across({0.09, 0.08, -0.02}, side), 0.05,
                              skull + across({0.14, 0.08 + r.between(0.1, 0.11), -0.03}, side),
                              0.015)
                             .in(fur));
    face.paint.push_back(ball(skull + across({0.075, 0.03, 0.13}, side), 0.026).in(dark));
  }
  b.joint("head", "chest", neck, 25, std::move(face));
  b.tip("head.tip", "head", skull + Vec3(0, -0.07, 0.1 + muzzle));
  const Vec3 rump(0, y + 0.06, -length / 2 - 1.1 * girth);
  b.joint("tail", "body", rump, 35,
          {{limb(rump, 0.06, rump + Vec3(0, 0.5 * tail, -0.7 * tail), 0.085).in(fur),
            limb(rump + Vec3(0, 0.5 * tail, -0.7 * tail), 0.08,
                 rump + Vec3(0, 0.75 * tail, -0.8 * tail), 0.02)
                .in(pale)},
           0.06,
           {}});
  b.tip("tail.tip", "tail", rump + Vec3(0, 0.75 * tail, -0.8 * tail));
  for (const bool front : {true, false})
    for (int s = 0; s < 2; ++s) {
      const int side = s == 0 ? 1 : -1;
      const std::string name = front ? "fore_" : "hind_", end = kSides[s];
      const auto at = [&](double x, double h, double z) { return across({x, h, z}, side); };
      const double x = 0.62 * girth, z = front ? 0.1 : -length / 2 - 0.04;
      const double bend = front ? -0.02 : 0.03;
      const Vec3 top = at(x, y - 0.06, z), knee = at(x, 0.08 + 0.45 * leg, z + bend),
                 ankle = at(x, 0.07, z - bend);
      b.joint(name + "thigh" + end, front ? "chest" : "body", top, 30,
              {{limb(top, 0.1 * stout, knee, 0.062).in(fur)}, 0, {}});
      b.joint(name + "shin" + end, name + "thigh" + end, knee, 30,
              {{limb(knee, 0.062, ankle, 0.046).in(fur)}, 0, {}});
      b.joint(name + "paw" + end, name + "shin" + end, ankle, 15,
              {{ball(ankle, 0.05).in(dark),
                ellipsoid(ankle + Vec3(0, -0.025, 0.04), {0.055, 0.045, 0.08}).in(dark)},
               0.03,
               {}});
      b.tip(name + "paw.tip" + end, name + "paw" + end, ankle + Vec3(0, -0.03, 0.11));
    }
  b.pair_mirrors();
  return b.take();
}

Figure robot(std::uint64_t seed) {
  Random r(seed + 303);
  const unsigned steel = 0x9fb0ba, dark = 0x4c5a66, accent = 0xf0a530;
  const double wide = r.around(0.26, 0.05), tall = r.around(0.26, 0.04);

  Builder b("robot");
  const double hip = 0.62, waist = 0.74, neck = waist + 2 * tall;
  b.joint("hips", "", {0, hip, 0}, 0,
          {{box({0, hip, 0}, {0.8 * wide, 0.11, 0.14}, 0.05).in(dark),
            limb({0, hip, 0}, 0.09, {0, waist, 0}, 0.09).in(dark)},
           0.02,
           {}});
  b.joint("chest", "hips", {0, waist, 0}, 12,
          {{box({0, waist + tall, 0}, {wide, 1.05 * tall, 0.19}, 0.06).in(steel),
            limb({0.3 * wide, neck - 0.05, -0.15}, 0.05, {0.3 * wide, neck + 0.14, -0.17}, 0.04)
                .in(dark)},
           0.02,
           {ball({-0.1, waist + 1.2 * tall, 0.2}, 0.07).in(accent)}});
  b.joint("head", "chest", {0, neck, 0}, 30,
          {{box({0, neck + 0.16, 0.02}, {0.19, 0.14, 0.16}, 0.05).in(steel),
            limb({0, neck, 0}, 0.06, {0, neck + 0.08, 0}, 0.06).in(dark),
            limb({0.1, neck + 0.28, 0}, 0.018, {0.15, neck + 0.45, 0}, 0.018).in(dark),
            ball({0.15, neck + 0.46, 0}, 0.04).in(accent)},
           0.02,
           {ball({0.075, neck + 0.19, 0.19}, 0.062).in(dark),
            ball({-0.075, neck + 0.19, 0.19}, 0.062).in(dark),
            ball({0.075, neck + 0.19, 0.19}, 0.047).in(accent),
            ball({-0.075, neck + 0.19, 0.19}, 0.047).in(accent),
            box({0, neck + 0.085, 0.18}, {0.07, 0.014, 0.05}, 0.01).in(dark)}});
  b.tip("head.tip", "head", {0, neck + 0.3, 0});
  // The left arm is a long thin gripper, the right one a short heavy hammer.
  const double y = neck - 0.12;
  const auto arm = [&](const std::string& end, int side, double length, double radius,
                       const Solid& hand) {
    const Vec3 shoulder(side * (wide + 0.03), y, 0), elbow = shoulder + Vec3(side * length, 0, 0),
                                                     wrist = elbow + Vec3(side * length, 0, 0);
    b.joint("upper_arm" + end, "chest", shoulder, 40,
            {{limb(shoulder, radius, elbow, 0.8 * radius).in(dark),
              ball(shoulder, 1.4 * radius).in(steel)},
             0.02,
             {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 45,
            {{limb(elbow, radius, wrist, radius).in(steel)}, 0.02, {}});
    Solid moved = hand;
    for (Blob& blob : moved.blobs) blob.a += wrist, blob.b += wrist;
    b.joint("hand" + end, "forearm" + end, wrist, 20, moved);
    b.tip("hand.tip" + end, "hand" + end, wrist + Vec3(side * 0.15, 0, 0));
  };
  arm(".L", 1, r.around(0.3, 0.04), 0.055,
      {{ball(Vec3::Zero(), 0.065).in(dark), limb({0, 0, 0}, 0.04, {0.13, 0.09, 0}, 0.03).in(accent),
        limb({0, 0, 0}, 0.04, {0.13, -0.09, 0}, 0.03).in(accent)},
       0.02,
       {}});
  arm(".R", -1, r.around(0.22, 0.03), 0.08,
      {{ball(Vec3::Zero(), 0.085).in(dark), box({-0.12, 0, 0}, {0.1, 0.13, 0.11}, 0.03).in(accent)},
       0.02,
       {}});
  for (int s = 0; s < 2; ++s) {
    const int side = s == 0 ? 1 : -1;
    const std::string end = kSides[s];
    const Vec3 top(side * 0.12, hip - 0.06, 0), knee(side * 0.13, 0.34, 0.02),
        ankle(side * 0.14, 0.1, 0);
    const double thick = s == 0 ? 0.075 : 0.095;
    b.joint("thigh" + end, "hips", top, 30, {{limb(top, thick, knee, thick).in(steel)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 30,
            {{limb(knee, 1.12 * thick, ankle, 1.15 * thick).in(dark)}, 0, {}});
    b.joint("foot" + end, "shin" + end, ankle, 12,
            {{ball(ankle, 1.1 * thick).in(accent),
              box(ankle + Vec3(0, -0.05, 0.05), {0.1, 0.05, 0.16}, 0.03).in(accent)},
             0.02,
             {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + Vec3(0, -0.05, 0.2));
  }
  return b.take();
}

}  // namespace artisketch::figures

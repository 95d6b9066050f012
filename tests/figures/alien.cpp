// The alien of the paper's tenth figure, drawn anew: thin limbs, three fingers to a hand.
#include "figures/builder.h"
#include "figures/examples.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSkin = 0x86bf5c, kBelly = 0xd3e7a2, kSpot = 0x5e9a49, kSuit = 0x7a5aa6,
                   kBelt = 0xf1b43c, kEye = 0x241f36, kGleam = 0xfffdf6, kSheen = 0x5a4f8c,
                   kMouth = 0x3f6a35, kTip = 0xf08fb0;

Solid hips() {
  return {{ellipsoid({0, 0.63, 0.01}, {0.148, 0.13, 0.132}).in(kSuit),
           ellipsoid({0, 0.73, 0.012}, {0.145, 0.03, 0.13}).in(kBelt)},
          0.03,
          {box({0, 0.73, 0.02}, {0.3, 0.024, 0.3}, 0.005).in(kBelt),
           ellipsoid({0, 0.73, 0.15}, {0.036, 0.036, 0.06}).in(kGleam),
           ellipsoid({0, 0.73, 0.15}, {0.022, 0.022, 0.07}).in(kTip)}};
}

Solid chest() {
  return {{limb({0, 0.8, 0}, 0.12, {0, 0.9, -0.005}, 0.088).in(kSkin),
           limb({-0.05, 0.965, -0.01}, 0.056, {0.05, 0.965, -0.01}, 0.056).in(kSkin),
           limb({0, 0.95, 0}, 0.05, {0, 1.1, 0}, 0.036).in(kSkin)},
          0.05,
          {ellipsoid({0, 0.83, 0.12}, {0.075, 0.13, 0.07}).in(kBelly),
           ball({0.03, 0.9, -0.09}, 0.026).in(kSpot), ball({-0.04, 0.84, -0.115}, 0.03).in(kSpot),
           ball({0.05, 0.8, -0.105}, 0.022).in(kSpot)}};
}

Solid head() {
  Solid solid;
  solid.blend = 0.06;
  solid.blobs = {ellipsoid({0, 1.42, -0.03}, {0.262, 0.225, 0.255}).in(kSkin),
                 limb({0, 1.34, 0.04}, 0.17, {0, 1.2, 0.085}, 0.085).in(kSkin),
                 limb({0, 1.08, 0}, 0.037, {0, 1.2, 0.02}, 0.05).in(kSkin)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    // Feelers with a knob.
    solid.blobs.push_back(limb(at(0.09, 1.6, -0.02), 0.026, at(0.15, 1.76, -0.01), 0.02).in(kSkin));
    solid.blobs.push_back(ball(at(0.16, 1.79, -0.005), 0.044).in(kTip));
    const Quat slant = about_z(side * 24);
    const Vec3 eye = at(0.108, 1.36, 0.19);
    solid.paint.push_back(ellipsoid(eye, {0.08, 0.112, 0.15}, slant).in(kEye));
    solid.paint.push_back(
        ellipsoid(eye + at(0.012, -0.038, 0), {0.05, 0.052, 0.16}, slant).in(kSheen));
    solid.paint.push_back(
        ellipsoid(eye + at(0.006, -0.018, 0), {0.054, 0.056, 0.165}, slant).in(kEye));
    solid.paint.push_back(ellipsoid(eye + Vec3(0.026, 0.05, 0), {0.02, 0.026, 0.17}).in(kGleam));
    solid.paint.push_back(ball(at(0.014, 1.225, 0.175), 0.007).in(kMouth));
  }
  for (const Vec3& spot : {Vec3(0.1, 1.55, -0.2), Vec3(-0.06, 1.6, -0.16), Vec3(0.02, 1.47, -0.28),
                           Vec3(-0.17, 1.44, -0.2), Vec3(0.14, 1.36, -0.24)})
    solid.paint.push_back(ball(spot, 0.042).in(kSpot));
  for (int i = 0; i < 6; ++i) {  // a smile
    const double u = i / 3.0 - 1, v = (i + 1) / 3.0 - 1;
    solid.paint.push_back(limb({0.05 * u, 1.165 + 0.016 * u * u, 0.165}, 0.0085,
                               {0.05 * v, 1.165 + 0.016 * v * v, 0.165}, 0.0085)
                              .in(kMouth));
  }
  return solid;
}

// Fingers or toes: thin, with a round end.
void add_digits(Solid& solid, const Vec3& from, std::initializer_list<Vec3> ends, double radius) {
  for (const Vec3& end : ends) {
    solid.blobs.push_back(limb(from, 1.2 * radius, end, radius).in(kSkin));
    solid.blobs.push_back(ball(end, 1.5 * radius).in(kSkin));
  }
}

Solid hand(const Vec3& wrist, int side) {
  Solid solid{{limb(wrist, 0.032, wrist + Vec3(side * 0.05, 0, 0), 0.042).in(kSkin)}, 0.012, {}};
  const auto at = [&](double x, double y, double z) { return Vec3(wrist + Vec3(side * x, y, z)); };
  add_digits(solid, at(0.06, 0, 0), {at(0.175, 0.004, 0.055), at(0.185, 0.004, -0.045)}, 0.019);
  add_digits(solid, at(0.03, 0, 0.015), {at(0.07, -0.01, 0.12)}, 0.019);
  return solid;
}

Solid foot(const Vec3& ankle, int side) {
  Solid solid{{limb(ankle, 0.042, ankle + Vec3(0, -0.045, 0.03), 0.048).in(kSkin)}, 0.016, {}};
  const auto at = [&](double x, double y, double z) { return Vec3(ankle + Vec3(side * x, y, z)); };
  add_digits(solid, at(0, -0.055, 0.04),
             {at(0.075, -0.062, 0.13), at(0.005, -0.062, 0.165), at(-0.062, -0.062, 0.12)}, 0.026);
  return solid;
}

Solid thin(const Vec3& from, double radius, const Vec3& to, double knob) {
  return {{limb(from, radius, to, radius).in(kSkin), ball(to, knob).in(kSkin)}, 0.015, {}};
}

}  // namespace

Figure alien() {
  Builder b("alien");
  b.joint("hips", "", {0, 0.65, 0}, 0, hips());
  b.joint("chest", "hips", {0, 0.76, 0}, 12, chest());
  b.joint("head", "chest", {0, 1.1, 0}, 20, head());
  b.tip("head.tip", "head", {0, 1.62, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.1, 0.965, -0.01), elbow = at(0.335, 0.965, -0.015),
               wrist = at(0.565, 0.965, -0.01);
    b.joint("upper_arm" + end, "chest", shoulder, 40, thin(shoulder, 0.036, elbow, 0.042));
    b.joint("forearm" + end, "upper_arm" + end, elbow, 45, thin(elbow, 0.034, wrist, 0.036));
    b.joint("hand" + end, "forearm" + end, wrist, 20, hand(wrist, side));
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.19, 0, 0));
    const Vec3 top = at(0.075, 0.57, 0), knee = at(0.085, 0.33, 0.012),
               ankle = at(0.09, 0.11, -0.005);
    b.joint(
        "thigh" + end, "hips", top, 30,
        {{limb(top, 0.066, top + 0.35 * (knee - top), 0.056).in(kSuit),
          limb(top + 0.4 * (knee - top), 0.044, knee, 0.042).in(kSkin), ball(knee, 0.05).in(kSkin)},
         0.01,
         {}});
    b.joint("shin" + end, "thigh" + end, knee, 30, thin(knee, 0.042, ankle, 0.044));
    b.joint("foot" + end, "shin" + end, ankle, 15, foot(ankle, side));
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.06, 0.19));
  }
  b.pair_mirrors();
  return b.take();
}

Example alien_landed() {
  Figure figure = alien();
  const Camera camera{Camera::Type::orthographic, 400};
  const std::vector<View> views = {
      view(figure, "front", about_x(4) * about_y(8),
           {{"chest", about_z(3)},
            {"head", about_z(7) * about_y(-4)},
            {"upper_arm.L", about_z(-26)},
            {"forearm.L", about_z(104)},
            {"hand.L", about_x(-80) * about_y(8)},
            {"upper_arm.R", about_z(42)},
            {"forearm.R", about_z(16)},
            {"hand.R", about_x(-60)},
            {"thigh.L", about_z(10)},
            {"thigh.R", about_z(-8)},
            {"foot.L", about_y(16)},
            {"foot.R", about_y(-18)}},
           {0, -0.26, 0}),
      view(figure, "side", about_y(68),
           {{"head", about_y(-10) * about_x(-4)},
            {"upper_arm.L", about_x(34) * about_z(-62)},
            {"forearm.L", about_y(-32)},
            {"hand.L", about_x(-40)},
            {"upper_arm.R", about_y(62) * about_z(6)},
            {"forearm.R", about_y(14) * about_z(-18)},
            {"hand.R", about_x(50)},
            {"thigh.L", about_x(-30)},
            {"shin.L", about_x(16)},
            {"thigh.R", about_x(20)},
            {"shin.R", about_x(26)},
            {"foot.R", about_x(10)}},
           {0, -0.26, 0}),
      view(figure, "behind", about_x(6) * about_y(-140),
           {{"head", about_y(-28) * about_z(-4)},
            {"upper_arm.L", about_z(-48)},
            {"forearm.L", about_z(-14) * about_y(-12)},
            {"hand.L", about_x(50)},
            {"upper_arm.R", about_z(4)},
            {"forearm.R", about_z(-72)},
            {"hand.R", about_x(70)},
            {"thigh.L", about_x(-12) * about_z(6)},
            {"thigh.R", about_x(12)},
            {"shin.R", about_x(12)}},
           {0, -0.26, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 640, 800, {.pose_error_degrees = 7, .root_error = 0.02}, 14);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

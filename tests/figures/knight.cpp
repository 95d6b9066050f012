// A knight of 64 pixels.
#include "figures/builder.h"
#include "figures/examples.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSteel = 0xb9c4d6, kDarkSteel = 0x74839c, kPlume = 0xd8403c, kTabard = 0x3f62b5,
                   kGold = 0xf0c243, kSlit = 0x26222f, kLeather = 0x7c4f30;

Solid hips() {
  return {{ellipsoid({0, 0.5, 0}, {0.17, 0.11, 0.15}).in(kDarkSteel),
           limb({0, 0.63, 0}, 0.165, {0, 0.47, 0}, 0.2).in(kTabard),
           ellipsoid({0, 0.65, 0}, {0.19, 0.04, 0.18}).in(kLeather)},
          0.03,
          {}};
}

Solid chest() {
  return {{limb({0, 0.87, 0}, 0.17, {0, 0.74, 0}, 0.165).in(kTabard),
           limb({-0.11, 0.88, -0.01}, 0.1, {0.11, 0.88, -0.01}, 0.1).in(kSteel)},
          0.03,
          {box({0, 0.83, 0.2}, {0.045, 0.13, 0.2}, 0.01).in(kGold),
           box({0, 0.85, 0.2}, {0.12, 0.045, 0.2}, 0.01).in(kGold)}};
}

// A great helm with a slit to look through, and a plume that falls back.
Solid head() {
  return {{limb({0, 1.18, 0}, 0.25, {0, 1.34, 0}, 0.245).in(kSteel),
           limb({0, 0.97, 0}, 0.1, {0, 1.06, 0}, 0.12).in(kDarkSteel),
           limb({0, 1.58, 0.06}, 0.07, {0, 1.68, -0.08}, 0.1).in(kPlume),
           limb({0, 1.68, -0.08}, 0.1, {0, 1.56, -0.28}, 0.095).in(kPlume),
           limb({0, 1.56, -0.28}, 0.095, {0, 1.36, -0.36}, 0.04).in(kPlume)},
          0.02,
          {box({0, 1.27, 0.22}, {0.19, 0.045, 0.2}, 0.01).in(kSlit),
           box({0, 1.1, 0.25}, {0.032, 0.14, 0.14}, 0.01).in(kGold),
           box({0, 1.44, 0.02}, {0.4, 0.03, 0.25}, 0.005).in(kGold)}};
}

Figure knight() {
  Builder b("knight");
  b.joint("hips", "", {0, 0.54, 0}, 0, hips());
  b.joint("chest", "hips", {0, 0.67, 0}, 12, chest());
  b.joint("head", "chest", {0, 0.98, 0}, 18, head());
  b.tip("head.tip", "head", {0, 1.65, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.19, 0.88, -0.01), elbow = at(0.36, 0.88, -0.01),
               wrist = at(0.51, 0.88, -0.01);
    b.joint("upper_arm" + end, "chest", shoulder, 35,
            {{ball(shoulder + at(0.03, 0.01, 0), 0.125).in(kSteel),
              limb(shoulder, 0.09, elbow, 0.08).in(kSteel)},
             0.01,
             {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 40,
            {{limb(elbow, 0.08, wrist, 0.095).in(kSteel)}, 0, {}});
    b.joint("hand" + end, "forearm" + end, wrist, 15,
            {{limb(wrist, 0.08, wrist + at(0.09, 0, 0), 0.09).in(kLeather)}, 0, {}});
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.18, 0, 0));
    const Vec3 top = at(0.1, 0.46, 0), knee = at(0.11, 0.3, 0.01), ankle = at(0.115, 0.12, 0);
    b.joint("thigh" + end, "hips", top, 30,
            {{limb(top, 0.105, knee, 0.095).in(kDarkSteel)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 30,
            {{limb(knee, 0.1, ankle, 0.095).in(kSteel)}, 0, {}});
    b.joint("foot" + end, "shin" + end, ankle, 12,
            {{limb(ankle, 0.09, ankle + at(0, -0.03, 0.01), 0.09).in(kDarkSteel),
              ellipsoid(ankle + at(0, -0.035, 0.08), {0.095, 0.085, 0.15}).in(kDarkSteel)},
             0.03,
             {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.04, 0.22));
  }
  b.pair_mirrors();
  return b.take();
}

}  // namespace

Example knight_in_pixels() {
  Figure figure = knight();
  const Camera camera{Camera::Type::orthographic, 33};
  const std::vector<View> views = {
      view(figure, "front", about_y(-14),
           {{"upper_arm.L", about_z(-52)},
            {"forearm.L", about_z(16)},
            {"upper_arm.R", about_z(44)},
            {"forearm.R", about_z(42)},
            {"thigh.L", about_z(10)},
            {"thigh.R", about_z(-9)}},
           {0, -0.37, 0}),
      view(figure, "side", about_y(74),
           {{"head", about_y(-8)},
            {"upper_arm.L", about_x(34) * about_z(-66)},
            {"forearm.L", about_y(-24)},
            {"upper_arm.R", about_x(-36) * about_z(66)},
            {"forearm.R", about_y(36)},
            {"thigh.L", about_x(-26)},
            {"shin.L", about_x(10)},
            {"thigh.R", about_x(24)},
            {"shin.R", about_x(16)}},
           {0.06, -0.38, 0}),
      view(figure, "behind", about_y(-148),
           {{"head", about_y(-10)},
            {"upper_arm.L", about_z(-44)},
            {"forearm.L", about_z(-18)},
            {"upper_arm.R", about_z(56)},
            {"thigh.L", about_z(8) * about_x(-12)},
            {"thigh.R", about_z(-8) * about_x(14)}},
           {0, -0.37, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 64, 64, {.pose_error_degrees = 6, .root_error = 0.02}, 23);
  InkStyle ink;
  ink.line = 1;
  ink.detail = 0;
  ink.wobble = 0;
  ink.shadow = 0xe4dce8;
  ink.medium = InkStyle::Medium::pixels;
  return finished(std::move(figure), std::move(s), ink);
}

}  // namespace artisketch::figures

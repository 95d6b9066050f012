// A gnome on its way, as games draw one: a sheet of four sprites, all from one side.
#include "figures/builder.h"
#include "figures/examples.h"
#include "figures/face.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSkin = 0xf3bf98, kCheek = 0xe98f78, kHat = 0xd0412f, kBand = 0xf2c14e,
                   kBeard = 0xf4efe4, kCoat = 0x3d6fa5, kBelt = 0x5c3b27, kTrousers = 0x5d6a3f,
                   kBoot = 0x7b4b2d, kMitten = 0xe3a83c, kDark = 0x33262b;

Solid hips() {
  return {{ellipsoid({0, 0.5, 0}, {0.15, 0.1, 0.13}).in(kTrousers),
           limb({0, 0.66, 0}, 0.16, {0, 0.56, 0}, 0.185).in(kCoat),
           ellipsoid({0, 0.65, 0}, {0.19, 0.035, 0.182}).in(kBelt)},
          0.03,
          {box({0, 0.65, 0.18}, {0.045, 0.034, 0.06}, 0.008).in(kBand),
           box({0, 0.65, 0.18}, {0.022, 0.016, 0.07}, 0.004).in(kBelt)}};
}

Solid chest() {
  return {{limb({0, 0.84, 0}, 0.14, {0, 0.71, 0}, 0.16).in(kCoat),
           limb({-0.1, 0.86, -0.01}, 0.09, {0.1, 0.86, -0.01}, 0.09).in(kCoat)},
          0.03,
          {}};
}

// The hat leans back; the beard hangs from the head, and goes with it.
Solid head() {
  Solid solid;
  solid.blend = 0.025;
  solid.blobs = {ellipsoid({0, 1.1, 0}, {0.19, 0.185, 0.185}).in(kSkin),
                 ball({0, 1.09, 0.195}, 0.05).in(kCheek),
                 limb({0, 0.95, 0}, 0.065, {0, 1.02, 0}, 0.07).in(kSkin),
                 limb({0, 1.02, 0.1}, 0.13, {0, 0.82, 0.185}, 0.085).in(kBeard),
                 limb({0, 0.82, 0.185}, 0.085, {0, 0.7, 0.215}, 0.02).in(kBeard),
                 ellipsoid({0, 1.04, -0.06}, {0.178, 0.12, 0.15}).in(kBeard),
                 ellipsoid({0, 1.205, -0.01}, {0.225, 0.05, 0.222}).in(kBand),
                 limb({0, 1.24, -0.01}, 0.195, {0, 1.42, -0.05}, 0.115).in(kHat),
                 limb({0, 1.42, -0.05}, 0.115, {0, 1.6, -0.13}, 0.05).in(kHat),
                 limb({0, 1.6, -0.13}, 0.05, {0, 1.66, -0.22}, 0.025).in(kHat)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.blobs.push_back(limb(at(0.13, 1.03, 0.08), 0.09, at(0.1, 0.87, 0.14), 0.06).in(kBeard));
    solid.blobs.push_back(limb(at(0.015, 1.05, 0.2), 0.035, at(0.1, 1.035, 0.19), 0.02).in(kBeard));
    solid.blobs.push_back(ellipsoid(at(0.19, 1.1, -0.01), {0.04, 0.06, 0.04}).in(kSkin));
    for (const Blob& blob : painted_eye(at(0.075, 1.14, 0.16), side, 0.62, 0x4d6d8a, kDark))
      solid.paint.push_back(blob);
  }
  return solid;
}

Figure gnome() {
  Builder b("gnome");
  b.joint("hips", "", {0, 0.54, 0}, 0, hips());
  b.joint("chest", "hips", {0, 0.67, 0}, 12, chest());
  b.joint("head", "chest", {0, 0.96, 0}, 15, head());
  b.tip("head.tip", "head", {0, 1.6, -0.1});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.165, 0.865, -0.01), elbow = at(0.33, 0.865, -0.015),
               wrist = at(0.48, 0.865, -0.01);
    b.joint("upper_arm" + end, "chest", shoulder, 35,
            {{limb(shoulder, 0.08, elbow, 0.07).in(kCoat)}, 0, {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 40,
            {{limb(elbow, 0.07, wrist, 0.078).in(kCoat)},
             0,
             {box(wrist + at(0.05, 0, 0), {0.06, 0.2, 0.2}, 0.01).in(kBand)}});
    b.joint("hand" + end, "forearm" + end, wrist, 15,
            {{limb(wrist, 0.062, wrist + at(0.07, 0, 0), 0.07).in(kMitten),
              limb(wrist + at(0.03, 0.01, 0.04), 0.032, wrist + at(0.07, 0.02, 0.09), 0.026)
                  .in(kMitten)},
             0.02,
             {}});
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.14, 0, 0));
    const Vec3 top = at(0.09, 0.46, 0), knee = at(0.095, 0.29, 0.01), ankle = at(0.1, 0.11, -0.005);
    b.joint("thigh" + end, "hips", top, 30, {{limb(top, 0.095, knee, 0.082).in(kTrousers)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 30,
            {{limb(knee, 0.082, knee + at(0, -0.05, 0), 0.08).in(kTrousers),
              limb(ankle + at(0, 0.08, 0), 0.09, ankle, 0.078).in(kBoot)},
             0.01,
             {}});
    b.joint("foot" + end, "shin" + end, ankle, 15,
            {{limb(ankle, 0.078, ankle + at(0, -0.03, 0.01), 0.08).in(kBoot),
              ellipsoid(ankle + at(0, -0.035, 0.08), {0.085, 0.072, 0.14}).in(kBoot)},
             0.04,
             {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.04, 0.2));
  }
  b.pair_mirrors();
  return b.take();
}

}  // namespace

Example gnome_walking() {
  Figure figure = gnome();
  const Camera camera{Camera::Type::orthographic, 230};
  // Contact, passing, and both again with the other leg; the arms swing against the legs.
  const auto step = [&](const char* name, double left, double right, double lift_left,
                        double lift_right, double height) {
    return view(figure, name, about_y(62),
                {{"chest", about_y(0.2 * (left - right))},
                 {"head", about_y(0.15 * (right - left))},
                 {"upper_arm.L", about_x(-left) * about_z(-68)},
                 {"forearm.L", about_y(-32)},
                 {"upper_arm.R", about_x(-right) * about_z(68)},
                 {"forearm.R", about_y(32)},
                 {"thigh.L", about_x(left)},
                 {"shin.L", about_x(lift_left)},
                 {"foot.L", about_x(-0.4 * (left + lift_left))},
                 {"thigh.R", about_x(right)},
                 {"shin.R", about_x(lift_right)},
                 {"foot.R", about_x(-0.4 * (right + lift_right))}},
                {0, height, 0});
  };
  const std::vector<View> views = {
      step("contact", -30, 26, 4, 16, -0.33), step("passing", 4, -22, 2, 52, -0.3),
      step("contact-2", 26, -30, 16, 4, -0.33), step("passing-2", -22, 4, 52, 2, -0.3)};
  Sketches s =
      draw(figure, views, camera, 320, 440, {.pose_error_degrees = 6, .root_error = 0.015}, 19);
  InkStyle ink;
  ink.line = 2.4;
  ink.detail = 1.3;
  return finished(std::move(figure), std::move(s), ink);
}

}  // namespace artisketch::figures

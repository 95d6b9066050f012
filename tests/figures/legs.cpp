// The dancer's legs of the paper's eighth figure, drawn anew: in tights and leg warmers.
#include "figures/builder.h"
#include "figures/examples.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kLeotard = 0x5b3f8f, kTights = 0x57a8b8, kWarmer = 0xf07fa8, kStripe = 0xfdf1dc,
                   kShoe = 0xfdf8ee, kSole = 0xd9a441, kBelt = 0xf2bd3d;

Solid hips() {
  return {{ellipsoid({0, 0.93, 0}, {0.165, 0.115, 0.13}).in(kLeotard),
           limb({0, 0.97, 0}, 0.118, {0, 1.08, 0}, 0.1).in(kLeotard),
           ellipsoid({0.06, 0.9, -0.06}, {0.09, 0.095, 0.085}).in(kLeotard),
           ellipsoid({-0.06, 0.9, -0.06}, {0.09, 0.095, 0.085}).in(kLeotard),
           ellipsoid({0, 1.06, 0}, {0.13, 0.03, 0.13}).in(kBelt)},
          0.04,
          {box({0, 1.06, 0}, {0.5, 0.026, 0.5}, 0.005).in(kBelt)}};
}

Solid thigh(const Vec3& top, const Vec3& knee) {
  return {{limb(top, 0.105, top + 0.4 * (knee - top), 0.096).in(kTights),
           limb(top + 0.4 * (knee - top), 0.096, knee, 0.066).in(kTights)},
          0.03,
          {}};
}

// The calf, and a warmer in wide rolls about it.
Solid shin(const Vec3& knee, const Vec3& ankle) {
  const auto along = [&](double t) { return Vec3(knee + t * (ankle - knee)); };
  Solid solid{{limb(knee, 0.066, along(0.3) + Vec3(0, 0, -0.014), 0.07).in(kTights),
               limb(along(0.3) + Vec3(0, 0, -0.014), 0.068, ankle, 0.05).in(kTights)},
              0.015,
              {}};
  constexpr int kRolls = 5;
  for (int i = 0; i < kRolls; ++i) {
    const double t = 0.42 + 0.125 * i, radius = 0.088 - 0.002 * i + (i == kRolls - 1 ? 0.008 : 0);
    solid.blobs.push_back(
        ellipsoid(along(t), {radius, 0.04, radius}).in(i % 2 ? kStripe : kWarmer));
  }
  return solid;
}

Solid foot(const Vec3& ankle) {
  const auto at = [&](double y, double z) { return Vec3(ankle + Vec3(0, y, z)); };
  return {{limb(ankle, 0.05, at(-0.04, 0.0), 0.054).in(kTights),
           limb(at(-0.06, -0.015), 0.05, at(-0.065, 0.09), 0.05).in(kShoe),
           limb(at(-0.065, 0.09), 0.05, at(-0.075, 0.17), 0.036).in(kShoe)},
          0.025,
          {box(at(-0.125, 0.07), {0.3, 0.028, 0.4}, 0.004).in(kSole)}};
}

}  // namespace

Figure legs() {
  Builder b("legs");
  b.joint("hips", "", {0, 0.95, 0}, 0, hips());
  b.tip("hips.tip", "hips", {0, 1.15, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 top = at(0.085, 0.88, 0), knee = at(0.09, 0.5, 0.015),
               ankle = at(0.092, 0.12, -0.005);
    b.joint("thigh" + end, "hips", top, 35, thigh(top, knee));
    b.joint("shin" + end, "thigh" + end, knee, 35, shin(knee, ankle));
    b.joint("foot" + end, "shin" + end, ankle, 20, foot(ankle));
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.07, 0.2));
  }
  b.pair_mirrors();
  return b.take();
}

Example legs_dancing() {
  Figure figure = legs();
  const Camera camera{Camera::Type::orthographic, 410};
  const std::vector<View> views = {
      view(figure, "pose", about_x(3) * about_y(-28),
           {{"thigh.L", about_z(16) * about_x(-58)},
            {"shin.L", about_x(86)},
            {"foot.L", about_x(44)},
            {"thigh.R", about_z(-6)},
            {"foot.R", about_y(-20) * about_x(10)}},
           {0, 0.28, 0}),
      view(figure, "kick", about_y(68) * about_x(-4),
           {{"thigh.L", about_x(-78)},
            {"shin.L", about_x(10)},
            {"foot.L", about_x(42)},
            {"thigh.R", about_x(10)},
            {"shin.R", about_x(8)},
            {"foot.R", about_x(20)}},
           {-0.3, 0.28, 0}),
      view(figure, "behind", about_x(5) * about_y(-152),
           {{"thigh.L", about_z(26) * about_x(-4)},
            {"shin.L", about_x(8)},
            {"foot.L", about_x(40)},
            {"thigh.R", about_z(-8) * about_x(-16)},
            {"shin.R", about_x(28)},
            {"foot.R", about_x(4)}},
           {0, 0.28, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 560, 640, {.pose_error_degrees = 7, .root_error = 0.02}, 17);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

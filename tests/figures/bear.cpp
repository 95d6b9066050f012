// A bear, in pencil on paper.
#include "figures/builder.h"
#include "figures/examples.h"

namespace artisketch::figures {
namespace {

// Graphite has no other colours: how dark a pencil lays them.
constexpr unsigned kFur = 0xb4b0aa, kLight = 0xe6e2da, kNose = 0x5a5753, kScarf = 0x8b8782,
                   kEye = 0x4c4945;

Solid body() {
  return {{ellipsoid({0, 0.52, 0}, {0.26, 0.27, 0.24}).in(kFur),
           ellipsoid({0, 0.74, 0}, {0.2, 0.2, 0.18}).in(kFur)},
          0.06,
          {ellipsoid({0, 0.52, 0.24}, {0.17, 0.2, 0.12}).in(kLight)}};
}

Solid head() {
  Solid solid;
  solid.blend = 0.03;
  solid.blobs = {ellipsoid({0, 1.16, 0}, {0.27, 0.235, 0.23}).in(kFur),
                 ellipsoid({0, 1.09, 0.18}, {0.13, 0.105, 0.12}).in(kLight),
                 ellipsoid({0, 1.135, 0.295}, {0.05, 0.036, 0.03}).in(kNose),
                 limb({0, 0.88, 0}, 0.13, {0, 1.0, 0}, 0.14).in(kFur)};
  constexpr int kPieces = 12;
  const auto ring = [](int i) {
    const double turn = 2 * kPi * i / kPieces;
    return Vec3(0.15 * std::sin(turn), 0.93 - 0.02 * std::cos(turn), 0.14 * std::cos(turn));
  };
  for (int i = 0; i < kPieces; ++i)
    solid.blobs.push_back(limb(ring(i), 0.05, ring(i + 1), 0.05).in(kScarf));
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.blobs.push_back(ellipsoid(at(0.2, 1.36, -0.01), {0.1, 0.1, 0.07}).in(kFur));
    solid.paint.push_back(ellipsoid(at(0.2, 1.36, 0.06), {0.06, 0.06, 0.04}).in(kLight));
    solid.paint.push_back(ball(at(0.1, 1.2, 0.21), 0.034).in(kEye));
  }
  return solid;
}

Figure bear() {
  Builder b("bear");
  b.joint("body", "", {0, 0.55, 0}, 0, body());
  b.joint("head", "body", {0, 0.93, 0}, 20, head());
  b.tip("head.tip", "head", {0, 1.4, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.18, 0.79, 0), elbow = at(0.36, 0.79, 0), wrist = at(0.52, 0.79, 0);
    b.joint("upper_arm" + end, "body", shoulder, 35,
            {{limb(shoulder, 0.1, elbow, 0.088).in(kFur)}, 0, {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 40,
            {{limb(elbow, 0.088, wrist, 0.096).in(kFur)},
             0,
             {box(wrist + at(0.1, 0, 0), {0.055, 0.2, 0.2}, 0.01).in(kLight)}});
    b.tip("forearm.tip" + end, "forearm" + end, wrist + at(0.1, 0, 0));
    const Vec3 top = at(0.13, 0.4, 0), knee = at(0.14, 0.25, 0.01), ankle = at(0.145, 0.11, 0);
    b.joint("thigh" + end, "body", top, 30, {{limb(top, 0.12, knee, 0.105).in(kFur)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 30,
            {{limb(knee, 0.105, ankle, 0.095).in(kFur),
              ellipsoid(ankle + at(0, -0.03, 0.07), {0.1, 0.075, 0.15}).in(kFur)},
             0.04,
             {box(ankle + at(0, -0.12, 0.08), {0.2, 0.05, 0.3}, 0.005).in(kLight)}});
    b.tip("shin.tip" + end, "shin" + end, ankle + at(0, -0.03, 0.2));
  }
  b.pair_mirrors();
  return b.take();
}

}  // namespace

Example bear_in_pencil() {
  Figure figure = bear();
  const Camera camera{Camera::Type::orthographic, 400};
  const std::vector<View> views = {
      view(figure, "front", about_y(-10),
           {{"head", about_z(8)},
            {"upper_arm.L", about_z(34)},
            {"forearm.L", about_z(36)},
            {"upper_arm.R", about_z(52)},
            {"forearm.R", about_z(14)},
            {"thigh.L", about_z(12)},
            {"thigh.R", about_z(-10)}},
           {0, -0.16, 0}),
      view(figure, "side", about_y(70),
           {{"head", about_y(-14)},
            {"upper_arm.L", about_x(30) * about_z(-60)},
            {"forearm.L", about_y(-26)},
            {"upper_arm.R", about_x(-40) * about_z(58)},
            {"forearm.R", about_y(40)},
            {"thigh.L", about_x(-34)},
            {"shin.L", about_x(16)},
            {"thigh.R", about_x(22)},
            {"shin.R", about_x(14)}},
           {0, -0.16, 0}),
      view(figure, "behind", about_x(4) * about_y(-145),
           {{"head", about_y(-24)},
            {"upper_arm.L", about_z(-36)},
            {"forearm.L", about_z(-24)},
            {"upper_arm.R", about_z(-30)},
            {"forearm.R", about_z(-20)},
            {"thigh.L", about_x(-14) * about_z(6)},
            {"thigh.R", about_x(12) * about_z(-8)}},
           {0, -0.16, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 600, 700, {.pose_error_degrees = 7, .root_error = 0.02}, 29);
  InkStyle pencil;
  pencil.line = 2.6;
  pencil.detail = 1.8;
  pencil.wobble = 0.9;
  pencil.ink = 0x55524f;
  pencil.shadow = 0xc4c4c4;
  pencil.medium = InkStyle::Medium::pencil;
  return finished(std::move(figure), std::move(s), pencil);
}

}  // namespace artisketch::figures

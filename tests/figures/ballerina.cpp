// The ballet dancer of the paper's eleventh figure, drawn anew: in attitude and arabesque.
#include "figures/builder.h"
#include "figures/examples.h"
#include "figures/face.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSkin = 0xf3c7a2, kCheek = 0xf0a99a, kHair = 0x5a3328, kBodice = 0xd45c82,
                   kTulle = 0xfbe4ec, kEdge = 0xf0a9c0, kTights = 0xf7dfd2, kShoe = 0xe57f9d,
                   kGold = 0xf2c14e, kDark = 0x33262b, kLip = 0xc24d58;

Solid hips() {
  return {{ellipsoid({0, 0.885, 0}, {0.128, 0.09, 0.105}).in(kBodice),
           limb({0, 0.93, 0}, 0.1, {0, 1.0, 0}, 0.082).in(kBodice)},
          0.05,
          {}};
}

// A plate of tulle, scalloped, with a smaller one on it.
Solid tutu() {
  Solid solid;
  solid.blend = 0.07;
  solid.blobs = {ellipsoid({0, 0.955, 0}, {0.35, 0.03, 0.35}).in(kTulle),
                 ellipsoid({0, 0.98, 0}, {0.235, 0.035, 0.235}).in(kEdge)};
  constexpr int kScallops = 14;
  for (int i = 0; i < kScallops; ++i) {
    const double turn = 2 * kPi * (i + 0.5) / kScallops;
    solid.blobs.push_back(
        ellipsoid({0.345 * std::sin(turn), 0.948, 0.345 * std::cos(turn)}, {0.07, 0.024, 0.07})
            .in(kTulle));
  }
  return solid;
}

Solid chest() {
  Solid solid;
  solid.blend = 0.03;
  solid.blobs = {limb({0, 1.02, 0}, 0.08, {0, 1.17, 0.005}, 0.106).in(kBodice),
                 limb({-0.075, 1.245, -0.01}, 0.064, {0.075, 1.245, -0.01}, 0.064).in(kSkin),
                 limb({0, 1.27, -0.005}, 0.05, {0, 1.36, 0}, 0.042).in(kSkin)};
  for (const int side : {1, -1}) {
    solid.blobs.push_back(ball({side * 0.046, 1.165, 0.066}, 0.056).in(kBodice));
    solid.paint.push_back(
        limb({side * 0.075, 1.14, 0.1}, 0.02, {side * 0.09, 1.33, 0.02}, 0.018).in(kBodice));
    solid.paint.push_back(
        limb({side * 0.075, 1.14, -0.1}, 0.02, {side * 0.09, 1.33, -0.02}, 0.018).in(kBodice));
  }
  solid.paint.push_back(ellipsoid({0, 1.12, 0.13}, {0.022, 0.1, 0.05}).in(kEdge));
  return solid;
}

Solid head() {
  Solid solid;
  solid.blend = 0.02;
  solid.blobs = {ellipsoid({0, 1.55, 0.01}, {0.152, 0.165, 0.152}).in(kSkin),
                 ellipsoid({0, 1.49, 0.025}, {0.122, 0.115, 0.125}).in(kSkin),
                 limb({0, 1.36, 0}, 0.043, {0, 1.46, 0}, 0.046).in(kSkin),
                 ball({0, 1.51, 0.158}, 0.018).in(kSkin),
                 ellipsoid({0, 1.58, -0.022}, {0.162, 0.165, 0.157}).in(kHair),
                 ellipsoid({0, 1.725, -0.085}, {0.09, 0.082, 0.09}).in(kHair)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.blobs.push_back(
        limb(at(0.03, 1.695, 0.07), 0.045, at(0.105, 1.62, 0.115), 0.026).in(kHair));
    solid.blobs.push_back(
        limb(at(0.105, 1.62, 0.115), 0.026, at(0.145, 1.53, 0.05), 0.026).in(kHair));
    solid.blobs.push_back(ellipsoid(at(0.15, 1.5, 0.0), {0.024, 0.036, 0.024}).in(kSkin));
    solid.paint.push_back(ball(at(0.165, 1.475, 0.005), 0.018).in(kGold));
    solid.paint.push_back(ellipsoid(at(0.094, 1.475, 0.125), {0.026, 0.017, 0.06}).in(kCheek));
    for (const Blob& blob : painted_eye(at(0.062, 1.53, 0.14), side, 0.56, 0x5b7f5a, kDark))
      solid.paint.push_back(blob);
    solid.paint.push_back(
        limb(at(0.034, 1.584, 0.15), 0.006, at(0.062, 1.597, 0.14), 0.006).in(kHair));
    solid.paint.push_back(
        limb(at(0.062, 1.597, 0.14), 0.006, at(0.096, 1.588, 0.12), 0.004).in(kHair));
  }
  solid.paint.push_back(ellipsoid({0, 1.448, 0.14}, {0.033, 0.02, 0.06}).in(kLip));
  solid.paint.push_back(ellipsoid({0, 1.462, 0.14}, {0.046, 0.02, 0.08}).in(kSkin));
  // A ribbon round the bun.
  solid.paint.push_back(
      ellipsoid({0, 1.668, -0.072}, {0.12, 0.022, 0.12}, about_x(-10)).in(kBodice));
  return solid;
}

Solid arm(const Vec3& from, double radius_from, const Vec3& to, double radius_to) {
  return {{limb(from, radius_from, to, radius_to).in(kSkin)}, 0, {}};
}

}  // namespace

Figure ballerina() {
  Builder b("ballerina");
  b.joint("hips", "", {0, 0.91, 0}, 0, hips());
  b.joint("tutu", "hips", {0, 0.965, 0}, 8, tutu());
  b.tip("tutu.tip", "tutu", {0, 0.965, 0.36});
  b.joint("chest", "hips", {0, 1.02, 0}, 15, chest());
  b.joint("head", "chest", {0, 1.37, 0}, 20, head());
  b.tip("head.tip", "head", {0, 1.72, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.12, 1.255, -0.01), elbow = at(0.345, 1.255, -0.012),
               wrist = at(0.55, 1.255, -0.005);
    b.joint("upper_arm" + end, "chest", shoulder, 40, arm(shoulder, 0.054, elbow, 0.042));
    b.joint("forearm" + end, "upper_arm" + end, elbow, 40, arm(elbow, 0.042, wrist, 0.031));
    b.joint("hand" + end, "forearm" + end, wrist, 20,
            {{limb(wrist, 0.031, wrist + at(0.06, 0, 0), 0.036).in(kSkin),
              limb(wrist + at(0.06, 0, 0), 0.034, wrist + at(0.15, -0.012, 0), 0.016).in(kSkin),
              limb(wrist + at(0.02, 0, 0.015), 0.02, wrist + at(0.075, -0.005, 0.055), 0.014)
                  .in(kSkin)},
             0.015,
             {}});
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.155, 0, 0));
  }
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 top = at(0.068, 0.86, 0), knee = at(0.072, 0.485, 0.012),
               ankle = at(0.074, 0.115, -0.005);
    b.joint("thigh" + end, "hips", top, 35, {{limb(top, 0.09, knee, 0.06).in(kTights)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 35,
            {{limb(knee, 0.06, knee + at(0.004, -0.11, -0.016), 0.062).in(kTights),
              limb(knee + at(0.004, -0.11, -0.016), 0.06, ankle, 0.04).in(kTights)},
             0.02,
             {ellipsoid(ankle + at(0, 0.1, 0), {0.1, 0.013, 0.1}, about_z(24)).in(kShoe),
              ellipsoid(ankle + at(0, 0.1, 0), {0.1, 0.013, 0.1}, about_z(-24)).in(kShoe)}});
    b.joint(
        "foot" + end, "shin" + end, ankle, 25,
        {{limb(ankle, 0.042, ankle + at(0, -0.035, 0.005), 0.046).in(kTights),
          limb(ankle + at(0, -0.06, 0.0), 0.042, ankle + at(0, -0.06, 0.09), 0.042).in(kShoe),
          limb(ankle + at(0, -0.06, 0.09), 0.042, ankle + at(0, -0.062, 0.175), 0.032).in(kShoe)},
         0.025,
         {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.06, 0.2));
  }
  b.pair_mirrors();
  return b.take();
}

Example ballerina_dancing() {
  Figure figure = ballerina();
  const Camera camera{Camera::Type::orthographic, 345};
  const std::vector<View> views = {
      view(figure, "attitude", about_y(-34),
           {{"chest", about_x(-6)},
            {"tutu", about_x(8)},
            {"head", about_y(16) * about_z(-5)},
            {"upper_arm.L", about_z(48)},
            {"forearm.L", about_z(52)},
            {"hand.L", about_z(30)},
            {"upper_arm.R", about_y(24) * about_z(4)},
            {"forearm.R", about_y(28) * about_z(-10)},
            {"thigh.L", about_z(14) * about_x(62)},
            {"shin.L", about_x(52)},
            {"foot.L", about_x(48)},
            {"foot.R", about_x(62)}},
           {-0.06, -0.12, 0}),
      view(figure, "arabesque", about_y(80) * about_x(14),
           {{"chest", about_x(-14)},
            {"tutu", about_x(12)},
            {"head", about_x(-10) * about_y(-12)},
            {"upper_arm.R", about_y(70) * about_z(-16)},
            {"forearm.R", about_y(10)},
            {"upper_arm.L", about_y(8) * about_z(-10)},
            {"forearm.L", about_z(-8)},
            {"thigh.L", about_x(68)},
            {"shin.L", about_x(6)},
            {"foot.L", about_x(52)},
            {"thigh.R", about_x(-12)},
            {"foot.R", about_x(58)}},
           {0.16, -0.1, 0}),
      view(figure, "behind", about_x(5) * about_y(-148),
           {{"head", about_y(-40) * about_z(3)},
            {"upper_arm.L", about_z(14) * about_y(-14)},
            {"forearm.L", about_z(16) * about_y(-14)},
            {"upper_arm.R", about_z(38)},
            {"forearm.R", about_z(24)},
            {"thigh.L", about_z(34) * about_x(-8)},
            {"shin.L", about_z(2)},
            {"foot.L", about_x(54)},
            {"foot.R", about_x(60)}},
           {0, -0.12, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 640, 800, {.pose_error_degrees = 7, .root_error = 0.02}, 13);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

// The masked climber of the paper's ninth figure, drawn anew: crouching, hanging, leaping.
#include "figures/builder.h"
#include "figures/examples.h"
#include "figures/face.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSkin = 0xf0be94, kMask = 0x2f5d73, kStripe = 0xf3ede0, kJacket = 0xee8338,
                   kTrousers = 0x6b7464, kHarness = 0x43404d, kMetal = 0xd5dbe0, kGlove = 0x43404d,
                   kShoe = 0xc6423d, kSole = 0x33262b, kRope = 0xf2d05f, kDark = 0x33262b;

Solid hips() {
  return {{ellipsoid({0, 0.86, 0}, {0.138, 0.1, 0.112}).in(kTrousers),
           ellipsoid({0, 0.935, 0}, {0.142, 0.034, 0.118}).in(kHarness),
           limb({0, 0.87, -0.13}, 0.058, {0, 0.8, -0.145}, 0.062).in(kStripe),  // chalk
           ellipsoid({0, 0.9, -0.13}, {0.064, 0.022, 0.064}).in(kMask)},
          0.025,
          {ellipsoid({0.13, 0.92, 0.03}, {0.03, 0.045, 0.03}).in(kMetal),
           ellipsoid({-0.13, 0.92, 0.03}, {0.03, 0.045, 0.03}).in(kMetal),
           box({0, 0.93, 0.13}, {0.034, 0.026, 0.05}, 0.008).in(kMetal),
           box({0, 0.93, 0.13}, {0.018, 0.012, 0.06}, 0.004).in(kHarness)}};
}

Solid chest() {
  Solid solid;
  solid.blend = 0.04;
  solid.blobs = {limb({0, 1.0, 0}, 0.105, {0, 1.19, 0}, 0.128).in(kJacket),
                 limb({-0.09, 1.275, -0.01}, 0.082, {0.09, 1.275, -0.01}, 0.082).in(kJacket),
                 limb({0, 1.33, -0.005}, 0.068, {0, 1.37, 0}, 0.068).in(kMask)};
  // A rope lies from the left shoulder to the right hip.
  solid.paint = {box({0, 1.16, 0.14}, {0.006, 0.2, 0.08}, 0.002).in(kHarness),
                 box({0, 1.15, 0}, {0.5, 0.034, 0.5}, 0.005, about_z(42)).in(kRope)};
  return solid;
}

Solid head() {
  Solid solid;
  solid.blend = 0.03;
  solid.blobs = {ellipsoid({0, 1.57, 0}, {0.172, 0.182, 0.175}).in(kMask),
                 ellipsoid({0, 1.5, 0.03}, {0.135, 0.122, 0.138}).in(kMask),
                 limb({0, 1.38, 0}, 0.062, {0, 1.48, 0}, 0.066).in(kMask),
                 ball({0, 1.525, 0.165}, 0.022).in(kMask),
                 // The band's knot and end.
                 ball({0, 1.63, -0.175}, 0.036).in(kStripe),
                 limb({0, 1.625, -0.185}, 0.03, {0, 1.55, -0.33}, 0.036).in(kStripe)};
  // What the mask leaves free.
  solid.paint = {ellipsoid({0, 1.65, 0}, {0.5, 0.024, 0.5}, about_x(-8)).in(kStripe),
                 ellipsoid({0.066, 1.568, 0.16}, {0.082, 0.056, 0.12}, about_z(6)).in(kSkin),
                 ellipsoid({-0.066, 1.568, 0.16}, {0.082, 0.056, 0.12}, about_z(-6)).in(kSkin)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    for (const Blob& blob : painted_eye(at(0.068, 1.56, 0.155), side, 0.55, 0x8a5a2c, kDark))
      solid.paint.push_back(blob);
    solid.paint.push_back(
        limb(at(0.03, 1.598, 0.165), 0.008, at(0.108, 1.615, 0.13), 0.007).in(kDark));
  }
  return solid;
}

}  // namespace

Figure climber() {
  Builder b("climber");
  b.joint("hips", "", {0, 0.88, 0}, 0, hips());
  b.joint("chest", "hips", {0, 0.97, 0}, 15, chest());
  b.joint("head", "chest", {0, 1.38, 0}, 20, head());
  b.tip("head.tip", "head", {0, 1.75, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.14, 1.285, -0.01), elbow = at(0.37, 1.285, -0.015),
               wrist = at(0.58, 1.285, -0.01);
    b.joint("upper_arm" + end, "chest", shoulder, 40,
            {{limb(shoulder, 0.074, elbow, 0.058).in(kJacket)}, 0, {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 45,
            {{limb(elbow, 0.058, wrist, 0.046).in(kJacket)},
             0,
             {box(elbow, {0.05, 0.2, 0.2}, 0.01).in(kStripe)}});
    b.joint(
        "hand" + end, "forearm" + end, wrist, 20,
        {{limb(wrist + at(-0.02, 0, 0), 0.056, wrist + at(0.02, 0, 0), 0.05).in(kGlove),
          ellipsoid(wrist + at(0.085, 0, 0), {0.078, 0.046, 0.06}).in(kGlove),
          limb(wrist + at(0.04, 0, 0.03), 0.03, wrist + at(0.085, 0.01, 0.085), 0.022).in(kGlove)},
         0.022,
         {box(wrist + at(0.155, 0, -0.02), {0.05, 0.2, 0.085}, 0.01).in(kSkin)}});
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.16, 0, 0));
    const Vec3 top = at(0.078, 0.83, 0), knee = at(0.084, 0.47, 0.012),
               ankle = at(0.086, 0.12, -0.005);
    b.joint("thigh" + end, "hips", top, 35,
            {{limb(top, 0.098, knee, 0.074).in(kTrousers)},
             0,
             {box(top + at(0, -0.08, 0), {0.3, 0.02, 0.3}, 0.005).in(kHarness)}});
    b.joint("shin" + end, "thigh" + end, knee, 35,
            {{limb(knee, 0.074, knee + at(0, -0.2, -0.01), 0.07).in(kTrousers),
              limb(knee + at(0, -0.2, -0.01), 0.07, ankle, 0.056).in(kTrousers)},
             0.01,
             {}});
    b.joint("foot" + end, "shin" + end, ankle, 20,
            {{limb(ankle + at(0, 0.01, 0), 0.06, ankle + at(0, -0.04, 0.01), 0.066).in(kShoe),
              ellipsoid(ankle + at(0, -0.05, 0.07), {0.066, 0.054, 0.12}).in(kShoe)},
             0.03,
             {box(ankle + at(0, -0.12, 0.07), {0.2, 0.042, 0.3}, 0.005).in(kSole),
              box(ankle + at(0, -0.05, 0.19), {0.2, 0.1, 0.05}, 0.005).in(kSole)}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.055, 0.19));
  }
  b.pair_mirrors();
  return b.take();
}

Example climber_climbing() {
  Figure figure = climber();
  const Camera camera{Camera::Type::orthographic, 350};
  const std::vector<View> views = {
      view(figure, "crouching", about_x(6) * about_y(-32),
           {{"chest", about_x(24)},
            {"head", about_x(-20) * about_y(10)},
            {"upper_arm.L", about_x(-28) * about_z(-42)},
            {"forearm.L", about_y(-30) * about_z(-20)},
            {"upper_arm.R", about_x(-44) * about_z(44)},
            {"forearm.R", about_y(30)},
            {"thigh.L", about_z(22) * about_x(-78)},
            {"shin.L", about_x(104)},
            {"foot.L", about_x(-18)},
            {"thigh.R", about_z(-20) * about_x(-62)},
            {"shin.R", about_x(100)},
            {"foot.R", about_x(6)}},
           {-0.02, -0.1, 0}),
      view(figure, "hanging", about_x(5) * about_y(-150),
           {{"head", about_x(-12) * about_y(-16)},
            {"upper_arm.L", about_z(66)},
            {"forearm.L", about_z(14)},
            {"upper_arm.R", about_z(-54)},
            {"forearm.R", about_z(-34)},
            {"thigh.L", about_z(12) * about_x(-26)},
            {"shin.L", about_x(46)},
            {"foot.L", about_x(20)},
            {"thigh.R", about_z(-6) * about_x(8)},
            {"shin.R", about_x(12)},
            {"foot.R", about_x(28)}},
           {0, -0.2, 0}),
      view(figure, "leaping", about_x(-2) * about_y(74),
           {{"chest", about_x(8)},
            {"head", about_x(-14) * about_y(-10)},
            {"upper_arm.R", about_y(72) * about_z(-34)},
            {"forearm.R", about_y(8)},
            {"upper_arm.L", about_y(28) * about_z(-30)},
            {"forearm.L", about_y(-24)},
            {"thigh.L", about_x(-72)},
            {"shin.L", about_x(62)},
            {"foot.L", about_x(10)},
            {"thigh.R", about_x(38)},
            {"shin.R", about_x(32)},
            {"foot.R", about_x(30)}},
           {0, -0.02, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 640, 800, {.pose_error_degrees = 7, .root_error = 0.02}, 15);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

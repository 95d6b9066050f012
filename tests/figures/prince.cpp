// The prince of the paper's first figure, drawn anew: robed and crowned, on his way.
#include "figures/builder.h"
#include "figures/examples.h"
#include "figures/face.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSkin = 0xf4c49c, kCheek = 0xec9f86, kHair = 0x6f4226, kRobe = 0x4a6cb8,
                   kPanel = 0xf7ecd4, kGold = 0xf2bd3d, kCape = 0xb5303f, kErmine = 0xfbf6ea,
                   kSpot = 0x4b4148, kHose = 0xe9e1d3, kShoe = 0x7c4a2e, kGem = 0xd8384a,
                   kLip = 0xb4544c, kDark = 0x33262b;

// A point of a ring about the vertical; 0 is in front.
Vec3 around(double turn, double y, double wide, double deep) {
  return {wide * std::sin(turn), y, deep * std::cos(turn)};
}

// From the belt to the calves, in folds that widen.
Solid robe() {
  Solid solid;
  solid.blend = 0.045;
  solid.blobs = {limb({0, 0.8, 0}, 0.122, {0, 0.66, 0}, 0.15).in(kRobe)};
  constexpr int kRings = 5, kFolds = 11;
  for (int i = 0; i < kRings; ++i) {
    const double t = double(i) / (kRings - 1), y = 0.62 - 0.25 * t, r = 0.15 + 0.075 * t;
    solid.blobs.push_back(ellipsoid({0, y, 0}, {r + 0.01, 0.06, r}).in(kRobe));
  }
  for (int i = 0; i < kFolds; ++i) {
    const double turn = 2 * kPi * (i + 0.5) / kFolds;
    solid.blobs.push_back(
        limb(around(turn, 0.7, 0.1, 0.09), 0.03, around(turn, 0.365, 0.222, 0.208), 0.052)
            .in(kRobe));
  }
  solid.blobs.push_back(ellipsoid({0, 0.785, 0}, {0.15, 0.034, 0.142}).in(kGold));
  solid.paint = {box({0, 0.54, 0.3}, {0.08, 0.25, 0.25}, 0.01, about_x(-8)).in(kGold),
                 box({0, 0.54, 0.3}, {0.058, 0.25, 0.26}, 0.01, about_x(-8)).in(kPanel),
                 box({0, 0.29, 0}, {0.5, 0.072, 0.5}, 0.01).in(kGold),
                 ellipsoid({0, 0.785, 0}, {0.4, 0.03, 0.4}).in(kGold),
                 ellipsoid({0, 0.785, 0.16}, {0.04, 0.028, 0.05}).in(kGem)};
  return solid;
}

Solid chest() {
  Solid solid;
  solid.blend = 0.03;
  solid.blobs = {limb({0, 0.97, 0}, 0.118, {0, 0.85, 0}, 0.118).in(kRobe),
                 limb({-0.1, 0.985, -0.01}, 0.085, {0.1, 0.985, -0.01}, 0.085).in(kRobe)};
  constexpr int kPieces = 12;
  const auto ring = [](int i) {
    const double turn = 2 * kPi * i / kPieces;
    return around(turn, 1.065 - 0.02 * std::cos(turn), 0.13, 0.105);
  };
  for (int i = 0; i < kPieces; ++i)
    solid.blobs.push_back(limb(ring(i), 0.05, ring(i + 1), 0.05).in(kErmine));
  solid.paint = {box({0, 0.9, 0.2}, {0.085, 0.125, 0.15}, 0.01).in(kGold),
                 box({0, 0.9, 0.2}, {0.062, 0.14, 0.16}, 0.01).in(kPanel)};
  for (int i = 0; i < kPieces; ++i) {
    const double turn = 2 * kPi * (i + 0.5) / kPieces;
    solid.paint.push_back(
        ball(around(turn, 1.075 - 0.02 * std::cos(turn), 0.175, 0.15), 0.021).in(kSpot));
  }
  solid.blobs.push_back(ellipsoid({0, 1.0, 0.148}, {0.038, 0.038, 0.024}).in(kGold));
  solid.paint.push_back(ellipsoid({0, 1.0, 0.16}, {0.045, 0.045, 0.05}).in(kGold));
  solid.paint.push_back(ellipsoid({0, 1.0, 0.18}, {0.02, 0.02, 0.03}).in(kGem));
  return solid;
}

// Hangs from the shoulders; its hem is of ermine.
Solid cape() {
  Solid solid;
  solid.blend = 0.04;
  constexpr int kFolds = 13, kSpots = 7;
  for (int i = 0; i < kFolds; ++i) {
    const double u = 2.0 * i / (kFolds - 1) - 1, bulge = 0.03 * (1 - u * u);
    const double fold = i % 2 ? 0.004 : -0.004;
    const Vec3 top(0.12 * u, 1.0, -0.14 - bulge), hem(0.3 * u, 0.24, -0.42 - bulge - fold);
    const Vec3 middle(0.22 * u, 0.62, -0.3 - bulge - fold / 2);
    solid.blobs.push_back(limb(top, 0.03, middle, 0.032).in(kCape));
    solid.blobs.push_back(limb(middle, 0.032, hem, 0.036).in(kCape));
  }
  solid.paint = {box({0, 0.2, -0.42}, {0.6, 0.1, 0.3}, 0.01).in(kErmine)};
  for (int i = 0; i < kSpots; ++i) {
    const double x = 0.3 * (2.0 * i / (kSpots - 1) - 1);
    solid.paint.push_back(limb({x, 0.25, -0.25}, 0.02, {x, 0.25, -0.7}, 0.02).in(kSpot));
  }
  return solid;
}

Solid head() {
  Solid solid;
  solid.blend = 0.022;
  solid.blobs = {ellipsoid({0, 1.33, 0.012}, {0.218, 0.225, 0.212}).in(kSkin),
                 ellipsoid({0, 1.255, 0.03}, {0.185, 0.155, 0.175}).in(kSkin),
                 limb({0, 1.06, 0}, 0.06, {0, 1.16, 0}, 0.062).in(kSkin),
                 ball({0, 1.265, 0.222}, 0.026).in(kSkin),
                 ellipsoid({0, 1.385, -0.04}, {0.242, 0.225, 0.228}).in(kHair)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    // Long hair to the shoulders that curls outward at its ends, parted in the middle.
    solid.blobs.push_back(limb(at(0.18, 1.42, 0.02), 0.07, at(0.2, 1.27, 0.0), 0.062).in(kHair));
    solid.blobs.push_back(limb(at(0.2, 1.27, 0.0), 0.062, at(0.245, 1.185, 0.03), 0.02).in(kHair));
    solid.blobs.push_back(limb(at(0.14, 1.38, -0.12), 0.1, at(0.155, 1.25, -0.13), 0.08).in(kHair));
    solid.blobs.push_back(
        limb(at(0.155, 1.25, -0.13), 0.08, at(0.215, 1.15, -0.16), 0.02).in(kHair));
    solid.blobs.push_back(
        limb(at(0.06, 1.36, -0.18), 0.09, at(0.065, 1.22, -0.18), 0.075).in(kHair));
    solid.blobs.push_back(
        limb(at(0.065, 1.22, -0.18), 0.075, at(0.085, 1.13, -0.235), 0.02).in(kHair));
    solid.blobs.push_back(
        limb(at(0.03, 1.53, 0.12), 0.07, at(0.115, 1.425, 0.188), 0.035).in(kHair));
    solid.blobs.push_back(
        limb(at(0.115, 1.425, 0.188), 0.035, at(0.188, 1.335, 0.122), 0.022).in(kHair));

    const Vec3 eye = at(0.088, 1.3, 0.2);
    solid.paint.push_back(ellipsoid(at(0.132, 1.225, 0.18), {0.034, 0.022, 0.07}).in(kCheek));
    for (const Blob& blob : painted_eye(eye, side, 0.8, 0x3f6fa0, kDark))
      solid.paint.push_back(blob);
    solid.paint.push_back(
        limb(at(0.052, 1.376, 0.21), 0.01, at(0.092, 1.388, 0.2), 0.011).in(kHair));
    solid.paint.push_back(
        limb(at(0.092, 1.388, 0.2), 0.011, at(0.128, 1.374, 0.18), 0.007).in(kHair));
  }
  solid.paint.push_back(ellipsoid({0, 1.195, 0.2}, {0.045, 0.026, 0.07}).in(kLip));
  solid.paint.push_back(ellipsoid({0, 1.211, 0.2}, {0.06, 0.028, 0.09}).in(kSkin));
  // The crown: a band with low points round crimson velvet, arches of gold over it, and an orb.
  const Vec3 middle(0, 1.545, -0.03);
  constexpr int kPoints = 6, kPieces = 16;
  const auto band = [&](double turn, double y, double r) {
    return Vec3(middle + around(turn, y, r, r));
  };
  for (int i = 0; i < kPieces; ++i)
    solid.blobs.push_back(limb(band(2 * kPi * i / kPieces, 0, 0.188), 0.04,
                               band(2 * kPi * (i + 1) / kPieces, 0, 0.188), 0.04)
                              .in(kGold));
  solid.blobs.push_back(ellipsoid(middle + Vec3(0, 0.04, 0), {0.182, 0.135, 0.182}).in(kCape));
  for (const int side : {1, -1})
    solid.paint.push_back(
        box(middle + Vec3(0, 0.15, 0), {0.022, 0.13, 0.25}, 0.005, about_y(45 * side)).in(kGold));
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2 * kPi * i / kPoints;
    solid.blobs.push_back(
        limb(band(turn, 0.03, 0.2), 0.034, band(turn, 0.1, 0.207), 0.022).in(kGold));
    solid.paint.push_back(ball(band(turn, 0, 0.23), 0.028).in(i % 2 ? 0x3f8fc4 : kGem));
  }
  solid.blobs.push_back(ball(middle + Vec3(0, 0.19, 0), 0.05).in(kGold));
  return solid;
}

}  // namespace

Figure prince() {
  Builder b("prince");
  b.joint("hips", "", {0, 0.62, 0}, 0, robe());
  b.joint("chest", "hips", {0, 0.82, 0}, 12, chest());
  b.joint("head", "chest", {0, 1.09, 0}, 20, head());
  b.tip("head.tip", "head", {0, 1.62, 0});
  b.joint("cape", "chest", {0, 1.0, -0.12}, 12, cape());
  b.tip("cape.tip", "cape", {0, 0.24, -0.42});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.155, 0.985, -0.01), elbow = at(0.345, 0.985, -0.015),
               wrist = at(0.515, 0.985, -0.01);
    b.joint("upper_arm" + end, "chest", shoulder, 40,
            {{ellipsoid(shoulder + at(0.055, 0.005, 0), {0.11, 0.095, 0.095}).in(kRobe),
              limb(shoulder + at(0.08, 0, 0), 0.064, elbow, 0.056).in(kPanel)},
             0.02,
             {ellipsoid(shoulder + at(0.055, 0.005, 0), {0.016, 0.12, 0.12}).in(kGold),
              ellipsoid(shoulder + at(0.11, 0.005, 0), {0.016, 0.12, 0.12}).in(kGold)}});
    // A wide sleeve with a cuff of gold.
    b.joint("forearm" + end, "upper_arm" + end, elbow, 45,
            {{limb(elbow, 0.056, wrist + at(-0.05, 0, 0), 0.082).in(kPanel),
              ellipsoid(wrist + at(-0.015, 0, 0), {0.034, 0.1, 0.1}).in(kGold)},
             0.02,
             {}});
    b.joint("hand" + end, "forearm" + end, wrist, 20,
            {{limb(wrist + at(-0.03, 0, 0), 0.048, wrist + at(0.03, 0, 0), 0.046).in(kSkin),
              ellipsoid(wrist + at(0.08, 0, 0), {0.072, 0.042, 0.056}).in(kSkin),
              limb(wrist + at(0.035, 0.01, 0.03), 0.028, wrist + at(0.08, 0.02, 0.085), 0.021)
                  .in(kSkin)},
             0.025,
             {}});
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.15, 0, 0));
  }
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 top = at(0.085, 0.56, 0), knee = at(0.088, 0.34, 0.01),
               ankle = at(0.09, 0.11, -0.005);
    b.joint("thigh" + end, "hips", top, 20, {{limb(top, 0.085, knee, 0.066).in(kHose)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 25,
            {{limb(knee, 0.066, ankle, 0.054).in(kHose),
              limb(ankle + at(0, 0.075, 0), 0.07, ankle, 0.06).in(kShoe)},
             0.01,
             {box(ankle + at(0, 0.11, 0), {0.1, 0.02, 0.1}, 0.005).in(kGold)}});
    b.joint(
        "foot" + end, "shin" + end, ankle, 15,
        {{limb(ankle + at(0, 0.02, 0), 0.064, ankle + at(0, -0.045, 0.01), 0.068).in(kShoe),
          limb(ankle + at(0, -0.055, 0.03), 0.062, ankle + at(0.005, -0.06, 0.15), 0.046).in(kShoe),
          limb(ankle + at(0.005, -0.06, 0.15), 0.042, ankle + at(0.01, -0.03, 0.215), 0.02)
              .in(kShoe)},
         0.03,
         {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.055, 0.21));
  }
  b.pair_mirrors();
  return b.take();
}

Example prince_walking() {
  Figure figure = prince();
  Camera camera;
  camera.type = Camera::Type::perspective;
  camera.distance = 6;
  camera.focal_length = 2350;
  const Vec3 root(0, -0.28, 0);
  const std::vector<View> views = {
      view(figure, "front", about_y(-12),
           {{"head", about_y(8) * about_z(-3)},
            {"upper_arm.L", about_y(-18) * about_z(-52)},
            {"forearm.L", about_y(-50) * about_z(20)},
            {"upper_arm.R", about_y(-25) * about_z(55)},
            {"forearm.R", about_z(18)},
            {"thigh.L", about_x(16)},
            {"thigh.R", about_x(-20)},
            {"shin.L", about_x(14)},
            {"foot.R", about_x(-6)}},
           root),
      view(figure, "side", about_y(76),
           {{"chest", about_x(3)},
            {"head", about_y(-10)},
            {"cape", about_x(6)},
            {"upper_arm.L", about_x(30) * about_z(-66)},
            {"forearm.L", about_y(-18)},
            {"upper_arm.R", about_x(-34) * about_z(64)},
            {"forearm.R", about_y(44)},
            {"thigh.L", about_x(-24)},
            {"foot.L", about_x(-10)},
            {"thigh.R", about_x(20)},
            {"shin.R", about_x(18)},
            {"foot.R", about_x(12)}},
           root),
      view(figure, "behind", about_x(4) * about_y(-142),
           {{"chest", about_y(-6)},
            {"head", about_y(-22)},
            {"cape", about_x(5) * about_z(-3)},
            {"upper_arm.L", about_z(-34) * about_y(14)},
            {"forearm.L", about_z(-22)},
            {"upper_arm.R", about_z(30)},
            {"forearm.R", about_z(-58)},
            {"hand.R", about_z(10)},
            {"thigh.L", about_x(18)},
            {"shin.L", about_x(12)},
            {"thigh.R", about_x(-18)}},
           root),
  };
  Sketches s =
      draw(figure, views, camera, 640, 840, {.pose_error_degrees = 8, .root_error = 0.02}, 11);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

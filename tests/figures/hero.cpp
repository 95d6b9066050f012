// The hero of the first example: a child off on an adventure.
#include "figures/builder.h"
#include "figures/face.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kSkin = 0xf7cba4, kCheek = 0xf0a58c, kHair = 0x8a4a2c, kTunic = 0x3f8f8a,
                   kScarf = 0xe2503f, kSleeve = 0xf6ead2, kTrousers = 0x5b4a6f, kBoot = 0x8a5a3a,
                   kBelt = 0x6e4326, kGold = 0xf2c14e, kGlove = 0xb9793f, kDark = 0x33262b,
                   kMouth = 0x9c3b38, kIris = 0x4a6b3a;

Solid hips() {
  Solid solid;
  solid.blend = 0.05;
  solid.blobs = {ellipsoid({0, 0.53, 0}, {0.13, 0.1, 0.11}).in(kTrousers),
                 limb({0, 0.7, 0}, 0.125, {0, 0.61, 0}, 0.15).in(kTunic),
                 ellipsoid({0, 0.525, 0}, {0.2, 0.06, 0.175}).in(kTunic),
                 ellipsoid({0, 0.69, 0}, {0.158, 0.036, 0.155}).in(kBelt)};
  solid.paint = {box({0, 0.69, 0.15}, {0.036, 0.03, 0.05}, 0.008).in(kGold),
                 box({0, 0.69, 0.15}, {0.018, 0.013, 0.06}, 0.004).in(kBelt)};
  return solid;
}

Solid chest() {
  Solid solid;
  solid.blend = 0.03;
  solid.blobs = {limb({0, 0.86, 0}, 0.12, {0, 0.74, 0}, 0.128).in(kTunic),
                 limb({-0.1, 0.875, -0.01}, 0.082, {0.1, 0.875, -0.01}, 0.082).in(kTunic)};
  // The scarf: a ring round the neck and a tail in the wind.
  constexpr int kPieces = 10;
  const auto ring = [](int i) {
    const double turn = 2 * kPi * i / kPieces;
    return Vec3(0.108 * std::sin(turn), 0.965 - 0.018 * std::cos(turn), 0.1 * std::cos(turn));
  };
  for (int i = 0; i < kPieces; ++i)
    solid.blobs.push_back(limb(ring(i), 0.054, ring(i + 1), 0.054).in(kScarf));
  solid.blobs.push_back(limb({0, 0.95, -0.14}, 0.045, {0, 0.86, -0.26}, 0.052).in(kScarf));
  solid.blobs.push_back(limb({0, 0.86, -0.26}, 0.052, {0, 0.84, -0.38}, 0.03).in(kScarf));
  return solid;
}

Solid head() {
  Solid solid;
  solid.blend = 0.025;
  solid.blobs = {ellipsoid({0, 1.28, 0.01}, {0.268, 0.262, 0.255}).in(kSkin),
                 ellipsoid({0, 1.195, 0.025}, {0.235, 0.18, 0.215}).in(kSkin),
                 limb({0, 0.98, 0}, 0.07, {0, 1.08, 0}, 0.075).in(kSkin),
                 ball({0, 1.195, 0.262}, 0.03).in(kSkin),
                 ellipsoid({0, 1.335, -0.045}, {0.295, 0.285, 0.272}).in(kHair),
                 ellipsoid({0, 1.2, -0.12}, {0.235, 0.16, 0.165}).in(kHair),
                 limb({0, 1.58, 0.02}, 0.075, {0, 1.69, 0.1}, 0.018).in(kHair),
                 limb({0, 1.56, -0.1}, 0.08, {0, 1.66, -0.17}, 0.018).in(kHair)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.blobs.push_back(ellipsoid(at(0.262, 1.215, 0), {0.045, 0.065, 0.04}).in(kSkin));
    // Locks over the forehead, at the temples and in the neck.
    solid.blobs.push_back(
        limb(at(0.05, 1.53, 0.13), 0.08, at(0.085, 1.405, 0.238), 0.018).in(kHair));
    solid.blobs.push_back(limb(at(0.15, 1.48, 0.11), 0.08, at(0.2, 1.355, 0.19), 0.018).in(kHair));
    solid.blobs.push_back(
        limb(at(0.24, 1.36, 0.02), 0.06, at(0.272, 1.22, 0.085), 0.015).in(kHair));
    solid.blobs.push_back(limb(at(0.2, 1.4, -0.1), 0.09, at(0.325, 1.37, -0.17), 0.018).in(kHair));
    solid.blobs.push_back(limb(at(0.14, 1.2, -0.2), 0.09, at(0.22, 1.1, -0.25), 0.018).in(kHair));

    const Vec3 eye = at(0.105, 1.245, 0.245);
    solid.paint.push_back(ellipsoid(at(0.165, 1.16, 0.21), {0.04, 0.026, 0.08}).in(kCheek));
    for (const Blob& blob : painted_eye(eye, side, 1, kIris, kDark)) solid.paint.push_back(blob);
    solid.paint.push_back(
        limb(at(0.068, 1.345, 0.25), 0.011, at(0.115, 1.362, 0.23), 0.013).in(kHair));
    solid.paint.push_back(
        limb(at(0.115, 1.362, 0.23), 0.013, at(0.162, 1.342, 0.2), 0.008).in(kHair));
  }
  solid.paint.push_back(ellipsoid({0, 1.118, 0.23}, {0.062, 0.04, 0.08}).in(kDark));
  solid.paint.push_back(ellipsoid({0, 1.118, 0.23}, {0.054, 0.032, 0.09}).in(kMouth));
  solid.paint.push_back(ellipsoid({0, 1.094, 0.23}, {0.034, 0.016, 0.1}).in(0xe88a80));
  solid.paint.push_back(ellipsoid({0, 1.158, 0.23}, {0.1, 0.042, 0.12}).in(kSkin));
  return solid;
}

}  // namespace

Figure hero() {
  Builder b("hero");
  b.joint("hips", "", {0, 0.58, 0}, 0, hips());
  b.joint("chest", "hips", {0, 0.71, 0}, 15, chest());
  b.joint("head", "chest", {0, 1.0, 0}, 25, head());
  b.tip("head.tip", "head", {0, 1.6, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.15, 0.885, -0.01), elbow = at(0.345, 0.885, -0.015),
               wrist = at(0.52, 0.885, -0.01);
    b.joint("upper_arm" + end, "chest", shoulder, 45,
            {{limb(shoulder, 0.07, elbow, 0.062).in(kSleeve)}, 0, {}});
    b.joint("forearm" + end, "upper_arm" + end, elbow, 50,
            {{limb(elbow, 0.062, wrist, 0.056).in(kSleeve)}, 0, {}});
    b.joint(
        "hand" + end, "forearm" + end, wrist, 25,
        {{limb(wrist + at(-0.02, 0, 0), 0.072, wrist + at(0.03, 0, 0), 0.062).in(kGlove),
          ellipsoid(wrist + at(0.095, 0, 0), {0.085, 0.06, 0.068}).in(kGlove),
          limb(wrist + at(0.05, 0.01, 0.04), 0.034, wrist + at(0.1, 0.03, 0.1), 0.026).in(kGlove)},
         0.025,
         {}});
    b.tip("hand.tip" + end, "hand" + end, wrist + at(0.17, 0, 0));
  }
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 top = at(0.085, 0.5, 0), knee = at(0.092, 0.32, 0.01),
               ankle = at(0.095, 0.12, -0.005);
    b.joint("thigh" + end, "hips", top, 35, {{limb(top, 0.088, knee, 0.074).in(kTrousers)}, 0, {}});
    b.joint("shin" + end, "thigh" + end, knee, 35,
            {{limb(knee, 0.074, knee + at(0, -0.08, 0), 0.07).in(kTrousers),
              limb(ankle + at(0, 0.09, 0), 0.084, ankle, 0.074).in(kBoot)},
             0.01,
             {}});
    b.joint("foot" + end, "shin" + end, ankle, 15,
            {{limb(ankle, 0.074, ankle + at(0, -0.04, 0.01), 0.08).in(kBoot),
              ellipsoid(ankle + at(0, -0.045, 0.075), {0.082, 0.07, 0.135}).in(kBoot)},
             0.04,
             {}});
    b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.05, 0.2));
  }
  b.pair_mirrors();
  return b.take();
}

}  // namespace artisketch::figures

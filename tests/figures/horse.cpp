// The horse of the paper's seventh figure, drawn anew: its torso is one part, or three.
#include "figures/builder.h"
#include "figures/examples.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kCoat = 0xb06a3c, kMane = 0x45302c, kSock = 0xf6ecdc, kHoof = 0x5a4a44,
                   kMuzzle = 0x8c5238, kDark = 0x2c2124, kWhite = 0xfffdf6;

const Vec3 kLoin(0, 1.03, -0.45), kBack(0, 1.03, -0.2), kWithers(0, 1.05, 0.08);

std::vector<Blob> hindquarters() {
  return {ellipsoid({0, 1.055, -0.53}, {0.195, 0.205, 0.225}).in(kCoat),
          limb({0, 1.02, -0.5}, 0.2, {0, 0.995, -0.25}, 0.2).in(kCoat)};
}

std::vector<Blob> barrel() {
  return {limb({0, 0.995, -0.3}, 0.2, {0, 0.985, -0.02}, 0.212).in(kCoat)};
}

std::vector<Blob> forequarters() {
  return {ellipsoid({0, 1.01, 0.12}, {0.18, 0.225, 0.22}).in(kCoat),
          limb({0, 1.15, 0}, 0.085, {0, 1.19, 0.16}, 0.1).in(kCoat),
          ball({0, 0.95, 0.26}, 0.13).in(kCoat)};
}

Solid smooth(std::vector<Blob> blobs) {
  return {std::move(blobs), 0.09, {}};
}

Solid neck() {
  Solid solid = smooth({limb({0, 1.09, 0.18}, 0.17, {0, 1.34, 0.38}, 0.125).in(kCoat),
                        limb({0, 1.34, 0.38}, 0.125, {0, 1.55, 0.5}, 0.095).in(kCoat)});
  solid.blend = 0.03;
  // The mane stands on the crest and falls to the left, in locks.
  constexpr int kLocks = 6;
  for (int i = 0; i < kLocks; ++i) {
    const double t = double(i) / (kLocks - 1);
    const Vec3 crest(0.005, 1.3 + 0.37 * t, 0.12 + 0.32 * t - 0.02 * std::sin(kPi * t));
    const Vec3 fall = crest + Vec3(0.105 - 0.03 * t, -0.09, 0.045);
    solid.blobs.push_back(limb(crest, 0.05, fall, 0.045).in(kMane));
    solid.blobs.push_back(limb(fall, 0.045, fall + Vec3(0.03, -0.125, -0.05), 0.014).in(kMane));
  }
  return solid;
}

Solid head() {
  Solid solid = smooth({ellipsoid({0, 1.555, 0.565}, {0.1, 0.115, 0.115}).in(kCoat),
                        limb({0, 1.53, 0.6}, 0.1, {0, 1.33, 0.82}, 0.064).in(kCoat),
                        ellipsoid({0, 1.475, 0.58}, {0.092, 0.115, 0.1}).in(kCoat),
                        ellipsoid({0, 1.295, 0.845}, {0.075, 0.066, 0.075}).in(kMuzzle)});
  solid.blend = 0.04;
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.blobs.push_back(
        limb(at(0.055, 1.64, 0.53), 0.042, at(0.068, 1.7, 0.525), 0.036).in(kCoat));
    solid.blobs.push_back(limb(at(0.068, 1.7, 0.525), 0.036, at(0.07, 1.8, 0.545), 0.01).in(kCoat));
    solid.paint.push_back(
        limb(at(0.07, 1.68, 0.575), 0.016, at(0.071, 1.76, 0.57), 0.008).in(kMane));
    const Vec3 eye = at(0.1, 1.53, 0.66);
    solid.paint.push_back(ellipsoid(eye, {0.05, 0.038, 0.038}).in(kDark));
    solid.paint.push_back(ball(eye + at(0.015, 0.016, 0.012), 0.013).in(kWhite));
    solid.paint.push_back(ellipsoid(at(0.05, 1.31, 0.905), {0.022, 0.024, 0.022}).in(kDark));
    solid.paint.push_back(
        limb(at(0.03, 1.25, 0.895), 0.007, at(0.085, 1.268, 0.825), 0.007).in(kDark));
  }
  // A blaze down the face, and the forelock over it.
  solid.paint.push_back(limb({0, 1.6, 0.7}, 0.04, {0, 1.375, 0.895}, 0.032).in(kSock));
  solid.blobs.push_back(limb({0, 1.665, 0.5}, 0.05, {0.012, 1.67, 0.6}, 0.04).in(kMane));
  solid.blobs.push_back(limb({0.012, 1.67, 0.6}, 0.04, {0.03, 1.56, 0.685}, 0.014).in(kMane));
  return solid;
}

Solid tail() {
  return {{limb({0, 1.15, -0.7}, 0.05, {0, 1.15, -0.82}, 0.066).in(kMane),
           limb({0, 1.15, -0.82}, 0.066, {0, 0.88, -0.93}, 0.09).in(kMane),
           limb({0, 0.88, -0.93}, 0.09, {0, 0.58, -0.92}, 0.085).in(kMane),
           limb({0, 0.58, -0.92}, 0.085, {0, 0.36, -1.0}, 0.016).in(kMane)},
          0.05,
          {}};
}

Solid hoof(const Vec3& fetlock) {
  return {{ball(fetlock, 0.054).in(kSock),
           limb(fetlock, 0.05, fetlock + Vec3(0, -0.07, 0.04), 0.05).in(kSock),
           limb(fetlock + Vec3(0, -0.09, 0.05), 0.054, fetlock + Vec3(0, -0.115, 0.06), 0.064)
               .in(kHoof)},
          0.02,
          {}};
}

void add_leg(Builder& b, bool front, int side, const std::string& parent) {
  const std::string name = front ? "fore_" : "hind_", end = side > 0 ? ".L" : ".R";
  const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
  const Vec3 top = front ? at(0.115, 0.93, 0.12) : at(0.11, 0.98, -0.52),
             middle = front ? at(0.115, 0.52, 0.14) : at(0.118, 0.54, -0.68),
             fetlock = front ? at(0.115, 0.19, 0.13) : at(0.118, 0.19, -0.64);
  Solid thigh = smooth({limb(middle, 0.06, middle, 0.06).in(kCoat)});
  if (front) {
    thigh.blobs.push_back(limb(top, 0.12, at(0.115, 0.72, 0.14), 0.084).in(kCoat));
    thigh.blobs.push_back(limb(at(0.115, 0.72, 0.14), 0.084, middle, 0.056).in(kCoat));
  } else {
    thigh.blobs.push_back(limb(top, 0.14, at(0.12, 0.8, -0.49), 0.125).in(kCoat));
    thigh.blobs.push_back(limb(at(0.12, 0.8, -0.49), 0.115, middle, 0.052).in(kCoat));
  }
  thigh.blend = 0.05;
  b.joint(name + "thigh" + end, parent, top, 25, std::move(thigh));
  b.joint(name + "shin" + end, name + "thigh" + end, middle, 25,
          {{limb(middle, 0.06, middle + 0.3 * (fetlock - middle), 0.046).in(kCoat),
            limb(middle + 0.3 * (fetlock - middle), 0.046, fetlock, 0.05).in(kCoat)},
           0.02,
           {box({0, 0.2, 0}, {1, 0.11, 1}, 0.01).in(kSock)}});
  b.joint(name + "hoof" + end, name + "shin" + end, fetlock, 15, hoof(fetlock));
  b.tip(name + "hoof.tip" + end, name + "hoof" + end, fetlock + Vec3(0, -0.14, 0.12));
}

Example horse_about(bool three_parts) {
  Figure figure = horse(three_parts);
  const Camera camera{Camera::Type::orthographic, 318};
  const double bow = three_parts ? 1 : 0;  // what a torso of one part cannot do
  const auto bent = [&](Turns turns, double side, double up) {
    if (three_parts) {
      turns.push_back({"barrel", about_y(bow * side) * about_x(bow * up)});
      turns.push_back({"chest", about_y(bow * side) * about_x(bow * up)});
    }
    return turns;
  };
  const std::vector<View> views = {
      view(figure, "side", about_x(2) * about_y(-84),
           bent({{"neck", about_x(-4)},
                 {"head", about_x(6) * about_y(-6)},
                 {"tail", about_x(22)},
                 {"fore_thigh.L", about_x(-44)},
                 {"fore_shin.L", about_x(72)},
                 {"fore_hoof.L", about_x(22)},
                 {"fore_thigh.R", about_x(14)},
                 {"fore_shin.R", about_x(3)},
                 {"hind_thigh.L", about_x(18)},
                 {"hind_shin.L", about_x(8)},
                 {"hind_hoof.L", about_x(24)},
                 {"hind_thigh.R", about_x(-24)},
                 {"hind_shin.R", about_x(6)}},
                0, -5),
           {0.3, 0.06, 0}),
      view(figure, "front", about_x(7) * about_y(33),
           bent({{"neck", about_y(-10) * about_x(6)},
                 {"head", about_y(-10) * about_x(-5)},
                 {"tail", about_z(14) * about_x(14)},
                 {"fore_thigh.R", about_x(-34)},
                 {"fore_shin.R", about_x(58)},
                 {"fore_hoof.R", about_x(16)},
                 {"hind_thigh.L", about_x(-12)},
                 {"hind_thigh.R", about_x(12)}},
                -8, 2),
           {-0.22, 0.1, 0}),
      view(figure, "behind", about_x(6) * about_y(-146),
           bent({{"neck", about_y(-20) * about_x(4)},
                 {"head", about_y(-22) * about_x(4)},
                 {"tail", about_z(-10) * about_x(10)},
                 {"fore_thigh.L", about_x(-16)},
                 {"hind_thigh.R", about_x(14)},
                 {"hind_shin.R", about_x(14)},
                 {"hind_hoof.R", about_x(26)}},
                -9, 0),
           {0.2, 0.09, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 760, 660, {.pose_error_degrees = 7, .root_error = 0.02}, 12);
  return finished(std::move(figure), std::move(s));
}

}  // namespace

Figure horse(bool three_parts) {
  Builder b(three_parts ? "horse-three" : "horse");
  if (three_parts) {
    b.joint("body", "", kLoin, 0, smooth(hindquarters()));
    b.joint("barrel", "body", kBack, 10, smooth(barrel()));
    b.joint("chest", "barrel", kWithers, 10, smooth(forequarters()));
  } else {
    std::vector<Blob> torso = hindquarters();
    for (const Blob& blob : barrel()) torso.push_back(blob);
    for (const Blob& blob : forequarters()) torso.push_back(blob);
    b.joint("body", "", kLoin, 0, smooth(std::move(torso)));
  }
  const std::string front = three_parts ? "chest" : "body";
  b.joint("neck", front, {0, 1.14, 0.2}, 15, neck());
  b.joint("head", "neck", {0, 1.57, 0.51}, 20, head());
  b.tip("head.tip", "head", {0, 1.27, 0.9});
  b.joint("tail", "body", {0, 1.15, -0.7}, 25, tail());
  b.tip("tail.tip", "tail", {0, 0.38, -1});
  for (const bool fore : {true, false})
    for (const int side : {1, -1}) add_leg(b, fore, side, fore ? front : "body");
  b.pair_mirrors();
  return b.take();
}

Example horse_trotting() {
  return horse_about(false);
}
Example horse_turning() {
  return horse_about(true);
}

}  // namespace artisketch::figures

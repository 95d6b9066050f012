// A creature that is drawn once: all that one drawing gives.
#include "figures/builder.h"
#include "figures/examples.h"
#include "figures/face.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kFur = 0x8b6bc9, kBelly = 0xd9c6f2, kHorn = 0xf5e3b8, kClaw = 0xf5e3b8,
                   kDark = 0x33262b, kMouth = 0x7d2f4a, kTongue = 0xee8a92, kTooth = 0xfffdf6,
                   kSpot = 0x6d4fae;

Solid body() {
  Solid solid;
  solid.blend = 0.06;
  solid.blobs = {ellipsoid({0, 0.62, 0}, {0.36, 0.4, 0.34}).in(kFur),
                 ellipsoid({0, 0.84, 0}, {0.3, 0.3, 0.29}).in(kFur)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.blobs.push_back(limb(at(0.17, 1.07, 0), 0.075, at(0.27, 1.19, 0), 0.055).in(kHorn));
    solid.blobs.push_back(limb(at(0.27, 1.19, 0), 0.055, at(0.27, 1.33, 0), 0.014).in(kHorn));
    // Tufts at the cheeks.
    solid.blobs.push_back(limb(at(0.25, 0.78, 0), 0.09, at(0.42, 0.83, 0), 0.02).in(kFur));
    solid.blobs.push_back(limb(at(0.25, 0.72, 0), 0.09, at(0.42, 0.72, 0), 0.02).in(kFur));
    solid.paint.push_back(ball(at(0.25, 0.99, 0.15), 0.04).in(kSpot));
    solid.paint.push_back(ball(at(0.3, 0.9, 0.12), 0.03).in(kSpot));
  }
  solid.blobs.push_back(limb({0, 1.08, 0}, 0.06, {0.03, 1.22, 0}, 0.016).in(kFur));
  solid.paint.push_back(ellipsoid({0, 0.47, 0.34}, {0.22, 0.21, 0.2}).in(kBelly));
  for (const Blob& blob : painted_eye({0, 0.965, 0.27}, 1, 1.75, 0x3fa08f, kDark))
    solid.paint.push_back(blob);
  solid.paint.push_back(ellipsoid({0, 0.75, 0.33}, {0.17, 0.075, 0.14}).in(kDark));
  solid.paint.push_back(ellipsoid({0, 0.75, 0.33}, {0.158, 0.063, 0.15}).in(kMouth));
  solid.paint.push_back(ellipsoid({0, 0.712, 0.33}, {0.08, 0.03, 0.16}).in(kTongue));
  for (const double x : {-0.085, 0.0, 0.085})
    solid.paint.push_back(limb({x, 0.815, 0.36}, 0.03, {x, 0.772, 0.37}, 0.008).in(kTooth));
  return solid;
}

void add_claws(Solid& solid, const std::vector<Vec3>& roots, const Vec3& way) {
  for (const Vec3& root : roots)
    solid.blobs.push_back(limb(root, 0.036, root + way, 0.01).in(kClaw));
}

}  // namespace

Figure monster() {
  Builder b("monster");
  b.joint("body", "", {0, 0.6, 0}, 0, body());
  b.tip("body.tip", "body", {0, 1.1, 0});
  for (const int side : {1, -1}) {
    const std::string end = side > 0 ? ".L" : ".R";
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    const Vec3 shoulder = at(0.32, 0.62, 0), elbow = at(0.52, 0.62, 0), wrist = at(0.7, 0.62, 0);
    b.joint("upper_arm" + end, "body", shoulder, 30,
            {{limb(shoulder, 0.105, elbow, 0.085).in(kFur)}, 0, {}});
    Solid forearm{{limb(elbow, 0.085, wrist, 0.105).in(kFur)}, 0.02, {}};
    add_claws(forearm,
              {wrist + at(0.08, 0.06, 0), wrist + at(0.1, 0, 0), wrist + at(0.08, -0.06, 0)},
              at(0.075, 0, 0));
    b.joint("forearm" + end, "upper_arm" + end, elbow, 35, std::move(forearm));
    b.tip("forearm.tip" + end, "forearm" + end, wrist + at(0.12, 0, 0));
    const Vec3 top = at(0.16, 0.3, 0), ankle = at(0.17, 0.12, 0);
    Solid leg{{limb(top, 0.125, ankle, 0.12).in(kFur)}, 0.02, {}};
    add_claws(leg,
              {ankle + at(-0.07, -0.07, 0), ankle + at(0, -0.09, 0), ankle + at(0.07, -0.07, 0)},
              at(0, -0.07, 0));
    b.joint("leg" + end, "body", top, 20, std::move(leg));
    b.tip("leg.tip" + end, "leg" + end, ankle + at(0, -0.12, 0));
  }
  b.pair_mirrors();
  return b.take();
}

Example monster_once() {
  Figure figure = monster();
  const Camera camera{Camera::Type::orthographic, 360};
  Sketches s = draw(figure,
                    std::vector{view(figure, "front", about_y(0),
                                     {{"upper_arm.L", about_z(34)},
                                      {"forearm.L", about_z(46)},
                                      {"upper_arm.R", about_z(38)},
                                      {"forearm.R", about_z(-16)},
                                      {"leg.L", about_z(10)},
                                      {"leg.R", about_z(-12)}},
                                     {0, -0.05, 0})},
                    camera, 600, 600);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

// The fox of the examples.
#include "figures/builder.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kFur = 0xe67e33, kPale = 0xfff2dc, kDark = 0x3b2a2a, kSock = 0x4a3632,
                   kWhite = 0xfffdf6;

Solid head(const Vec3& neck) {
  const Vec3 skull = neck + Vec3(0, 0.13, 0.1);
  Solid solid;
  solid.blend = 0.04;
  solid.blobs = {
      ellipsoid(skull, {0.19, 0.16, 0.165}).in(kFur), limb(neck, 0.1, skull, 0.1).in(kFur),
      limb(skull + Vec3(0, -0.05, 0.1), 0.085, skull + Vec3(0, -0.072, 0.26), 0.036).in(kFur)};
  solid.paint = {ellipsoid(skull + Vec3(0, -0.135, 0.16), {0.3, 0.085, 0.2}).in(kPale)};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) {
      return Vec3(skull + Vec3(side * x, y, z));
    };
    // Cheeks that end in a point, tall ears.
    solid.blobs.push_back(limb(at(0.1, -0.05, 0.03), 0.1, at(0.23, -0.085, 0.02), 0.02).in(kFur));
    solid.blobs.push_back(limb(at(0.1, 0.09, -0.02), 0.08, at(0.17, 0.33, -0.03), 0.02).in(kFur));
    solid.paint.push_back(ball(at(0.178, 0.33, -0.03), 0.085).in(kDark));
    solid.paint.push_back(limb(at(0.12, 0.14, 0.06), 0.035, at(0.155, 0.23, 0.04), 0.02).in(kPale));
    solid.paint.push_back(ellipsoid(at(0.2, -0.08, 0.1), {0.12, 0.07, 0.14}).in(kPale));
    const Vec3 eye = at(0.088, 0.018, 0.14);
    solid.paint.push_back(ellipsoid(eye, {0.034, 0.046, 0.06}).in(kDark));
    solid.paint.push_back(ellipsoid(eye + Vec3(0.01, 0.017, 0), {0.012, 0.013, 0.07}).in(kWhite));
  }
  solid.paint.push_back(ball(skull + Vec3(0, -0.06, 0.295), 0.036).in(kDark));
  return solid;
}

}  // namespace

Figure fox() {
  Builder b("fox");
  const Vec3 loin(0, 0.5, -0.42), shoulders(0, 0.52, 0), neck(0, 0.66, 0.15);
  b.joint("body", "", loin, 0,
          {{ellipsoid(loin + Vec3(0, 0, -0.02), {0.145, 0.15, 0.18}).in(kFur),
            limb(loin, 0.13, shoulders + Vec3(0, -0.01, 0), 0.135).in(kFur)},
           0.05,
           {ellipsoid({0, 0.37, -0.2}, {0.1, 0.06, 0.3}).in(kPale)}});
  b.joint("chest", "body", shoulders, 15,
          {{ellipsoid(shoulders + Vec3(0, 0, 0.04), {0.15, 0.165, 0.17}).in(kFur),
            limb(shoulders + Vec3(0, 0.05, 0.08), 0.13, neck, 0.1).in(kFur),
            limb(shoulders + Vec3(0, 0, 0.16), 0.085, shoulders + Vec3(0, -0.11, 0.19), 0.03)
                .in(kPale)},
           0.07,
           {ellipsoid(shoulders + Vec3(0, 0.02, 0.22), {0.085, 0.17, 0.13}).in(kPale)}});
  b.joint("head", "chest", neck, 25, head(neck));
  b.tip("head.tip", "head", neck + Vec3(0, 0.07, 0.38));
  const Vec3 rump = loin + Vec3(0, 0.06, -0.16);
  b.joint("tail", "body", rump, 35,
          {{limb(rump, 0.05, rump + Vec3(0, 0.06, -0.14), 0.08).in(kFur),
            limb(rump + Vec3(0, 0.06, -0.14), 0.085, rump + Vec3(0, 0.22, -0.3), 0.125).in(kFur),
            limb(rump + Vec3(0, 0.25, -0.32), 0.115, rump + Vec3(0, 0.46, -0.36), 0.03).in(kPale)},
           0.05,
           {}});
  b.tip("tail.tip", "tail", rump + Vec3(0, 0.46, -0.36));
  for (const bool front : {true, false})
    for (const int side : {1, -1}) {
      const std::string name = front ? "fore_" : "hind_", end = side > 0 ? ".L" : ".R";
      const double z = front ? 0.06 : -0.46, bend = front ? -0.015 : 0.035;
      const auto at = [&](double y, double dz) { return Vec3(side * 0.085, y, z + dz); };
      const Vec3 top = at(0.44, 0), knee = at(0.25, bend), ankle = at(0.07, -bend);
      b.joint(name + "thigh" + end, front ? "chest" : "body", top, 30,
              {{limb(top, front ? 0.09 : 0.105, knee, 0.062).in(kFur)}, 0, {}});
      b.joint(name + "shin" + end, name + "thigh" + end, knee, 30,
              {{limb(knee, 0.066, ankle, 0.05).in(kSock)}, 0, {}});
      b.joint(name + "paw" + end, name + "shin" + end, ankle, 15,
              {{ball(ankle, 0.053).in(kSock),
                ellipsoid(ankle + Vec3(0, -0.02, 0.045), {0.06, 0.05, 0.082}).in(kSock)},
               0.03,
               {}});
      b.tip(name + "paw.tip" + end, name + "paw" + end, ankle + Vec3(0, -0.03, 0.12));
    }
  b.pair_mirrors();
  return b.take();
}

}  // namespace artisketch::figures

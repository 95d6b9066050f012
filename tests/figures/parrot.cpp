// A parrot on the wing: what the joints of a bird are for.
#include "figures/builder.h"
#include "figures/examples.h"

namespace artisketch::figures {
namespace {

constexpr unsigned kRed = 0xdb3b36, kYellow = 0xf6c344, kBlue = 0x3c76c4, kFace = 0xfdf5e6,
                   kBeak = 0x453c41, kFoot = 0x7d706c, kDark = 0x2c2124, kWhite = 0xfffdf6,
                   kIris = 0xe9b949;

Solid body() {
  return {{ellipsoid({0, 0.5, -0.08}, {0.135, 0.135, 0.2}, about_x(-22)).in(kRed),
           limb({0, 0.48, -0.2}, 0.1, {0, 0.44, -0.3}, 0.06).in(kRed)},
          0.06,
          {}};
}

Solid chest() {
  return {{ellipsoid({0, 0.58, 0.1}, {0.142, 0.15, 0.145}).in(kRed),
           limb({0, 0.62, 0.12}, 0.115, {0, 0.74, 0.18}, 0.1).in(kRed)},
          0.06,
          {}};
}

Solid head() {
  Solid solid{{ellipsoid({0, 0.83, 0.21}, {0.13, 0.13, 0.14}).in(kRed),
               limb({0, 0.72, 0.17}, 0.095, {0, 0.8, 0.2}, 0.1).in(kRed),
               limb({0, 0.84, 0.31}, 0.066, {0, 0.8, 0.385}, 0.045).in(kBeak),
               limb({0, 0.8, 0.385}, 0.045, {0, 0.705, 0.395}, 0.012).in(kBeak),
               limb({0, 0.765, 0.3}, 0.05, {0, 0.74, 0.345}, 0.025).in(kBeak),
               // A crest.
               limb({0, 0.93, 0.19}, 0.05, {0, 0.985, 0.06}, 0.018).in(kRed)},
              0.025,
              {}};
  for (const int side : {1, -1}) {
    const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
    solid.paint.push_back(ellipsoid(at(0.12, 0.815, 0.26), {0.075, 0.078, 0.075}).in(kFace));
    solid.paint.push_back(ellipsoid(at(0.12, 0.84, 0.262), {0.09, 0.04, 0.036}).in(kDark));
    solid.paint.push_back(ellipsoid(at(0.12, 0.84, 0.262), {0.1, 0.032, 0.028}).in(kIris));
    solid.paint.push_back(ellipsoid(at(0.12, 0.838, 0.264), {0.11, 0.019, 0.017}).in(kDark));
    solid.paint.push_back(ellipsoid(at(0.12, 0.85, 0.27), {0.12, 0.008, 0.008}).in(kWhite));
  }
  return solid;
}

Solid tail() {
  Solid solid;
  solid.blend = 0.03;
  for (const double x : {-0.075, 0.0, 0.075}) {
    const double length = x == 0 ? 0.6 : 0.48;
    solid.blobs.push_back(
        limb({0.4 * x, 0.44, -0.28}, 0.05, {x, 0.36, -0.28 - 0.6 * length}, 0.046).in(kRed));
    solid.blobs.push_back(
        limb({x, 0.36, -0.28 - 0.6 * length}, 0.046, {1.2 * x, 0.32, -0.3 - length}, 0.02)
            .in(kBlue));
  }
  solid.paint = {box({0, 0.4, -0.48}, {0.5, 0.5, 0.035}, 0.005).in(kYellow)};
  return solid;
}

// A flat feather from the wing's bone backwards.
Blob feather(const Vec3& from, const Vec3& to, double radius, unsigned rgb) {
  return limb(from, radius, to, 0.6 * radius).in(rgb);
}

void add_wing(Builder& b, int side) {
  const std::string end = side > 0 ? ".L" : ".R";
  const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
  const Vec3 shoulder = at(0.11, 0.63, 0.08), elbow = at(0.33, 0.64, 0.07),
             wrist = at(0.56, 0.645, 0.09), tip = at(0.86, 0.64, -0.02);
  Solid upper{{limb(shoulder, 0.062, elbow, 0.052).in(kRed)}, 0.04, {}};
  for (const double x : {0.14, 0.21, 0.28, 0.35})
    upper.blobs.push_back(feather(at(x, 0.632, 0.05), at(x + 0.01, 0.62, -0.16), 0.045, kRed));
  upper.paint = {box(at(0.24, 0.63, -0.19), {0.3, 0.2, 0.1}, 0.005).in(kYellow)};
  b.joint("upper_wing" + end, "chest", shoulder, 30, std::move(upper));
  Solid lower{{limb(elbow, 0.052, wrist, 0.044).in(kRed)}, 0.04, {}};
  for (const double x : {0.37, 0.44, 0.51, 0.57})
    lower.blobs.push_back(feather(at(x, 0.64, 0.05), at(x + 0.03, 0.625, -0.2), 0.044, kYellow));
  lower.paint = {box(at(0.45, 0.64, -0.24), {0.4, 0.2, 0.11}, 0.005).in(kBlue)};
  b.joint("lower_wing" + end, "upper_wing" + end, elbow, 30, std::move(lower));
  Solid hand{{limb(wrist, 0.044, wrist + at(0.1, 0, -0.01), 0.034).in(kYellow)}, 0.03, {}};
  for (int i = 0; i < 4; ++i) {
    const double turn = radians(10 + 24 * i);  // from outward to backward
    const double length = 0.33 - 0.02 * i;
    const Vec3 root = wrist + at(0.09 - 0.03 * i, 0, -0.01);
    hand.blobs.push_back(
        feather(root, root + length * at(std::cos(turn), -0.03, -std::sin(turn)), 0.045, kBlue));
  }
  b.joint("wing" + end, "lower_wing" + end, wrist, 25, std::move(hand));
  b.tip("wing.tip" + end, "wing" + end, tip);
}

void add_leg(Builder& b, int side) {
  const std::string end = side > 0 ? ".L" : ".R";
  const auto at = [&](double x, double y, double z) { return Vec3(side * x, y, z); };
  const Vec3 top = at(0.075, 0.43, -0.04), knee = at(0.085, 0.31, 0.0),
             ankle = at(0.085, 0.17, -0.03);
  b.joint("thigh" + end, "body", top, 25, {{limb(top, 0.07, knee, 0.048).in(kRed)}, 0, {}});
  b.joint("shin" + end, "thigh" + end, knee, 25,
          {{limb(knee, 0.04, ankle, 0.028).in(kFoot)}, 0, {}});
  b.joint("foot" + end, "shin" + end, ankle, 20,
          {{ball(ankle, 0.032).in(kFoot),
            limb(ankle, 0.028, ankle + at(0.035, -0.03, 0.12), 0.02).in(kFoot),
            limb(ankle, 0.028, ankle + at(-0.035, -0.03, 0.12), 0.02).in(kFoot),
            limb(ankle, 0.028, ankle + at(0, -0.035, -0.085), 0.02).in(kFoot)},
           0.015,
           {}});
  b.tip("foot.tip" + end, "foot" + end, ankle + at(0, -0.03, 0.13));
}

}  // namespace

Figure parrot() {
  Builder b("parrot");
  b.joint("body", "", {0, 0.5, -0.1}, 0, body());
  b.joint("chest", "body", {0, 0.56, 0.05}, 10, chest());
  b.joint("head", "chest", {0, 0.72, 0.17}, 20, head());
  b.tip("head.tip", "head", {0, 0.94, 0.26});
  b.joint("tail", "body", {0, 0.45, -0.26}, 20, tail());
  b.tip("tail.tip", "tail", {0, 0.32, -0.9});
  for (const int side : {1, -1}) add_wing(b, side);
  for (const int side : {1, -1}) add_leg(b, side);
  b.pair_mirrors();
  return b.take();
}

Example parrot_flying() {
  Figure figure = parrot();
  const Camera camera{Camera::Type::orthographic, 400};
  const std::vector<View> views = {
      view(figure, "front", about_x(16) * about_y(24),
           {{"head", about_y(-12) * about_z(-6)},
            {"tail", about_x(-14)},
            {"upper_wing.L", about_z(26)},
            {"lower_wing.L", about_z(8)},
            {"wing.L", about_z(8)},
            {"upper_wing.R", about_z(-26)},
            {"lower_wing.R", about_z(-8)},
            {"wing.R", about_z(-8)},
            {"thigh.L", about_x(20)},
            {"thigh.R", about_x(14)}},
           {0, -0.1, 0}),
      view(figure, "side", about_x(8) * about_y(-66),
           {{"head", about_y(8) * about_x(-6)},
            {"tail", about_x(6)},
            {"upper_wing.L", about_z(38) * about_y(-8)},
            {"lower_wing.L", about_z(12)},
            {"wing.L", about_z(6) * about_y(10)},
            {"upper_wing.R", about_z(-34) * about_y(8)},
            {"lower_wing.R", about_z(-10)},
            {"wing.R", about_z(-6)},
            {"thigh.L", about_x(34)},
            {"shin.L", about_x(24)},
            {"thigh.R", about_x(26)},
            {"shin.R", about_x(18)}},
           {-0.05, -0.12, 0}),
      view(figure, "above", about_x(48) * about_y(-152),
           {{"head", about_y(-16)},
            {"tail", about_x(-8)},
            {"upper_wing.L", about_z(-6)},
            {"lower_wing.L", about_z(-10) * about_y(6)},
            {"wing.L", about_z(-8)},
            {"upper_wing.R", about_z(8)},
            {"lower_wing.R", about_z(8)},
            {"wing.R", about_z(10) * about_y(-6)},
            {"thigh.L", about_x(30)},
            {"thigh.R", about_x(30)}},
           {0, 0.04, 0}),
  };
  Sketches s =
      draw(figure, views, camera, 760, 620, {.pose_error_degrees = 7, .root_error = 0.02}, 16);
  return finished(std::move(figure), std::move(s));
}

}  // namespace artisketch::figures

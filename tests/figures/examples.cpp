#include "figures/examples.h"

#include <cassert>
#include <cmath>

namespace artisketch::figures {
namespace {

// Six digits read well in a file and turn nothing by more than 1e-4 degrees.
void round_poses(Document& document) {
  for (Frame& frame : document.frames) {
    for (Quat& q : frame.pose.rotations) q.coeffs() = (1e6 * q.coeffs()).array().round() / 1e6;
    frame.pose.root_position = (1e4 * frame.pose.root_position).array().round() / 1e4;
  }
}

// Two circles seen from two sides: a ball is the smoothest thing that fits.
Example circles() {
  Figure figure = ball_figure(0.5);
  figure.name = "circles";
  const Camera camera{Camera::Type::orthographic, 200};
  Sketches s = draw(
      figure, std::vector{view(figure, "front", about_y(0)), view(figure, "side", about_y(90))},
      camera, 320, 320);
  // Drawn with compasses: points on the circle itself.
  constexpr int kPoints = 72;
  for (Document* document : {&s.given, &s.truth})
    for (Frame& frame : document->frames) {
      std::vector<Vec2>& points = frame.contours[0].line.points;
      points.clear();
      for (int i = 0; i < kPoints; ++i) {
        const double turn = 2 * kPi * i / kPoints;
        points.emplace_back(160 + 100 * std::cos(turn), 160 + 100 * std::sin(turn));
        points.back() = (1e4 * points.back()).array().round() / 1e4;
      }
    }
  return finished(std::move(figure), std::move(s), {}, "examples");
}

// The side view stands a fifth of the heart's height lower than its pose says.
Example heart_too_low() {
  Figure figure = heart();
  const Camera camera{Camera::Type::orthographic, 260};
  Sketches s = draw(figure,
                    std::vector{view(figure, "front", about_y(0)),
                                view(figure, "side", about_y(80), {}, {0, -kHeartHeight / 5, 0})},
                    camera, 400, 400);
  s.given.frames[1].pose.root_position = Vec3::Zero();
  for (Document* document : {&s.given, &s.truth}) {
    document->calibration.max_rotation = radians(10);
    document->calibration.max_translation = 0.4;
  }
  return finished(std::move(figure), std::move(s), {}, "examples");
}

Example hero_abroad() {
  Figure figure = hero();
  Camera camera;
  camera.type = Camera::Type::perspective;
  camera.distance = 6;
  camera.focal_length = 2520;
  const Vec3 root(0, -0.28, 0);
  const std::vector<View> views = {
      view(figure, "front", about_y(0),
           {{"head", about_z(6)},
            {"upper_arm.L", about_z(22)},
            {"forearm.L", about_z(48)},
            {"hand.L", about_z(-8)},
            {"upper_arm.R", about_z(58)},
            {"forearm.R", about_y(45)},
            {"thigh.L", about_z(9)},
            {"thigh.R", about_z(-7)},
            {"foot.L", about_z(-9) * about_y(18)},
            {"foot.R", about_z(7) * about_y(-14)}},
           root),
      view(figure, "side", about_y(72),
           {{"chest", about_x(5)},
            {"head", about_x(-6) * about_y(-14)},
            {"upper_arm.L", about_x(38) * about_z(-72)},
            {"forearm.L", about_y(-50)},
            {"upper_arm.R", about_x(-42) * about_z(72)},
            {"forearm.R", about_y(50)},
            {"thigh.L", about_x(-38)},
            {"shin.L", about_x(22)},
            {"thigh.R", about_x(26)},
            {"shin.R", about_x(28)},
            {"foot.R", about_x(6)}},
           root),
      view(figure, "three-quarter", about_y(-38),
           {{"chest", about_y(-8)},
            {"head", about_y(14) * about_z(-5)},
            {"upper_arm.L", about_z(-48)},
            {"forearm.L", about_y(-28) * about_z(-10)},
            {"upper_arm.R", about_y(50) * about_z(-22)},
            {"forearm.R", about_z(-25)},
            {"thigh.L", about_z(13) * about_x(-6)},
            {"shin.L", about_x(6)},
            {"foot.L", about_z(-12)},
            {"thigh.R", about_z(-10) * about_x(4)},
            {"foot.R", about_z(9)}},
           root),
  };
  Sketches s =
      draw(figure, views, camera, 640, 800, {.pose_error_degrees = 8, .root_error = 0.02}, 1);
  return finished(std::move(figure), std::move(s), {}, "examples");
}

Example fox_about() {
  Figure figure = fox();
  const Camera camera{Camera::Type::orthographic, 400};
  const std::vector<View> views = {
      view(figure, "side", about_x(4) * about_y(-82),
           {{"head", about_y(-24)},
            {"tail", about_x(-12)},
            {"fore_thigh.L", about_x(-26)},
            {"fore_shin.L", about_x(34)},
            {"fore_thigh.R", about_x(16)},
            {"hind_thigh.L", about_x(14)},
            {"hind_thigh.R", about_x(-16)},
            {"hind_shin.R", about_x(12)}},
           {0.1, 0, 0}),
      view(figure, "front", about_x(8) * about_y(28),
           {{"head", about_z(-10) * about_y(-12)},
            {"tail", about_y(30)},
            {"fore_thigh.R", about_x(-20)},
            {"fore_shin.R", about_x(28)}}),
      view(figure, "behind", about_x(6) * about_y(-145),
           {{"head", about_y(-30)},
            {"tail", about_y(-24) * about_x(14)},
            {"hind_thigh.L", about_x(18)},
            {"fore_thigh.L", about_x(-12)}}),
  };
  Sketches s =
      draw(figure, views, camera, 720, 640, {.pose_error_degrees = 8, .root_error = 0.02}, 2);
  return finished(std::move(figure), std::move(s), {}, "examples");
}

Example robot_at_work() {
  Figure figure = robot();
  Camera camera;
  camera.type = Camera::Type::perspective;
  camera.distance = 6;
  camera.focal_length = 2100;
  const Vec3 root(0, -0.22, 0);
  const std::vector<View> views = {
      view(figure, "front", about_y(-18),
           {{"upper_arm.L", about_z(-48)},
            {"forearm.L", about_z(95)},
            {"upper_arm.R", about_z(50)},
            {"forearm.R", about_z(20)},
            {"head", about_z(-6)}},
           root),
      view(figure, "side", about_y(65),
           {{"upper_arm.L", about_y(-35) * about_z(-25)},
            {"forearm.L", about_z(-20)},
            {"upper_arm.R", about_y(30) * about_z(40)},
            {"thigh.L", about_x(-22)},
            {"shin.L", about_x(18)},
            {"thigh.R", about_x(15)}},
           root),
  };
  Sketches s =
      draw(figure, views, camera, 640, 800, {.pose_error_degrees = 6, .root_error = 0.02}, 3);
  return finished(std::move(figure), std::move(s), {}, "examples");
}

using Maker = Example (*)();
constexpr std::pair<std::string_view, Maker> kMakers[] = {
    {"circles", circles},         {"heart", heart_too_low},       {"hero", hero_abroad},
    {"fox", fox_about},           {"robot", robot_at_work},       {"prince", prince_walking},
    {"horse", horse_trotting},    {"horse-three", horse_turning}, {"ballerina", ballerina_dancing},
    {"alien", alien_landed},      {"climber", climber_climbing},  {"legs", legs_dancing},
    {"parrot", parrot_flying},    {"monster", monster_once},      {"gnome", gnome_walking},
    {"knight", knight_in_pixels}, {"bear", bear_in_pencil}};

}  // namespace

Example finished(Figure figure, Sketches sketches, const InkStyle& ink, const std::string& folder) {
  for (Document* document : {&sketches.given, &sketches.truth}) {
    for (Frame& frame : document->frames) frame.image = frame.name + ".png";
    round_poses(*document);
  }
  return {folder, figure.name, std::move(figure), std::move(sketches), ink};
}

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const auto& maker : kMakers) names.emplace_back(maker.first);
  return names;
}

Example example(std::string_view name) {
  for (const auto& maker : kMakers)
    if (maker.first == name) return maker.second();
  assert(false);
  return {};
}

}  // namespace artisketch::figures

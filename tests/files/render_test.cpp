#include "files/render.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "files/occlusion.h"

namespace artisketch {
namespace {

FrameCamera camera_at(double pixels_per_unit, int size) {
  FrameCamera camera;
  camera.camera.pixels_per_unit = pixels_per_unit;
  camera.principal_point = Vec2::Constant(size / 2.0);
  return camera;
}

Model ball_model(const Vec3& centre = Vec3::Zero(), double radius = 1, int subdivisions = 4) {
  Model model;
  model.skeleton.joints.push_back({"ball", -1, Vec3::Zero(), -1, ""});
  model.mesh = icosphere(centre, radius, subdivisions);
  const auto n = model.mesh.V.rows();
  model.weights.joints.setZero(n, 4);
  model.weights.weights.setZero(n, 4);
  model.weights.weights.col(0).setOnes();
  return model;
}

Image render(const Model& model, const FrameCamera& camera, int size) {
  return render_shape(shape_of(model, nullptr, false), Transform::Identity(), camera, size, size);
}

double covered(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += image.at(x, y)[3] / 255.0;
  return sum;
}

int brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return p[0] + p[1] + p[2];
}

TEST(Render, ABallCoversItsDiscAndItsOutline) {
  const Image image = render(ball_model(), camera_at(60, 160), 160);
  // Half of the 1.5 px line lies outside.
  EXPECT_NEAR(covered(image), kPi * 60.75 * 60.75, 0.01 * kPi * 3600);
  EXPECT_EQ(image.at(0, 0)[3], 0);
  EXPECT_EQ(image.at(80, 80)[3], 255);
}

TEST(Render, TheOutlineIsDarkerThanTheInside) {
  const Image image = render(ball_model(), camera_at(60, 160), 160);
  for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1), Vec2(0.6, -0.8)}) {
    const Vec2 rim = Vec2(80, 80) + 59.8 * way, inside = Vec2(80, 80) + 54 * way;
    EXPECT_LT(brightness(image, int(rim.x()), int(rim.y())),
              0.8 * brightness(image, int(inside.x()), int(inside.y())));
  }
}

TEST(Render, AStepInDepthIsOutlinedAndASmoothSurfaceIsNot) {
  Model model = ball_model();
  const Image alone = render(model, camera_at(60, 160), 160);
  const Mesh front = icosphere({0, 0, 2}, 0.4, 4);
  Mesh both{Points3(model.mesh.V.rows() + front.V.rows(), 3),
            Triangles(model.mesh.F.rows() + front.F.rows(), 3)};
  both.V << model.mesh.V, front.V;
  both.F << model.mesh.F, (front.F.array() + int(model.mesh.V.rows())).matrix();
  model.mesh = both;
  const Image image = render(model, camera_at(60, 160), 160);
  int darkest = 3 * 255;  // across the small ball's edge, to the right
  for (int x = 102; x <= 105; ++x) darkest = std::min(darkest, brightness(image, x, 80));
  EXPECT_LT(darkest, 0.85 * brightness(image, 98, 80));
  for (int x = 40; x < 120; ++x)
    EXPECT_LT(std::abs(brightness(alone, x, 80) - brightness(alone, x + 1, 80)), 25);
}

TEST(Render, TheSameBytesEveryTime) {
  const Model model = ball_model();
  const Image a = render(model, camera_at(40, 120), 120),
              b = render(model, camera_at(40, 120), 120);
  EXPECT_EQ(a.rgba, b.rgba);
}

TEST(Render, BehindThePerspectiveCameraIsNothing) {
  FrameCamera camera = camera_at(1, 100);
  camera.camera.type = Camera::Type::perspective;
  camera.camera.distance = 4;
  camera.camera.focal_length = 100;
  EXPECT_EQ(covered(render(ball_model({0, 0, 9}), camera, 100)), 0);
  EXPECT_GT(covered(render(ball_model(), camera, 100)), kPi * 25 * 25);
  // Round the camera itself: some triangles are left out, nothing breaks.
  EXPECT_LE(covered(render(ball_model({0, 0, 4}), camera, 100)), 100.0 * 100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(covered(render(ball_model({0, nan, 0}), camera, 100)), 0);
}

TEST(Render, TexturesShowAndSeamsDoNotShade) {
  Model model = ball_model();
  const Image whole = render(model, camera_at(40, 100), 100);
  // The same ball as a soup of triangles.
  const Mesh ball = model.mesh;
  model.mesh.V.resize(3 * ball.F.rows(), 3);
  for (int i = 0; i < 3 * ball.F.rows(); ++i) {
    model.mesh.V.row(i) = ball.V.row(ball.F(i / 3, i % 3));
    model.mesh.F(i / 3, i % 3) = i;
  }
  const Image soup = render(model, camera_at(40, 100), 100);
  for (std::size_t i = 0; i < soup.rgba.size(); ++i) ASSERT_NEAR(soup.rgba[i], whole.rgba[i], 2);
  // Left half red, right half blue.
  model.texture = Image(2, 1);
  model.texture->rgba = {255, 0, 0, 255, 0, 0, 255, 255};
  for (int v = 0; v < model.mesh.V.rows(); ++v)
    model.texcoords.emplace_back(model.mesh.V(v, 0) < 0 ? 0.0 : 1.0, 0.5);
  const Image image = render(model, camera_at(40, 100), 100);
  EXPECT_GT(image.at(30, 50)[0], 2 * image.at(30, 50)[2]);
  EXPECT_GT(image.at(70, 50)[2], 2 * image.at(70, 50)[0]);
}

TEST(Light, AConvexShapeSeesTheWholeSkyAndAHollowDoesNot) {
  const Mesh ball = icosphere(Vec3::Zero(), 1, 4);
  const Eigen::VectorXd open = ambient_occlusion(ball, vertex_normals(ball));
  EXPECT_GT(open.minCoeff(), 0.9);
  EXPECT_LE(open.maxCoeff(), 1 + 1e-12);
  const Eigen::VectorXd lit = lamp_light(ball, vertex_normals(ball), Vec3(0, 0, 1), 0.16);
  for (int v = 0; v < ball.V.rows(); ++v) {
    const double toward = ball.V(v, 2);
    if (std::abs(toward) < 0.3) continue;
    EXPECT_NEAR(lit[v], toward > 0 ? 1 : 0, 0.1);
  }
  // Where two balls touch, each hides a good part of the other's surroundings.
  const Mesh other = icosphere({2, 0, 0}, 1, 4);
  Mesh two{Points3(2 * ball.V.rows(), 3), Triangles(2 * ball.F.rows(), 3)};
  two.V << ball.V, other.V;
  two.F << ball.F, (ball.F.array() + int(ball.V.rows())).matrix();
  const Eigen::VectorXd hidden = ambient_occlusion(two, vertex_normals(two));
  int touching = 0, away = 0;
  ball.V.col(0).maxCoeff(&touching);
  ball.V.col(0).minCoeff(&away);
  EXPECT_LT(hidden[touching], 0.4);
  EXPECT_GT(hidden[away], 0.9);
}

TEST(Light, TheGroundIsDarkestBelow) {
  const Mesh ball = icosphere({3, 5, -2}, 1, 4);
  const GroundShadow shadow = ground_shadow(ball);
  EXPECT_NEAR(shadow.height, 4, 1e-6);
  EXPECT_GT(shadow.at(3, -2), 0.6);
  EXPECT_LT(shadow.at(4.2, -2), shadow.at(3.4, -2));
  EXPECT_EQ(shadow.at(30, -2), 0);
  EXPECT_EQ(ground_shadow(Mesh()).at(0, 0), 0);
}

}  // namespace
}  // namespace artisketch

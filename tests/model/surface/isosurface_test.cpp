#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "model/stages.h"

namespace artisketch {
namespace {

Grid3<float> field_of(int n, double (*f)(const Vec3&)) {
  Grid3<float> g({-1, -1, -1}, 2.0 / (n - 1), Index3::Constant(n));
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) g(i, j, k) = float(f(g.position(i, j, k)));
  return g;
}

// No two vertices at one place, in single precision as a GLB stores them, and no triangle twice.
void expect_sound(const Mesh& mesh) {
  const Topology t = topology(mesh);
  EXPECT_TRUE(t.manifold()) << t.boundary_edges << " " << t.nonmanifold_edges << " "
                            << t.pinched_vertices << " " << t.misoriented_edges;
  EXPECT_EQ(t.components, 1);
  EXPECT_GT(signed_volume(mesh), 0);
  std::set<std::array<float, 3>> places;
  for (int v = 0; v < mesh.V.rows(); ++v)
    places.insert({float(mesh.V(v, 0)), float(mesh.V(v, 1)), float(mesh.V(v, 2))});
  EXPECT_EQ(places.size(), std::size_t(mesh.V.rows()));
  std::set<std::array<int, 3>> faces;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    std::array<int, 3> face = {mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)};
    std::sort(face.begin(), face.end());
    faces.insert(face);
  }
  EXPECT_EQ(faces.size(), std::size_t(mesh.F.rows()));
}

TEST(Isosurface, OfASphereIsASphere) {
  const auto mesh = isosurface(field_of(40, [](const Vec3& p) { return p.norm() - 0.8; }));
  ASSERT_TRUE(mesh);
  expect_sound(*mesh);
  EXPECT_EQ(topology(*mesh).genus(), 0);
  for (int v = 0; v < mesh->V.rows(); ++v) EXPECT_NEAR(mesh->V.row(v).norm(), 0.8, 1e-3);
  EXPECT_NEAR(signed_volume(*mesh), 4 * kPi / 3 * std::pow(0.8, 3), 0.01);
}

TEST(Isosurface, OfATorusKeepsItsHole) {
  const auto mesh = isosurface(field_of(
      40, [](const Vec3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 0.6, p.z()) - 0.2; }));
  ASSERT_TRUE(mesh);
  expect_sound(*mesh);
  EXPECT_EQ(topology(*mesh).genus(), 1);
}

TEST(Isosurface, StaysOneManifoldInNoise) {
  std::mt19937 random(7);
  std::normal_distribution<float> noise;
  for (int round = 0; round < 12; ++round) {
    Grid3<float> g({-1, -1, -1}, 0.1, {17, 15, 19});
    const float bias = 0.25f * float(round % 6) - 0.5f;
    for (float& v : g.values) v = noise(random) + bias;
    const auto mesh = isosurface(g);
    ASSERT_TRUE(mesh);
    expect_sound(*mesh);
  }
}

// Each of the 256 ways to mark a cube's corners, alone and next to its opposite.
TEST(Isosurface, StaysOneManifoldForEveryCube) {
  for (int marks = 1; marks < 256; ++marks)
    for (const int fill : {0, 1}) {
      Grid3<float> g({0, 0, 0}, 1, {4, 4, 4}, fill ? -1.f : 1.f);
      for (int c = 0; c < 8; ++c)
        if (marks >> c & 1) g(1 + (c & 1), 1 + (c >> 1 & 1), 1 + (c >> 2)) = fill ? 0.5f : -0.5f;
      const auto mesh = isosurface(g);
      ASSERT_TRUE(mesh);
      expect_sound(*mesh);
    }
}

TEST(Isosurface, ClosesWhatTouchesTheBorder) {
  const auto mesh = isosurface(field_of(12, [](const Vec3& p) { return p.x() - 0.1; }));
  ASSERT_TRUE(mesh);
  expect_sound(*mesh);
  EXPECT_GT(signed_volume(*mesh), 1.1 * 2 * 2);
  Grid3<float> full({0, 0, 0}, 1, {2, 2, 2}, -1.f);
  expect_sound(*isosurface(full));
}

TEST(Isosurface, TakesSamplesOnTheSurfaceAndWildOnes) {
  Grid3<float> g({0, 0, 0}, 1, {6, 6, 6}, 0.f);
  g(2, 2, 2) = -1e-30f;
  g(3, 2, 2) = -std::numeric_limits<float>::infinity();
  g(3, 3, 2) = std::numeric_limits<float>::quiet_NaN();
  g(2, 3, 2) = std::numeric_limits<float>::max();
  g(2, 2, 3) = -std::numeric_limits<float>::max();
  const auto mesh = isosurface(g);
  ASSERT_TRUE(mesh);
  expect_sound(*mesh);
  EXPECT_TRUE(mesh->V.allFinite());
}

TEST(Isosurface, KeepsTheLargestPieceAndFillsHollows) {
  const auto mesh = isosurface(field_of(40, [](const Vec3& p) {
    const double ball = std::abs((p - Vec3(-0.3, 0, 0)).norm() - 0.4) - 0.15;  // hollow
    return std::min(ball, (p - Vec3(0.7, 0.7, 0.7)).norm() - 0.2);
  }));
  ASSERT_TRUE(mesh);
  expect_sound(*mesh);
  EXPECT_NEAR(signed_volume(*mesh), 4 * kPi / 3 * std::pow(0.55, 3), 0.02);
}

TEST(Isosurface, OfNothingIsAnError) {
  EXPECT_FALSE(isosurface(Grid3<float>({0, 0, 0}, 1, {5, 5, 5}, 1.f)));
  EXPECT_FALSE(isosurface(Grid3<float>({0, 0, 0}, 1, {1, 1, 1}, 1.f)));
}

}  // namespace
}  // namespace artisketch

#include "base/mesh_distance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

Vec3 vertex(const Mesh& mesh, int f, int c) {
  return mesh.V.row(mesh.F(f, c)).transpose();
}

// Ericson, "Real-Time Collision Detection", 5.1.5: by the triangle's Voronoi regions.
double to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto to_segment = [&](const Vec3& u, const Vec3& v) {
    const double uv = (v - u).squaredNorm();
    const double t = uv > 0 ? std::clamp((p - u).dot(v - u) / uv, 0.0, 1.0) : 0.0;
    return (p - u - t * (v - u)).norm();
  };
  double best = std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
  const Vec3 n = (b - a).cross(c - a);
  if (n.norm() > 0 && n.cross(b - a).dot(p - a) >= 0 && n.cross(c - b).dot(p - b) >= 0 &&
      n.cross(a - c).dot(p - c) >= 0)
    best = std::min(best, std::abs(n.dot(p - a)) / n.norm());
  return best;
}

double brute_force(const Mesh& mesh, const Vec3& p) {
  double best = 1e300;
  for (int f = 0; f < mesh.F.rows(); ++f)
    best =
        std::min(best, to_triangle(p, vertex(mesh, f, 0), vertex(mesh, f, 1), vertex(mesh, f, 2)));
  return best;
}

// Solid angle over 4π (Van Oosterom and Strackee 1983).
double winding(const Mesh& mesh, const Vec3& p) {
  double sum = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = vertex(mesh, f, 0) - p, b = vertex(mesh, f, 1) - p, c = vertex(mesh, f, 2) - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)),
                          la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * kPi);
}

Mesh box_mesh(const Vec3& low, const Vec3& high) {
  Mesh mesh{Points3(8, 3), Triangles(12, 3)};
  for (int i = 0; i < 8; ++i)
    mesh.V.row(i) << (i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z();
  mesh.F << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4,
      6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

void expect_exact(const Mesh& mesh, const Grid3<float>& g, double band) {
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i) {
        const Vec3 p = g.position(i, j, k);
        const double exact = brute_force(mesh, p), found = std::abs(g(i, j, k));
        if (exact < band * g.cell)
          ASSERT_NEAR(found, exact, 2e-5 * g.cell) << p.transpose();
        else
          ASSERT_GE(found, band * g.cell * 0.999999) << p.transpose();
        if (exact > 1e-9) {
          ASSERT_EQ(g(i, j, k) < 0, winding(mesh, p) > 0.5) << p.transpose();
        }
      }
}

TEST(MeshDistance, IsExactInTheBandOfACoarseSphere) {
  const Mesh sphere = icosphere({0.1, 0.05, -0.02}, 0.4, 1);
  Grid3<float> field({-0.5, -0.6, -0.5}, 0.06, {18, 19, 18});
  mesh_distance(sphere, 3, field);
  expect_exact(sphere, field, 3);
}

TEST(MeshDistance, IsExactForABoxWhoseFacesLieOnSamples) {
  const Mesh box = box_mesh({0, 0, 0}, {4, 2, 1});
  Grid3<float> field({-2, -2, -2}, 0.5, {16, 13, 11});
  mesh_distance(box, 2.5, field);
  expect_exact(box, field, 2.5);
}

// Random tetrahedra: sharp edges, obtuse and acute corners, slivers.
TEST(MeshDistance, IsExactForSpikes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(0.5, 7.5);
  for (int round = 0; round < 20; ++round) {
    Mesh spike{Points3(4, 3), Triangles(4, 3)};
    for (int i = 0; i < 12; ++i) spike.V(i / 3, i % 3) = x(random);
    if (round % 4 == 0) spike.V.row(3) = (spike.V.row(0) + spike.V.row(1)) / 2;  // flat
    spike.F << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
    if (signed_volume(spike) < 0) spike.F.col(1).swap(spike.F.col(2));
    Grid3<float> field({0, 0, 0}, 1, {9, 9, 9});
    mesh_distance(spike, 3, field);
    expect_exact(spike, field, 3);
  }
}

TEST(MeshDistance, CountsWhatOverlapsAsInside) {
  Mesh two = icosphere({0, 0, 0}, 1, 1);
  const Mesh other = icosphere({0.7, 0.1, 0}, 1, 1);
  const int n = int(two.V.rows()), m = int(two.F.rows());
  two.V.conservativeResize(2 * n, 3);
  two.F.conservativeResize(2 * m, 3);
  two.V.bottomRows(n) = other.V;
  two.F.bottomRows(m) = other.F.array() + n;
  Grid3<float> field({-1.5, -1.5, -1.5}, 0.15, {26, 21, 21});
  mesh_distance(two, 2, field);
  expect_exact(two, field, 2);
}

TEST(MeshDistance, HoldsForAMeshThatLeavesTheGrid) {
  const Mesh sphere = icosphere({0, 0, 0}, 1, 2);
  Grid3<float> field({0.03, -0.2, -0.11}, 0.08, {9, 9, 9});
  mesh_distance(sphere, 3, field);
  expect_exact(sphere, field, 3);
}

TEST(MeshDistance, WithoutTrianglesAllIsOutside) {
  Grid3<float> field({0, 0, 0}, 0.5, {4, 4, 4});
  mesh_distance(Mesh{Points3(0, 3), Triangles(0, 3)}, 3, field);
  for (const float v : field.values) EXPECT_FLOAT_EQ(v, 1.5f);
}

}  // namespace
}  // namespace artisketch

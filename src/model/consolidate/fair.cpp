#include "model/consolidate/fair.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

namespace artisketch {
namespace {

// A crease is blended over at most this share of the sphere's radius …
constexpr double kReach = 0.5;
// … and so far that rounding it moves the surface by at most this many cells: a fillet of radius ρ
// over a bend of β radians stands ρ (1 / cos(β/2) − 1) ≈ ρ β² / 8 off its edge.
constexpr double kMostMoved = 0.75;

// Over how many units to blend at a vertex: 0 away from every sphere and every crease.
double blend_width(const Body& body, std::span<const int> near,
                   std::span<const JointSphere> spheres, const Vec3& p, const Vec3& normal,
                   int owner, double cell) {
  double widest = 0;
  for (const JointSphere& sphere : spheres) {
    const double depth = 1 - (p - sphere.centre).norm() / sphere.radius;
    if (depth <= 0) continue;
    for (const int part : near) {
      if (part == owner) continue;
      Vec3 gradient;
      const double d = std::abs(body.part_distance(part, p, gradient));
      if (d >= kReach * sphere.radius) continue;
      const double bend = std::acos(std::clamp(normal.dot(gradient.normalized()), -1.0, 1.0));
      const double reach =
          std::min(kReach * sphere.radius, 8 * kMostMoved * cell / std::max(bend * bend, 1e-6));
      // Fades out away from the crease and towards the sphere's border.
      widest = std::max(widest, reach * std::clamp(1 - d / reach, 0.0, 1.0) *
                                    std::min({1.0, 4 * depth, 4 * bend}));
    }
  }
  return widest;
}

// Moves the vertices with a width (in cells, per vertex) to where the bi-Laplacian is least.
void smooth(const Adjacency& adjacency, const Eigen::VectorXd& width, QuadMesh& mesh) {
  const int n = int(mesh.V.rows());
  std::vector<int> unknown(n, -1), moving;
  for (int v = 0; v < n; ++v)
    if (width[v] > 0.5) unknown[v] = int(moving.size()), moving.push_back(v);
  if (moving.empty()) return;
  // Energy: Σ |x_v − mean of its neighbours|² over all v that a moving one touches, plus
  // Σ width⁻⁴ |x_v − where it is|².
  const int m = int(moving.size());
  std::vector<char> touched(n, 0);
  for (const int v : moving) {
    touched[v] = 1;
    for (const int u : adjacency.of(v)) touched[u] = 1;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Points3 right = Points3::Zero(m, 3);
  std::vector<std::pair<int, double>> row;
  for (int v = 0; v < n; ++v) {
    if (!touched[v]) continue;
    row.assign(1, {v, 1.0});
    const auto ring = adjacency.of(v);
    for (const int u : ring) row.push_back({u, -1.0 / double(ring.size())});
    for (const auto& [a, wa] : row) {
      if (unknown[a] < 0) continue;
      for (const auto& [b, wb] : row)
        if (unknown[b] >= 0)
          entries.emplace_back(unknown[a], unknown[b], wa * wb);
        else
          right.row(unknown[a]) -= wa * wb * mesh.V.row(b);
    }
  }
  for (int k = 0; k < m; ++k) {
    const double w = std::pow(width[moving[k]], -4);
    entries.emplace_back(k, k, w);
    right.row(k) += w * mesh.V.row(moving[k]);
  }
  Eigen::SparseMatrix<double> A(m, m);
  A.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
  if (solver.info() != Eigen::Success) return;
  const Points3 x = solver.solve(right);
  if (!x.allFinite()) return;
  for (int k = 0; k < m; ++k) mesh.V.row(moving[k]) = x.row(k);
}

constexpr double kFree = 1e3;  // cells: a width so large holds a vertex to nothing

}  // namespace

void fair(const Body& body, const Body::Sampled& sampled, std::span<const JointSphere> spheres,
          const SurfaceProjection& projection, QuadMesh& mesh) {
  const int n = int(mesh.V.rows());
  const BlockGrid& grid = sampled.grid;
  const Adjacency adjacency = quad_adjacency(mesh);
  // Blend widths in cells; free vertices blend as wide as their neighbourhood asks, at least 3.
  Eigen::VectorXd width = Eigen::VectorXd::Zero(n);
  for (int v = 0; v < n; ++v) {
    const Vec3 p = mesh.V.row(v).transpose();
    if (projection.free[v]) {
      width[v] = kFree;
      continue;
    }
    bool in_sphere = false;
    for (const JointSphere& s : spheres)
      in_sphere |= (p - s.centre).squaredNorm() < s.radius * s.radius;
    if (!in_sphere) continue;
    width[v] = blend_width(body, sampled.near_at(p), spheres, p,
                           projection.normals.row(v).transpose(), projection.owner[v], grid.cell) /
               grid.cell;
  }
  smooth(adjacency, width, mesh);
}

void fair_inside(std::span<const Capsule> balls, double cell, QuadMesh& mesh) {
  Eigen::VectorXd width = Eigen::VectorXd::Zero(mesh.V.rows());
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v)
    for (const Capsule& ball : balls)
      if (ball.distance(mesh.V.row(v).transpose()) < cell) width[v] = kFree;
  if (width.minCoeff() > 0) return;  // nothing would hold the rest
  smooth(quad_adjacency(mesh), width, mesh);
}

}  // namespace artisketch

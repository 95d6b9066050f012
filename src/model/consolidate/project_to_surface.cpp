#include "model/consolidate/project_to_surface.h"

#include <algorithm>

namespace artisketch {

SurfaceProjection project_to_surface(const Body& body, const Body::Sampled& sampled,
                                     QuadMesh& mesh) {
  const BlockGrid& grid = sampled.grid;
  const int n = int(mesh.V.rows());
  const Adjacency adjacency = quad_adjacency(mesh);
  std::vector<std::span<const int>> near(n);  // the parts about where each vertex was
  for (int v = 0; v < n; ++v) near[v] = sampled.near_at(mesh.V.row(v).transpose());
  SurfaceProjection projection{Points3::Zero(n, 3), std::vector<int>(n, -1),
                               std::vector<char>(n, 0)};
  const Points3 start = mesh.V;
  // A vertex that a step of a cell doesn't bring onto the zero set lies where a gap was closed.
  const double most = 0.9 * grid.cell;
  const auto project = [&](int v, Vec3& p) {
    const Body::Reading r = body.read(p, near[v]);
    const double g2 = r.gradient.squaredNorm();
    projection.owner[v] = r.part;
    if (!(g2 > 1e-4)) return r.distance;
    projection.normals.row(v) = (r.gradient / std::sqrt(g2)).transpose();
    p -= std::clamp(r.distance / g2, -most, most) * r.gradient;
    return r.distance;
  };
  for (int v = 0; v < n; ++v) {
    Vec3 p = start.row(v).transpose();
    project(v, p);
    project(v, p);
    Vec3 q = p;
    const double left = std::abs(project(v, q));
    projection.free[v] =
        left > 0.25 * grid.cell || (p - start.row(v).transpose()).norm() > 1.2 * grid.cell;
    if (!projection.free[v]) mesh.V.row(v) = q.transpose();
  }
  // Evenly along the surface, back onto it after each step.
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const Points3 from = mesh.V;
    for (int v = 0; v < n; ++v) {
      const auto ring = adjacency.of(v);
      if (ring.empty()) continue;
      Vec3 mean = Vec3::Zero();
      for (const int u : ring) mean += from.row(u).transpose();
      mean /= double(ring.size());
      const Vec3 p = from.row(v).transpose();
      Vec3 step = 0.5 * (mean - p);
      if (projection.free[v]) {
        mesh.V.row(v) += step.transpose();
        continue;
      }
      const Vec3 normal = projection.normals.row(v).transpose();
      step -= step.dot(normal) * normal;
      Vec3 q = p + step;
      project(v, q);
      mesh.V.row(v) = q.transpose();
    }
  }
  for (int v = 0; v < n; ++v)
    if (projection.free[v]) projection.owner[v] = -1;
  return projection;
}

}  // namespace artisketch

#include "model/consolidate/resolve_self_intersections.h"

#include <algorithm>
#include <cmath>

#include "base/face_neighbours.h"
#include "base/self_intersection.h"
#include "model/consolidate/unfold.h"

namespace artisketch {

int resolve_self_intersections(Mesh& mesh) {
  constexpr int kRounds = 20;
  constexpr int kSteps = 4;  // of smoothing, per round
  if (mesh.V.rows() == 0) return 0;
  const double step = position_step(mesh.V);
  const auto rounded = [&](double x) { return std::nearbyint(x / step) * step; };
  mesh.V = mesh.V.unaryExpr(rounded);
  Adjacency adjacency;
  std::vector<int> rings(mesh.V.rows(), 0);  // how wide to smooth, wider where it didn't help
  for (int round = 0;; ++round) {
    const auto crossings = self_intersections(mesh);
    if (crossings.empty() || round == kRounds) return int(crossings.size());
    if (round == 0) adjacency = vertex_adjacency(mesh);
    std::vector<int> moving;
    for (const auto& [f, g] : crossings)
      for (int c = 0; c < 3; ++c) moving.insert(moving.end(), {mesh.F(f, c), mesh.F(g, c)});
    const auto once = [](std::vector<int>& list) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    once(moving);
    int wide = 0;
    for (const int v : moving) wide = std::max(wide, ++rings[v]);
    for (int ring = 1; ring < wide; ring += 2) {
      const std::vector<int> front = moving;
      for (const int v : front)
        for (const int u : adjacency.of(v)) moving.push_back(u);
      once(moving);
    }
    for (int step = 0; step < kSteps; ++step) {
      Points3 next(moving.size(), 3);
      for (std::size_t k = 0; k < moving.size(); ++k) {
        const auto ring = adjacency.of(moving[k]);
        Vec3 mean = Vec3::Zero();
        for (const int u : ring) mean += mesh.V.row(u).transpose();
        next.row(k) = 0.5 * (mesh.V.row(moving[k]) + mean.transpose() / double(ring.size()));
      }
      for (std::size_t k = 0; k < moving.size(); ++k) mesh.V.row(moving[k]) = next.row(k);
    }
    for (const int v : moving) mesh.V.row(v) = mesh.V.row(v).unaryExpr(rounded);
  }
}

SurfaceFaults mend_surface(Mesh& mesh) {
  constexpr int kTurns = 3;
  SurfaceFaults left;
  for (int turn = 0; turn < kTurns; ++turn) {
    unfold(mesh);
    left.crossings = resolve_self_intersections(mesh);
    left.folds = int(folds(mesh, face_neighbours(mesh.F)).size());
    if (left.folds == 0) break;
  }
  return left;
}

}  // namespace artisketch

// Fewer triangles where the surface is flat, by quadric error edge collapses (Garland and Heckbert
// 1997) through meshoptimizer.
#include <algorithm>
#include <vector>

#include <meshoptimizer.h>

#include "base/coarsen.h"
#include "model/consolidate/resolve_self_intersections.h"
#include "model/stages.h"

namespace artisketch {
namespace {

// The same surface with about `triangles` triangles, or more where `error` (units) would be passed,
// over the same vertices. Triangles at a vertex that is `held` stay as they are.
Triangles collapsed(const Mesh& mesh, const std::vector<char>& held, int triangles, double error) {
  // Single precision about the middle keeps a collapse's error well under the tolerance.
  const Vec3 middle = bounds(mesh.V).center();
  std::vector<float> positions(3 * mesh.V.rows());
  for (int v = 0; v < mesh.V.rows(); ++v)
    for (int a = 0; a < 3; ++a) positions[3 * v + a] = float(mesh.V(v, a) - middle[a]);
  std::vector<unsigned> loose, firm;
  loose.reserve(std::size_t(mesh.F.size()));
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const bool hold = held[mesh.F(f, 0)] || held[mesh.F(f, 1)] || held[mesh.F(f, 2)];
    for (int c = 0; c < 3; ++c) (hold ? firm : loose).push_back(unsigned(mesh.F(f, c)));
  }
  std::vector<unsigned> kept(loose.size());
  const float scale = meshopt_simplifyScale(positions.data(), mesh.V.rows(), 3 * sizeof(float));
  const std::size_t wanted = 3 * std::size_t(triangles);
  kept.resize(meshopt_simplify(kept.data(), loose.data(), loose.size(), positions.data(),
                               mesh.V.rows(), 3 * sizeof(float),
                               wanted > firm.size() ? wanted - firm.size() : 0,
                               float(error / scale), meshopt_SimplifyLockBorder, nullptr));
  kept.insert(kept.end(), firm.begin(), firm.end());
  Triangles F(Eigen::Index(kept.size() / 3), 3);
  for (std::size_t i = 0; i < kept.size(); ++i) F(Eigen::Index(i / 3), int(i % 3)) = int(kept[i]);
  return F;
}

// The vertices whose triangles don't make one closed fan.
std::vector<int> pinched(const Triangles& F, Eigen::Index vertices) {
  struct Side {
    int from, to;  // opposite the vertex, in its triangle's order
  };
  std::vector<std::vector<Side>> round(vertices);
  for (Eigen::Index f = 0; f < F.rows(); ++f)
    for (int c = 0; c < 3; ++c) round[F(f, c)].push_back({F(f, (c + 1) % 3), F(f, (c + 2) % 3)});
  std::vector<int> found;
  for (int v = 0; v < int(vertices); ++v) {
    const std::vector<Side>& sides = round[v];
    if (sides.empty()) continue;
    // Round the fan from its first side: back there after as many steps as it has sides.
    std::size_t steps = 0;
    int at = sides[0].from;
    do {
      const auto next =
          std::find_if(sides.begin(), sides.end(), [&](const Side& s) { return s.from == at; });
      if (next == sides.end()) break;
      at = next->to;
      ++steps;
    } while (at != sides[0].from && steps <= sides.size());
    if (at != sides[0].from || steps != sides.size()) found.push_back(v);
  }
  return found;
}

// Marks all within some rings of the given vertices.
void hold(const Adjacency& beside, std::vector<int> front, std::vector<char>& held) {
  constexpr int kRings = 4;  // round a limb thin enough to be pinched
  for (const int v : front) held[v] = 1;
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<int> next;
    for (const int v : front)
      for (const int u : beside.of(v))
        if (!held[u]) held[u] = 1, next.push_back(u);
    front = std::move(next);
  }
}

// As collapsed; what comes out pinched is held and the rest collapsed anew.
Mesh collapsed_unpinched(const Mesh& mesh, int triangles, double error) {
  constexpr int kTries = 4;
  std::vector<char> held(mesh.V.rows(), 0);
  Triangles F = collapsed(mesh, held, triangles, error);
  std::vector<int> wrong = pinched(F, mesh.V.rows());
  const Adjacency beside = wrong.empty() ? Adjacency() : vertex_adjacency(mesh);
  for (int tries = 1; tries < kTries && !wrong.empty(); ++tries) {
    hold(beside, wrong, held);
    F = collapsed(mesh, held, triangles, error);
    wrong = pinched(F, mesh.V.rows());
  }
  return without_unused_vertices({mesh.V, F});
}

// Neighbours beside each other, as graphics cards and packers like them.
Mesh in_drawing_order(const Mesh& mesh) {
  std::vector<unsigned> corners(mesh.F.data(), mesh.F.data() + mesh.F.size());
  meshopt_optimizeVertexCache(corners.data(), corners.data(), corners.size(), mesh.V.rows());
  std::vector<unsigned> place(mesh.V.rows());
  meshopt_optimizeVertexFetchRemap(place.data(), corners.data(), corners.size(), mesh.V.rows());
  Mesh ordered = mesh;
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) ordered.V.row(place[v]) = mesh.V.row(v);
  std::transform(corners.begin(), corners.end(), ordered.F.data(),
                 [&](unsigned v) { return int(place[v]); });
  return ordered;
}

}  // namespace

Mesh simplified(const Mesh& mesh, int triangles, double error) {
  if (mesh.F.rows() <= triangles) return mesh;
  int components = 0;
  vertex_components(mesh, &components);
  // Three sides to a triangle, two triangles to an edge.
  const int euler = int(mesh.V.rows() - mesh.F.rows() / 2);
  // meshoptimizer looks at a vertex's own triangles alone and may pinch a thin place; the more it
  // takes away, the likelier. The shortest edges, which say the least, go by our own
  // collapses, which keep the surface a manifold: the more of them, the rarer a pinch. They
  // know no error, so most of the triangles are left to those that do.
  for (const double wanted : {1.0, 1.25, 1.5})
    for (const double more : {4.0, 3.0, 2.0}) {
      const double enough = std::max(more * triangles, mesh.F.rows() / 6.0);
      const Mesh even = mesh.F.rows() > enough ? coarsened(mesh, int(enough / 2)) : mesh;
      Mesh fewer = collapsed_unpinched(even, int(wanted * triangles), error);
      const Topology after = topology(fewer);
      // Thin places pass through each other where their sides are thinned apart.
      if (after.manifold() && after.euler == euler && after.components == components &&
          resolve_self_intersections(fewer) == 0)
        return in_drawing_order(fewer);
    }
  Mesh even = coarsened(mesh, int(std::max(1.5 * triangles, mesh.F.rows() / 6.0) / 2));
  resolve_self_intersections(even);
  return even;
}

}  // namespace artisketch

// Fewer triangles where the surface is flat, by quadric error edge collapses (Garland and Heckbert
// 1997) through meshoptimizer.
#include <algorithm>
#include <vector>

#include <meshoptimizer.h>

#include "base/coarsen.h"
#include "model/fair.h"
#include "model/stages.h"

namespace artisketch {
namespace {

// The same surface with about `triangles` triangles, or more where `error` (units) would be passed.
Mesh collapsed(const Mesh& mesh, int triangles, double error) {
  // Single precision about the middle keeps a collapse's error well under the tolerance.
  const Vec3 middle = bounds(mesh.V).center();
  std::vector<float> positions(3 * mesh.V.rows());
  for (int v = 0; v < mesh.V.rows(); ++v)
    for (int a = 0; a < 3; ++a) positions[3 * v + a] = float(mesh.V(v, a) - middle[a]);
  const std::vector<unsigned> indices(mesh.F.data(), mesh.F.data() + mesh.F.size());
  std::vector<unsigned> kept(indices.size());
  const float scale = meshopt_simplifyScale(positions.data(), mesh.V.rows(), 3 * sizeof(float));
  const std::size_t count = meshopt_simplify(
      kept.data(), indices.data(), indices.size(), positions.data(), mesh.V.rows(),
      3 * sizeof(float), 3 * std::size_t(triangles), float(error / scale), 0, nullptr);
  Mesh out{mesh.V, Triangles(count / 3, 3)};
  for (std::size_t i = 0; i < count; ++i) out.F(i / 3, i % 3) = int(kept[i]);
  return without_unused_vertices(out);
}

}  // namespace

Mesh simplified(const Mesh& mesh, int triangles, double error) {
  if (mesh.F.rows() <= triangles) return mesh;
  int components = 0;
  vertex_components(mesh, &components);
  // Three sides to a triangle, two triangles to an edge.
  const int euler = int(mesh.V.rows() - mesh.F.rows() / 2);
  // meshoptimizer looks at a vertex's own triangles alone and may, rarely, pinch a thin place; the
  // more it takes away, the likelier. The shortest edges, which say the least, go by our own
  // collapses, which keep the surface a manifold: the more of them, the rarer a pinch. They
  // know no error, so most of the triangles are left to those that do.
  for (const double wanted : {1.0, 1.25, 1.5})
    for (const double more : {4.0, 3.0, 2.0}) {
      const double enough = std::max(more * triangles, mesh.F.rows() / 6.0);
      const Mesh even = mesh.F.rows() > enough ? coarsened(mesh, int(enough / 2)) : mesh;
      Mesh fewer = collapsed(even, int(wanted * triangles), error);
      const Topology after = topology(fewer);
      // Thin places pass through each other where their sides are thinned apart.
      if (after.manifold() && after.euler == euler && after.components == components &&
          untangle(fewer) == 0)
        return fewer;
    }
  Mesh even = coarsened(mesh, int(std::max(1.5 * triangles, mesh.F.rows() / 6.0) / 2));
  untangle(even);
  return even;
}

}  // namespace artisketch

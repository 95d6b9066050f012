// Fewer triangles where the surface is flat.
#include <algorithm>
#include <limits>
#include <vector>

#include <meshoptimizer.h>

#include "base/coarsen.h"
#include "model/consolidate/quadric_collapse.h"
#include "model/consolidate/resolve_self_intersections.h"
#include "model/stages.h"

namespace artisketch {
namespace {

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
  Mesh best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  // Thin places pass through each other where their sides are thinned apart: the evener the
  // triangles, the rarer that is.
  for (const double more : {4.0, 2.0, 1.0}) {
    const double even = std::max(more * triangles, mesh.F.rows() / 6.0);
    Mesh fewer =
        collapsed(mesh.F.rows() > even ? coarsened(mesh, int(even / 2)) : mesh, triangles, error);
    const std::size_t crossings = std::size_t(mend_surface(fewer).crossings);
    if (crossings < least) least = crossings, best = std::move(fewer);
    if (least == 0) break;
  }
  return in_drawing_order(best);
}

}  // namespace artisketch

#include "model/consolidate/thinned.h"

#include <vector>

#include <meshoptimizer.h>

namespace artisketch {

Mesh thinned(const Mesh& mesh, double error) {
  const Vec3 middle = bounds(mesh.V).center();
  std::vector<float> positions(std::size_t(mesh.V.size()));
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v)
    for (int a = 0; a < 3; ++a) positions[std::size_t(3 * v + a)] = float(mesh.V(v, a) - middle[a]);
  const std::vector<unsigned> corners(mesh.F.data(), mesh.F.data() + mesh.F.size());
  std::vector<unsigned> kept(corners.size());
  const std::size_t vertices = std::size_t(mesh.V.rows());
  const float scale = meshopt_simplifyScale(positions.data(), vertices, 3 * sizeof(float));
  kept.resize(meshopt_simplify(kept.data(), corners.data(), corners.size(), positions.data(),
                               vertices, 3 * sizeof(float), 0, float(error / scale), 0, nullptr));
  Triangles F(Eigen::Index(kept.size() / 3), 3);
  for (std::size_t i = 0; i < kept.size(); ++i) F.data()[i] = int(kept[i]);
  return without_unused_vertices({mesh.V, F});
}

}  // namespace artisketch

#include "editor/session/view.h"

#include <algorithm>
#include <cmath>

namespace artisketch {

Orbit orbit_round(const Model& model) {
  const Box3 box = bounds(model.mesh.V);
  Orbit orbit;
  orbit.target = Vec3(0, box.sizes().y() / 2, 0);
  const double reach =
      std::max(box.sizes().y(), 1.1 * std::hypot(box.sizes().x(), box.sizes().z()));
  orbit.distance = std::max(1e-3, 1.5 * reach);
  return orbit;
}

}  // namespace artisketch

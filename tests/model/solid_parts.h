// Part surfaces of a figure's exact solids: what a perfect reconstruction of its parts would give.
#pragma once

#include <vector>

#include "figures.h"
#include "model/stages.h"

namespace artisketch::figures {

// The solid sampled with `cells` steps along its longest side and two of margin.
inline PartSurface surface_of(const Solid& solid, int joint, int cells) {
  const Box3 box = bounds(solid);
  const double cell = box.sizes().maxCoeff() / cells;
  const Index3 size = (box.sizes() / cell).array().ceil().cast<int>() + 5;
  PartSurface surface;
  surface.joint = joint;
  surface.distance = Grid3<float>(box.min() - Vec3::Constant(2 * cell), cell, size);
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
        surface.distance(i, j, k) = float(distance(solid, surface.distance.position(i, j, k)));
  return surface;
}

inline std::vector<PartSurface> surfaces_of(const Figure& figure, int cells) {
  std::vector<PartSurface> surfaces;
  for (int j = 0; j < int(figure.parts.size()); ++j)
    if (!figure.parts[j].empty()) surfaces.push_back(surface_of(figure.parts[j], j, cells));
  return surfaces;
}

}  // namespace artisketch::figures

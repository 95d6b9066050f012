// Which view paints which triangle.
#pragma once

#include <array>

#include "model/texture/drawn_surface.h"

namespace artisketch {

// #F×3: the face beyond the edge from corner k to the next, −1 where there is none.
using FaceNeighbours = std::vector<std::array<int, 3>>;
FaceNeighbours face_neighbours(const Triangles& F);

// Per triangle the index of the view that paints it, −1 where none can: views that see it well,
// the same as its neighbours', and changing where both views have the same colour. Minimises that
// sum over the mesh by sequential tree-reweighted message passing (Kolmogorov 2006).
// Views in mirror images serve where nothing else does.
std::vector<int> choose_views(const Mesh& mesh, const FaceNeighbours& neighbours,
                              const DrawnSurface& surface);

}  // namespace artisketch

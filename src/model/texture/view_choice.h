// Which view paints which triangle.
#pragma once

#include "base/face_neighbours.h"
#include "model/texture/drawn_surface.h"

namespace artisketch {

// Per triangle the index of the view that paints it, −1 where none can: views that see it well,
// the same as its neighbours', and changing where both views have the same colour. Minimises that
// sum over the mesh by sequential tree-reweighted message passing (Kolmogorov 2006).
// Views in mirror images serve where nothing else does.
std::vector<int> choose_views(const Mesh& mesh, const FaceNeighbours& neighbours,
                              const DrawnSurface& surface);

}  // namespace artisketch

// Which triangles lie beside which.
#pragma once

#include <array>
#include <vector>

#include "base/mesh.h"

namespace artisketch {

// #F×3: the face beyond the edge from corner k to the next, −1 where there is none.
using FaceNeighbours = std::vector<std::array<int, 3>>;
FaceNeighbours face_neighbours(const Triangles& F);

}  // namespace artisketch

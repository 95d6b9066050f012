// Where a surface passes through itself.
#pragma once

#include <utility>
#include <vector>

#include "base/mesh.h"

namespace artisketch {

// Pairs of triangles that share no vertex and yet meet, lower face first, in ascending order.
std::vector<std::pair<int, int>> self_intersections(const Mesh& mesh);

}  // namespace artisketch

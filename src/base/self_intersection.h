// Where a surface passes through itself.
#pragma once

#include <utility>
#include <vector>

#include "base/mesh.h"

namespace artisketch {

// Pairs of triangles that share no vertex and yet pass through each other, lower face first, in
// ascending order. Touching or lying in one plane doesn't count.
std::vector<std::pair<int, int>> self_intersections(const Mesh& mesh);

}  // namespace artisketch

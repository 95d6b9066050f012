// Mends the places where a surface is folded over its own edges.
#pragma once

#include <utility>
#include <vector>

#include "base/face_neighbours.h"

namespace artisketch {

// Pairs of neighbouring triangles that face away from each other: an angle over 90° between their
// normals. mesh: a closed 2-manifold.
std::vector<std::pair<int, int>> folds(const Mesh& mesh, const FaceNeighbours& beside);

// Turns edges, and where that doesn't do smooths the vertices round them, until no fold is
// left, or for a few rounds. A sharp edge that the surface has by right, a box's or a blade's,
// bends by no more than that or is rounded by less than its triangles' size. Same vertices and
// topology, none moved that isn't near a fold. mesh: a closed 2-manifold. Returns how many edges
// are still folded.
int unfold(Mesh& mesh);

}  // namespace artisketch

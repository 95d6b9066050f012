// Smooths a surface where it passes through itself.
#pragma once

#include "base/mesh.h"

namespace artisketch {

// Smooths around the places where the surface passes through itself until it no longer does, or
// for a few rounds. Positions come out rounded by position_step: what no longer crosses here does
// not cross in a file either. Returns how many pairs of triangles still cross.
int resolve_self_intersections(Mesh& mesh);

// Unfolds the surface (unfold.h) and resolves its self-intersections in turn, since mending either
// may bring on the other, until it has no folds or a few rounds are over. mesh: a closed
// 2-manifold. Returns what is left.
struct SurfaceFaults {
  int crossings = 0;  // pairs of triangles that pass through each other
  int folds = 0;      // edges that are folded
};
SurfaceFaults mend_surface(Mesh& mesh);

}  // namespace artisketch

// Smooths a surface where it passes through itself.
#pragma once

#include "base/mesh.h"

namespace artisketch {

// Smooths around the places where the surface passes through itself until it no longer does, or
// for a few rounds. Positions come out rounded by position_step: what no longer crosses here does
// not cross in a file either. Returns how many pairs of triangles still cross.
int resolve_self_intersections(Mesh& mesh);

}  // namespace artisketch

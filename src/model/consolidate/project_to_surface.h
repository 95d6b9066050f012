// Projects the vertices of a lattice's surface onto the body's zero set.
#pragma once

#include "base/dual_surface.h"
#include "model/consolidate/body.h"

namespace artisketch {

struct SurfaceProjection {
  Points3 normals;         // #V×3, unit length
  std::vector<int> owner;  // per vertex: the part it lies on, −1: none
  std::vector<char> free;  // per vertex: lies on no part or capsule, but where gaps were closed
};

// Spreads mesh.V (as dual_surface left it on sampled.grid) evenly and moves it onto the body's zero
// set, no further than about a cell.
SurfaceProjection project_to_surface(const Body& body, const Body::Sampled& sampled,
                                     QuadMesh& mesh);

}  // namespace artisketch

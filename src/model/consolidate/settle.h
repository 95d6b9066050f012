// Lays the vertices of a lattice's surface on the body's own.
#pragma once

#include "base/dual_surface.h"
#include "model/consolidate/body.h"

namespace artisketch {

struct Settled {
  Points3 normals;         // #V×3, unit length
  std::vector<int> owner;  // per vertex: the part it lies on, −1: none
  std::vector<char> free;  // per vertex: lies on no part or tube, but where gaps were closed
};

// Spreads mesh.V (as dual_surface left it on sampled.grid) evenly and moves it onto the body's zero
// set, no further than about a cell.
Settled settle(const Body& body, const Body::Sampled& sampled, QuadMesh& mesh);

}  // namespace artisketch

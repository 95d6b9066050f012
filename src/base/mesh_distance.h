// Signed distance to a closed mesh, sampled on a grid.
#pragma once

#include "base/grid.h"
#include "base/mesh.h"

namespace artisketch {

// Fills `field` (whose origin, cell and size say where) with the signed distance to the mesh,
// negative inside: exact (distance to the nearest triangle) within `band` cells of the surface,
// a distance that never falls below `band` cells elsewhere, with the right sign everywhere.
// mesh: closed and oriented.
void mesh_distance(const Mesh& mesh, double band, Grid3<float>& field);

}  // namespace artisketch

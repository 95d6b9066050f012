// The surface of a solid on a lattice, one vertex per cell (surface nets, Gibson 1998).
#pragma once

#include "base/block_grid.h"
#include "base/mesh.h"

namespace artisketch {

using Quads = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;  // #Q×4, as Triangles

struct QuadMesh {
  Points3 V;  // #V×3, each within its cell: the mean of where the cell's edges cross zero
  Quads Q;    // counter-clockwise seen from outside; every edge joins exactly two
};

// grid: any; what isn't stored is outside. Every edge of the result is run through as often one way
// as the other. Where the grid is well-composed (base/well_composed.h), it is a closed, oriented
// 2-manifold; without an inside, it is empty.
QuadMesh dual_surface(const BlockGrid& grid);

// Two triangles per quad, split along the diagonal that bends the surface less.
Triangles split_quads(const Points3& V, const Quads& Q);

// The vertices joined to each by an edge of a quad.
Adjacency quad_adjacency(const QuadMesh& mesh);

}  // namespace artisketch

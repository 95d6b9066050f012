// Solids on a lattice whose surface is a 2-manifold (Latecki 1997, "3D well-composed pictures").
#pragma once

#include <cstddef>
#include <vector>

#include "base/block_grid.h"

namespace artisketch {

// Corners of a lattice cell: bit x + 2 y + 4 z of a mask is set where that corner is inside.
// True where the cell holds inside corners that meet only along an edge or in a point: two
// diagonal ones on a face, or two opposite ones of the cell.
bool is_critical(unsigned corners);

// Makes the solid {value < 0} well-composed by turning outside samples of critical cells inside,
// those nearest to the surface first. Stores the blocks beside inside samples that are missing
// (BlockGrid::close), before and while it turns. Returns those it turned.
struct Turned {
  std::ptrdiff_t sample;  // index into grid.values
  float was;              // its value before
};
std::vector<Turned> make_well_composed(BlockGrid& grid);

}  // namespace artisketch

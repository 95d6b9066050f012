// Blades, brims and needles: what is thinner than the cells of its grid.
#pragma once

#include "model/stages.h"

namespace artisketch {

// Whether a good share of the surface has no sample a cell deep behind it, so that its sampled
// field may fall into islands.
bool is_thin(const Grid3<float>& field);

// The grid that a part as thin as its field says should have: `cells` times up to kMostFiner along
// its longest side, within kMostSamples.
int finer_cells(const Grid3<float>& field, int cells);
inline constexpr double kMostFiner = 3;
inline constexpr double kMostSamples = 1.2e6;

// Whether two closed surfaces are one another's like: of the same genus and, within two cells,
// extent.
bool alike(const Mesh& mesh, const Result<Mesh>& other, double cell);

// Widens a sampled distance to the mesh, where it has lost pieces or won holes, by as
// little as it takes up to one cell and a half, until its zero set is like the mesh again: one
// piece of the same genus and extent.
void hold_together(const Mesh& mesh, Grid3<float>& field);

}  // namespace artisketch

// Ears and horns that a part's outlines show, kept where a guess at its depth would take them.
#pragma once

#include "base/grid.h"
#include "model/surface/carving.h"

namespace artisketch {

// A guess at the depth takes away no more than depth: where it would take, or cut off from the
// body, an ear or a horn that one of the part's own outlines shows, `guess` goes back to `surface`.
// Both are signed distances on one grid, negative inside. Only as far as the outlines agree,
// `agreed` of 0 … 1: where they contradict each other, such a thing may lie anywhere along the ray,
// and the surface has spikes there.
void keep_what_is_shown(const Carving& carving, double agreed, const Grid3<float>& surface,
                        Grid3<float>& guess);

}  // namespace artisketch

// The depth of a part that its views leave open: one drawing, or several from one direction.
#pragma once

#include "model/surface/carving.h"

namespace artisketch {

// Raises `field`, the part's carving without its slab, to a plump body: half as thick at a pixel as
// √u, where Δu is constant inside the outline and u nothing on it, so that a disc becomes a ball
// and a strip a round rod; as thick at its thickest as it is wide there, times `fatness`. Its
// middle plane follows the bones. bones may be empty.
void inflate(const Carving& carving, std::span<const Bone> bones, double fatness,
             Grid3<float>& field);

}  // namespace artisketch

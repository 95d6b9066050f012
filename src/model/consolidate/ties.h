// Parts that touch no other, and the tubes that tie them up.
#pragma once

#include "model/consolidate/body.h"

namespace artisketch {

// piece_of: per part, which piece of the body's surface it lies on, −1 where it shows nowhere.
// Returns tubes along the bones, after which all those pieces are one, and says in `warnings` what
// it tied.
std::vector<Tube> ties(const Document& document, std::span<const PartSurface> parts,
                       const PartTree& tree, std::span<const JointSphere> spheres,
                       std::span<const int> piece_of, double cell,
                       std::vector<std::string>& warnings);

}  // namespace artisketch

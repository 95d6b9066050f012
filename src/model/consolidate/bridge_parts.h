// Joins parts that touch no other to the rest.
#pragma once

#include "model/consolidate/body.h"

namespace artisketch {

// piece_of: per part, which piece of the body's surface it lies on, −1 where it shows nowhere.
// Returns capsules along the bones, after which all those pieces are one, and names in `warnings`
// the parts that it joined.
std::vector<Capsule> bridge_parts(const Document& document, std::span<const PartSurface> parts,
                                  const PartTree& tree, std::span<const JointSphere> spheres,
                                  std::span<const int> piece_of, double cell,
                                  std::vector<std::string>& warnings);

}  // namespace artisketch

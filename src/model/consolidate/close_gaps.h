// Fills what the parts' cuts leave open between them.
#pragma once

#include "model/consolidate/body.h"

namespace artisketch {

// Closes the solid where two parts that meet are both at most `reach` (units) away. Inside the
// spheres it fills gaps too narrow for a ball of that radius; elsewhere only so much that no tunnel
// through such a place is left (a skin one sample thick). It never joins what wasn't joined.
// sampled.grid: well-composed, and stays so. Filled samples get values just below 0.
void close_gaps(Body::Sampled& sampled, const Body& body, double reach,
                std::span<const JointSphere> spheres);

}  // namespace artisketch

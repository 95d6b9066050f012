// Fills what the parts' cuts leave open between them.
#pragma once

#include "model/body.h"

namespace artisketch {

// Closes the solid where parts meet, as far as both are at most `reach` (units) away: gaps too
// narrow for a ball of that radius are filled inside the spheres; outside them only so much is that
// no handle or break narrower than that is left (a skin one sample thick). The result is
// well-composed. Filled samples get values just below 0.
void close_gaps(BlockGrid& grid, std::span<const float> seam, double reach,
                std::span<const JointSphere> spheres);

}  // namespace artisketch

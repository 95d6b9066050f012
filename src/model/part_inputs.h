// What tells whether a part must be made anew while its document is edited.
#pragma once

#include <string>

#include "model/stages.h"

namespace artisketch {

// Everything that a part's surface is made of (contours, poses, cameras, bones, fatness, mirrored
// views, options), byte for byte.
std::string surface_inputs(const Part& part, const SurfaceOptions& options);

}  // namespace artisketch

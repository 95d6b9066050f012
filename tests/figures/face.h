// What the faces of people have in common.
#pragma once

#include <vector>

#include "figures/solid.h"

namespace artisketch::figures {

// A large eye painted on a head that faces +z: `side` is 1 left and -1 right of its middle, `size`
// 1 is 0.14 units high.
std::vector<Blob> painted_eye(const Vec3& centre, int side, double size, unsigned iris,
                              unsigned lash);

}  // namespace artisketch::figures

// Fewer triangles for a picture, in little time.
#pragma once

#include "base/mesh.h"

namespace artisketch {

// The mesh without the triangles that it can spare within `error` (units). Unlike simplified() it
// looks at nothing but the error: thin places may be pinched.
Mesh thinned(const Mesh& mesh, double error);

}  // namespace artisketch

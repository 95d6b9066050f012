// Fewer, more even triangles for a closed mesh.
#pragma once

#include "base/mesh.h"

namespace artisketch {

// Collapses short edges, shortest first, until about `vertices` are left or no edge can go without
// harm: a closed 2-manifold stays one, of the same genus and components, and no face turns over.
// Edges end up alike in length; a vertex moves by less than one of them.
// mesh: a closed 2-manifold. Deterministic; near-linear in its size.
Mesh coarsened(const Mesh& mesh, int vertices);

}  // namespace artisketch

// Fewer triangles where the surface is flat, without a fold.
#pragma once

#include "base/mesh.h"

namespace artisketch {

// Collapses edges, those first that move the surface least (quadric error metric: Garland and
// Heckbert 1997), to the place that is nearest to all planes that a vertex stands for. A collapse
// is refused where it would change the topology, turn a face far, fold the surface more than it was
// folded there, or leave a sliver.
//   mesh       a closed 2-manifold, which it stays, of the same genus and components
//   triangles  to stop at; more are left where every further collapse is refused
//   error      units: root mean square distance from the planes that a vertex may stand off
// Deterministic; near-linear in its size.
Mesh collapsed(const Mesh& mesh, int triangles, double error);

}  // namespace artisketch

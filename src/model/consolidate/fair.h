// Blends the parts into each other inside the joints' spheres (the paper's section 5).
#pragma once

#include "model/consolidate/settle.h"

namespace artisketch {

// Moves the vertices near creases inside the spheres, and the free ones, to where the bi-Laplacian
// is least; a vertex is held to its place the harder the farther it lies from a crease, and all
// others stay. Where two parts run into each other smoothly there is no crease and nothing moves:
// we differ from the paper, which frees everything inside the sphere, and loses silhouette there.
void fair(const Body& body, const Body::Sampled& sampled, std::span<const JointSphere> spheres,
          const Settled& settled, QuadMesh& mesh);

// Smooths around the places where the surface passes through itself until it no longer does, or
// for a few rounds. Positions come out rounded by position_step: what no longer crosses here does
// not cross in a file either. Returns how many pairs of triangles still cross.
int untangle(Mesh& mesh);

}  // namespace artisketch

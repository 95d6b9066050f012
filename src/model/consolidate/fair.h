// Blends the parts into each other inside the joints' spheres (the paper's section 5).
#pragma once

#include "model/consolidate/project_to_surface.h"

namespace artisketch {

// Moves the vertices near creases inside the spheres, and the free ones, to where the bi-Laplacian
// is least; a vertex is held to its place the harder the farther it lies from a crease, and all
// others stay. Where two parts run into each other smoothly there is no crease and nothing moves:
// we differ from the paper, which frees everything inside the sphere, and loses silhouette there.
void fair(const Body& body, const Body::Sampled& sampled, std::span<const JointSphere> spheres,
          const SurfaceProjection& projection, QuadMesh& mesh);

// The same with every vertex in the balls or on them free, as the paper has it: `cell` (units) is
// how far from a ball its own surface may lie on the lattice.
void fair_inside(std::span<const Capsule> balls, double cell, QuadMesh& mesh);

}  // namespace artisketch

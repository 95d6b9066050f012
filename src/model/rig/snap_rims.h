// The rest surface corrected where skinning pulls the posed silhouettes off the drawings.
#pragma once

#include "model/stages.h"

namespace artisketch {

// Moves the vertices that make the posed model's outline in a frame along their normals until it
// meets the outline of what is drawn there, and those round them smoothly with them, in a few
// damped passes; keeps the passes that bring the silhouettes nearer. Same vertices and topology;
// where the surface would fold, edges turn. (The paper asks
// for it in the definition of its output: the silhouettes of the skinned surface, in the calibrated
// poses.)
//   parts    of the calibrated document, for their contours
//   weights  of the mesh's vertices
void snap_rims(const Document& calibrated, std::span<const Part> parts, const Weights& weights,
               Mesh& mesh, Run& run);

}  // namespace artisketch

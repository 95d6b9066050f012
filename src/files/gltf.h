// glTF 2.0 binaries, written and read back through tinygltf (FORMAT.md, "What comes out").
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "model/stages.h"

namespace artisketch {

// Joints are nodes 0 … n − 1 in the document's order, the skinned mesh is node n, beside them in
// the scene. Positions, normals and keys are in single precision; the weights of a vertex sum to
// exactly 1 in it. A rotation's keys take the short way round (q and −q are the same rotation).
// Of a model without joints the mesh stands alone, without skin or clips.
// Fails where the model has nothing to show (no faces), a number is not finite in single precision,
// a clip's times do not increase, or the file would pass 2 GB.
Result<std::string> glb_bytes(const Model& model);

// Reads what glb_bytes writes: one skinned mesh, its joints, clips and texture. Refuses, saying
// why, any other glTF and anything damaged; `name` is used in the error only.
Result<Model> read_glb(std::string_view bytes, const std::string& name);

}  // namespace artisketch

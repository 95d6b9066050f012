// glTF 2.0 binaries, written and read back through tinygltf (FORMAT.md, "What comes out").
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "model/stages.h"

namespace artisketch {

// Fails where the model has nothing to show (no faces) or its numbers are not finite.
Result<std::string> glb_bytes(const Model& model);

// Reads what glb_bytes writes: one skinned mesh, its joints, clips and texture.
Result<Model> read_glb(std::string_view bytes, const std::string& name);

}  // namespace artisketch

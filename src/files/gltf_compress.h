// Smaller glTF: numbers in fewer bits (KHR_mesh_quantization), and what is left of them packed
// (EXT_meshopt_compression). Source of the packing: meshoptimizer's codecs, of the versions that
// the extension names.
#pragma once

#include <string>

#include "files/glb_parts.h"

namespace artisketch {

// A file of glb_bytes or vrm_bytes, the same model in fewer bytes: vertices and triangles in
// another order; positions as they are, in steps of their own; normals to 8 bits a component,
// texture coordinates to 16, weights to 255ths that add up, rotations to 14 bits. Readers need both
// extensions: three.js and Babylon.js have them, Godot does not.
std::string compressed_glb(const std::string& glb);

bool is_compressed(const GlbParts& parts);
// The same file unpacked, for readers that know accessors alone; numbers stay quantized. Throws
// Refused (gltf_data.h), saying why, where what is packed is damaged.
GlbParts decompressed(GlbParts parts);

}  // namespace artisketch

// A binary glTF as its two chunks, for what rewrites one.
#pragma once

#include <string>
#include <string_view>

#include "files/json.h"

namespace artisketch {

struct GlbParts {
  Json json;
  std::string bin;  // buffer 0
};

// Throws Refused (gltf_data.h), saying why, where the bytes are no whole binary glTF of version 2.
GlbParts glb_parts(std::string_view bytes);
std::string glb_of(const GlbParts& parts);

}  // namespace artisketch

// The rest pose's surface alone, for programs that know no skeletons: to print, to sculpt, to
// measure. One closed surface: texture seams are welded.
#pragma once

#include <string>

#include "base/result.h"
#include "model/stages.h"

namespace artisketch {

// Wavefront OBJ: v and f, texts that read back as the same doubles.
std::string obj_text(const Model& model);

// Binary STL: single precision, a facet normal per triangle.
std::string stl_bytes(const Model& model);

// PLY, binary_little_endian: x, y, z in single precision, with red, green, blue where the model has
// a texture; faces as lists of int.
std::string ply_bytes(const Model& model);
// The same of a mesh as it is, plain.
std::string ply_bytes(const Mesh& mesh);

// What the ending of `path` asks for (.glb, .vrm, .obj, .stl, .ply, in any case); empty where none
// does.
std::string model_ending(const std::string& path);
std::string model_endings();  // all of them, in words: ".glb, … or .ply"

// The model in the format of that ending, .vrm apart (vrm.h). Fails as glb_bytes does.
Result<std::string> model_bytes_for(const std::string& ending, const Model& model);

}  // namespace artisketch

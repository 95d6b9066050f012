// tinygltf as we build it: without files and without its own image code, in every translation unit
// alike, because its classes depend on these macros.
#pragma once

#include <fstream>  // tiny_gltf.h 2.7 needs it and forgets it

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

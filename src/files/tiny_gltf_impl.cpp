// Debian's library is built with other macros than ours: see tinygltf_setup.h.
#define TINYGLTF_IMPLEMENTATION
#include "files/tinygltf_setup.h"

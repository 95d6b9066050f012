// Debian's library is built with other macros than ours: see tinygltf_setup.h.
#include <nlohmann/json.hpp>
// The kind of JSON that all else here reads and writes: a second one is a part of the page that
// nobody needs. Fields of an object are looked for one by one in it; gltf_data.cpp refuses objects
// of too many.
#define json ordered_json
#define TINYGLTF_IMPLEMENTATION
#include "files/tinygltf_setup.h"

// What a run left in its trace, as files that other programs show.
#pragma once

#include <string>
#include <vector>

#include "model/run.h"

namespace artisketch {

struct NamedFile {
  std::string name;  // "003 forearm.L hull.nrrd": numbered in the order they were made
  std::string bytes;
};

// Meshes as PLY, curves as lines in OBJ, fields as NRRD (for ParaView, 3D Slicer): float samples,
// little-endian, x fastest, in their place in rest space.
std::vector<NamedFile> trace_files(const Trace& trace);

}  // namespace artisketch

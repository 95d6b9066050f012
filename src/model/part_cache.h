// The surfaces of a document's parts, kept while it is edited.
#pragma once

#include <map>
#include <string>

#include "model/stages.h"

namespace artisketch {

// Everything that a part's surface is made of, byte for byte.
std::string surface_inputs(const Part& part, const SurfaceOptions& options);

class PartCache {
 public:
  // The part's surface: the one kept for its joint where no input has changed since (contours,
  // poses, cameras, bones, fatness, mirrored views, options), else made anew and kept. A run with a
  // trace has it made anew, as the trace shows how. Errors are not kept.
  Result<PartSurface> surface(const Part& part, const SurfaceOptions& options, Run& run);

  int made() const { return made_; }  // surfaces made so far, rather than kept ones
  void clear() { kept_.clear(); }

 private:
  struct Kept {
    std::string inputs;
    PartSurface surface;
  };
  std::map<int, Kept> kept_;  // by joint
  int made_ = 0;
};

}  // namespace artisketch

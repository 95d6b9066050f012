// One part, by the chosen method.
#include "model/stages.h"

namespace artisketch {

Result<PartSurface> reconstruct_part(const Part& part, const SurfaceOptions& options, Run& run) {
  switch (options.method) {
    case Method::paper:
      return surface_paper(part, options, run);
    case Method::rays:
      return surface_rays(part, options, run);
  }
  return surface_paper(part, options, run);
}

}  // namespace artisketch

// One part, by the chosen method.
#include "model/one_order.h"
#include "model/stages.h"

namespace artisketch {

Result<PartSurface> reconstruct_part(const Part& given, const SurfaceOptions& options, Run& run) {
  const Part part = with_views_in_one_order(given);
  switch (options.method) {
    case Method::paper:
      return surface_paper(part, options, run);
    case Method::rays:
      return surface_rays(part, options, run);
  }
  return surface_paper(part, options, run);
}

}  // namespace artisketch

// The visual hull of a part (Laurentini 1994).
#include "model/surface/carving.h"

namespace artisketch {

Result<Grid3<float>> visual_hull(const Part& part, int cells, std::vector<std::string>& warnings,
                                 Run& run) {
  Result<Carving> carving = carving_of(part, cells);
  if (!carving) return carving.error();
  widen_until_they_meet(*carving, warnings);
  return carve(*carving, cells, run);
}

}  // namespace artisketch

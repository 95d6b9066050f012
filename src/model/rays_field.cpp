#include "model/rays_field.h"

#include <algorithm>
#include <optional>

#include "model/inflate.h"

namespace artisketch {

Result<RaysField> rays_field(const Part& part, const RaysFieldOptions& options, Run& run) {
  RaysField out;
  Result<Carving> carving = carving_of(part, {}, options.cells);
  if (!carving) return carving.error();
  widen_until_they_meet(*carving, out.warnings);
  Result<Grid3<float>> hull = carve(*carving, options.cells, run);
  if (!hull) return hull.error();
  out.distance = std::move(*hull);

  if (carving->one_direction()) {
    inflate(*carving, part.bones, part.fatness, out.distance);
    return out;
  }
  const Box3 box = out.distance.box();
  out.rims = outline_rays(*carving, options.rays_per_view);
  for (RayRim& rim : out.rims) choose_depths(*carving, box, rim);
  std::optional<HermiteSurface> f;
  for (int pass = 0; pass <= options.refits; ++pass) {
    if (run.cancelled()) return cancelled();
    if (f)
      for (RayRim& rim : out.rims) detect_depths(*carving, box, *f, rim);
    f.emplace(surface_points(*carving, out.rims), options.surface);
  }
  raise(*f, 3 * out.distance.cell, out.distance);
  for (const RayRim& rim : out.rims) out.rim_frames.push_back(carving->views[rim.view].view->frame);
  return out;
}

}  // namespace artisketch

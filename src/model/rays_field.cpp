#include "model/rays_field.h"

#include <algorithm>

#include "model/agreement.h"
#include "model/inflate.h"
#include "model/mirror.h"

namespace artisketch {

Result<RaysField> rays_field(const Part& part, const RaysFieldOptions& options, Run& run) {
  RaysField out;
  Result<Carving> carving = carving_of(part, agreeing_mirrors(part, options.cells), options.cells);
  if (!carving) return carving.error();
  widen_until_they_meet(*carving, out.warnings);
  swell_until_covered(*carving);
  Result<Grid3<float>> hull = carve(*carving, options.cells, run);
  if (!hull) return hull.error();
  out.distance = std::move(*hull);

  if (carving->one_direction()) {
    inflate(*carving, part.bones, part.fatness, out.distance);
    return out;
  }
  const Box3 box = out.distance.box();
  // A mirrored outline from a direction that another one has already seen adds nothing but the
  // doubt whether both are right.
  std::vector<Vec3> directions;
  for (int v = 0; v < int(carving->views.size()); ++v) {
    const Silhouette& view = carving->views[v];
    const bool seen = std::any_of(directions.begin(), directions.end(),
                                  [&](const Vec3& d) { return same_direction(d, view.direction); });
    if (view.view->mirrored && seen) continue;
    directions.push_back(view.direction);
    for (RayRim& rim : outline_rays(view, options.rays_per_view)) {
      rim.view = v;
      out.rims.push_back(std::move(rim));
    }
  }
  for (RayRim& rim : out.rims) choose_depths(*carving, box, rim);
  // The depths are sought on looser and coarser surfaces, which don't fold to pass through points
  // whose depths are still wrong.
  constexpr double kLooser = 10;
  constexpr int kCoarser = 2;
  HermiteOptions rough = options.surface;
  rough.value_ridge *= kLooser;
  for (int pass = 0; pass < options.refits; ++pass) {
    if (run.cancelled()) return cancelled();
    const HermiteSurface f(surface_points(*carving, out.rims, kCoarser), rough);
    for (RayRim& rim : out.rims) detect_depths(*carving, box, f, rim);
  }
  if (run.cancelled()) return cancelled();
  const HermiteSurface f(surface_points(*carving, out.rims), options.surface);
  raise(f, 3 * out.distance.cell, out.distance);
  for (const RayRim& rim : out.rims) out.rim_frames.push_back(carving->views[rim.view].view->frame);
  return out;
}

}  // namespace artisketch

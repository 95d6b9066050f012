// A part's surface by its contour rays: the default method. Steps in rays_field.
#include <algorithm>
#include <utility>

#include "model/surface/rays_field.h"

namespace artisketch {

// Cells to which the part's distances go down. Non-adjacent parts that lie in each other part where
// both are as deep: deep inside a fat part a thin one would have no say, without any gradient
// neither has.
constexpr float kDeepest = 6;

Result<PartSurface> surface_rays(const Part& part, const SurfaceOptions& options, Run& run) {
  PartSurface out;
  out.joint = part.joint;
  Grid3<float> fine;  // the surface's, where it isn't that of the distances
  if (options.visual_hull) {
    Result<Grid3<float>> hull = visual_hull(part, options.grid, out.warnings, run);
    if (!hull) return hull.error();
    out.distance = std::move(*hull);
    if (options.grid > kSmoothCells) {
      std::vector<std::string> said;
      hull = visual_hull(part, kSmoothCells, said, run);
      if (!hull) return hull.error();
      fine = std::exchange(out.distance, std::move(*hull));
    }
  } else {
    RaysFieldOptions field_options;
    field_options.cells = options.grid;
    Result<RaysField> field = rays_field(part, field_options, run);
    if (!field) return field.error();
    out.distance = std::move(field->distance);
    out.warnings = std::move(field->warnings);
    fine = std::move(field->fine);
  }
  Result<Mesh> mesh = isosurface(fine.empty() ? out.distance : fine);
  if (!mesh) return mesh.error();
  out.mesh = std::move(*mesh);
  const float deepest = -kDeepest * float(out.distance.cell);
  for (float& v : out.distance.values) v = std::max(v, deepest);
  if (run.trace) {
    run.trace->add(part.name + "/distance", out.distance);
    run.trace->add(part.name + "/surface", out.mesh);
  }
  return out;
}

}  // namespace artisketch

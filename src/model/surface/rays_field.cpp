#include "model/surface/rays_field.h"

#include <algorithm>

#include "model/surface/agreement.h"
#include "model/surface/bulge.h"
#include "model/surface/inflate.h"
#include "model/surface/mirror.h"
#include "model/surface/thin_parts.h"

namespace artisketch {
namespace {

Curves curves_of(const std::vector<RayRim>& rims) {
  Curves curves;
  for (const RayRim& rim : rims) {
    curves.emplace_back();
    for (const RimRay& ray : rim.rays) curves.back().push_back(ray.ray.at(ray.depth));
    curves.back().push_back(curves.back().front());
  }
  return curves;
}

// Raises the hull to f, bulging `fatness` times as far between the rims. What would lose its middle
// when thinned that much is thinned less.
void raise_plump(const HermiteSurface& f, const std::vector<RayRim>& rims, double radius,
                 double fatness, Grid3<float>& hull) {
  const double above = 3 * hull.cell;
  const Bulge bulge(curves_of(rims), radius);
  const auto raised = [&](double times) {
    Grid3<float> field = hull;
    const auto rows = [&](const Vec3& start, const Vec3& step, int n, float* values) {
      f.values(start, step, n, values);
      for (int i = 0; i < n && times != 1; ++i)
        values[i] -= float((times - 1) * bulge.height(start + i * step));
    };
    raise(rows, above, field);
    return field;
  };
  Grid3<float> field = raised(fatness);
  // Rims of views that contradict each other may leave next to nothing: the hull is better.
  const auto inside = [](const Grid3<float>& g) {
    return std::count_if(g.values.begin(), g.values.end(), [](float v) { return v < 0; });
  };
  constexpr double kLeast = 0.35;  // share of the hull
  if (fatness >= 1 && double(inside(field)) < kLeast * double(inside(hull))) return;
  if (fatness < 1) {
    const Result<Mesh> plain = isosurface(raised(1));
    for (int tries = 0; plain && tries < 4; ++tries) {
      if (alike(*plain, isosurface(field), hull.cell)) break;
      fatness = (1 + fatness) / 2;
      field = raised(fatness);
    }
  }
  hull = std::move(field);
}

// Views up to which each gives all its rays.
constexpr double kFullViews = 3;

// Indices of the views whose rims are sought. A mirrored outline from a direction that another one
// has already seen adds nothing but the doubt whether both are right.
std::vector<int> views_to_ask(const Carving& carving) {
  std::vector<int> asked;
  const auto seen = [&](const Silhouette& view) {
    return std::any_of(asked.begin(), asked.end(), [&](int other) {
      return same_direction(carving.views[other].direction, view.direction);
    });
  };
  for (int v = 0; v < int(carving.views.size()); ++v) {
    const Silhouette& view = carving.views[v];
    if (!view.bounds_only && !(view.view->mirrored && seen(view))) asked.push_back(v);
  }
  return asked;
}

}  // namespace

Result<RaysField> rays_field(const Part& part, const RaysFieldOptions& options, Run& run) {
  RaysField out;
  Result<Carving> carving = carving_with_mirrors(part, options.cells);
  if (!carving) return carving.error();
  widen_until_they_meet(*carving, out.warnings);
  swell_until_covered(*carving);
  // The rims' surface lies inside the hull: next to that alone must the hull's distances be true.
  const double band = carving->one_direction() ? 4 : 1.5;
  Result<Grid3<float>> hull = carve(*carving, options.cells, run, band);
  if (!hull) return hull.error();
  out.distance = std::move(*hull);

  if (carving->one_direction()) {
    inflate(*carving, part.bones, part.fatness, out.distance);
    return out;
  }
  const Box3 box = out.distance.box();
  const std::vector<int> asked = views_to_ask(*carving);
  // The rims' equations are dense: with many views each gives fewer rays.
  const double most = options.rays_per_cell * options.cells;
  const int rays = int(std::clamp(std::min(most, kFullViews * most / asked.size()), 16.0, 96.0));
  for (const int v : asked)
    for (RayRim& rim : outline_rays(carving->views[v], rays)) {
      rim.view = v;
      out.rims.push_back(std::move(rim));
    }
  for (RayRim& rim : out.rims) choose_depths(*carving, box, rim);
  // The depths are sought on looser and coarser surfaces, which don't fold to pass through points
  // whose depths are still wrong.
  constexpr double kLooser = 40;
  constexpr int kCoarser = 2;
  HermiteOptions fine = options.surface;
  fine.length = carving->radius;
  HermiteOptions rough = fine;
  rough.value_ridge *= kLooser;
  for (int pass = 0; pass < options.refits; ++pass) {
    if (run.cancelled()) return cancelled();
    const HermiteSurface f(surface_points(*carving, out.rims, kCoarser), rough);
    for (RayRim& rim : out.rims) detect_depths(*carving, box, f, rim);
  }
  if (run.cancelled()) return cancelled();
  const HermiteSurface f(surface_points(*carving, out.rims), fine);
  raise_plump(f, out.rims, carving->radius, part.fatness, out.distance);
  for (const RayRim& rim : out.rims) out.rim_frames.push_back(carving->views[rim.view].view->frame);
  return out;
}

}  // namespace artisketch

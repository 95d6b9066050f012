// A part's surface as the paper's sections 3 and 4 tell it: hull, level set, isosurface, rim paths,
// Δ²x = 0. A part drawn from one direction alone has a single rim, which spans no volume: it is
// inflated instead.
#include <algorithm>

#include "base/coarsen.h"
#include "base/mesh_distance.h"
#include "model/stages.h"
#include "model/surface/bulge.h"
#include "model/surface/inflate.h"
#include "model/surface/thin_parts.h"

namespace artisketch {
namespace {

// Δ²x = 0 takes time and memory that grow faster than the mesh; with edges of a hundredth of the
// part's length its solution is smooth beyond need.
constexpr int kMostVertices = 12000;

constexpr double kBand = 3;  // cells within which the part's distances are exact

// A piece of work that takes the given share of the part's.
class Share {
 public:
  Share(Run& run, double from, double to) : run_(run), from_(run.from), to_(run.to) {
    run.from = from_ + (to_ - from_) * from;
    run.to = from_ + (to_ - from_) * to;
  }
  ~Share() {
    run_.from = from_;
    run_.to = to_;
  }
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;

 private:
  Run& run_;
  double from_, to_;
};

Curves curves_of(const Mesh& mesh, std::span<const Rim> rims) {
  Curves curves;
  for (const Rim& rim : rims) {
    curves.emplace_back();
    for (const int v : rim.vertices) curves.back().push_back(mesh.V.row(v).transpose());
    curves.back().push_back(curves.back().front());
  }
  return curves;
}

Result<Carving> carving_of(const Part& part, int cells, std::vector<std::string>& warnings) {
  Result<Carving> carving = artisketch::carving_of(part, cells);
  if (carving) widen_until_they_meet(*carving, warnings);
  return carving;
}

// The hull, on a finer grid where the part is thinner than the cells of the one asked for.
Result<Grid3<float>> hull_of(const Carving& carving, int cells, Run& run) {
  Result<Grid3<float>> hull = carve(carving, cells, run);
  if (!hull || !is_thin(*hull)) return hull;
  const int finer = finer_cells(*hull, cells);
  return finer > cells ? carve(carving, finer, run) : hull;
}

// A closed contour without a rim is one that the surface doesn't reach.
void warn_of_missing_rims(const Part& part, std::span<const Rim> rims,
                          std::vector<std::string>& warnings) {
  for (const PartView& view : part.views) {
    const auto of_view = [&](const Rim& rim) { return rim.frame == view.frame; };
    const auto closed = [](const Polyline& line) { return line.closed; };
    const auto drawn = std::count_if(view.contours.begin(), view.contours.end(), closed);
    const auto found = std::count_if(rims.begin(), rims.end(), of_view);
    if (found < drawn)
      warnings.push_back("'" + part.name + "': its surface doesn't reach " +
                         std::to_string(drawn - found) + " of its " + std::to_string(drawn) +
                         " contours in frame " + std::to_string(view.frame + 1) +
                         ". Check the poses of '" + part.name + "' there");
  }
}

// Bulges `fatness` times as far between the rims. What would fold or fall apart when thinned that
// much is thinned less.
Mesh fattened(const Mesh& mesh, const Curves& rims, double radius, double fatness,
              Grid3<float> field) {
  if (fatness == 1) return mesh;
  const Bulge bulge(rims, radius);
  const Points3 normals = vertex_normals(mesh);
  for (int tries = 0; tries < 4; ++tries, fatness = (1 + fatness) / 2) {
    Mesh fat = mesh;
    for (int v = 0; v < int(mesh.V.rows()); ++v)
      fat.V.row(v) += (fatness - 1) * bulge.height(mesh.V.row(v).transpose()) * normals.row(v);
    mesh_distance(fat, kBand, field);
    if (alike(fat, isosurface(field), field.cell)) return fat;
  }
  return mesh;
}

// Level set, rims and bending: the hull's mesh becomes the part's.
Result<Mesh> refined(const Part& part, const Grid3<float>& hull, double radius,
                     PartSurface& surface, Run& run) {
  LevelSetOptions options;
  if (is_thin(hull)) options.grown = 1;
  Result<Grid3<float>> field = [&] {
    const Share share(run, 0.1, 0.5);
    return level_set(part, hull, options, run);
  }();
  if (!field) return field.error();
  if (run.trace) run.trace->add(part.name + "/level set", *field);

  Result<Mesh> mesh = isosurface(*field);
  if (!mesh) return mesh;
  *mesh = coarsened(*mesh, kMostVertices);
  Result<std::vector<Rim>> rims = [&] {
    const Share share(run, 0.55, 0.7);
    return rim_paths(part, *mesh, run);
  }();
  if (!rims) return rims.error();
  surface.rims = std::move(*rims);
  warn_of_missing_rims(part, surface.rims, surface.warnings);

  const Share share(run, 0.7, 0.95);
  Result<Mesh> reduced = reduce_volume(part, *mesh, surface.rims, {}, run);
  if (!reduced) return reduced;
  const Curves curves = curves_of(*reduced, surface.rims);
  if (run.trace) run.trace->add(part.name + "/rims", curves);
  return fattened(*reduced, curves, radius, part.fatness, hull);
}

}  // namespace

Result<PartSurface> surface_paper(const Part& part, const SurfaceOptions& options, Run& run) {
  PartSurface surface;
  surface.joint = part.joint;

  const Result<Carving> carving = carving_of(part, options.grid, surface.warnings);
  if (!carving) return carving.error();
  Result<Grid3<float>> hull = hull_of(*carving, options.grid, run);
  if (!hull) return hull.error();
  if (run.trace) run.trace->add(part.name + "/hull", *hull);
  run.report(0.1);

  const bool round_it = carving->one_direction() && !options.visual_hull;
  if (round_it) inflate(carving->views[0], part.bones, carving->centre, part.fatness, *hull);
  Result<Mesh> mesh = options.visual_hull || carving->one_direction()
                          ? isosurface(*hull)
                          : refined(part, *hull, carving->radius, surface, run);
  if (!mesh) return mesh.error();

  surface.mesh = std::move(*mesh);
  surface.distance = std::move(*hull);
  mesh_distance(surface.mesh, kBand, surface.distance);
  hold_together(surface.mesh, surface.distance);
  if (run.trace) run.trace->add(part.name + "/surface", surface.mesh);
  run.report(1);
  return surface;
}

}  // namespace artisketch

// A part's surface as the paper's sections 3 and 4 tell it.
#include "base/coarsen.h"
#include "base/mesh_distance.h"
#include "model/stages.h"

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

}  // namespace

Result<PartSurface> surface_paper(const Part& part, const SurfaceOptions& options, Run& run) {
  PartSurface surface;
  surface.joint = part.joint;
  const auto trace = [&](const char* what, const auto& value) {
    if (run.trace) run.trace->add(part.name + "/" + what, value);
  };

  Result<Grid3<float>> hull = visual_hull(part, options.grid, surface.warnings, run);
  if (!hull) return hull.error();
  trace("hull", *hull);
  run.report(0.1);

  Grid3<float> field = *hull;
  if (!options.visual_hull) {
    const Share share(run, 0.1, 0.5);
    Result<Grid3<float>> evolved = level_set(part, *hull, {}, run);
    if (!evolved) return evolved.error();
    trace("level set", *evolved);
    field = std::move(*evolved);
  }

  Result<Mesh> mesh = isosurface(field);
  if (!mesh) return mesh.error();
  if (!options.visual_hull) {
    *mesh = coarsened(*mesh, kMostVertices);
    {
      const Share share(run, 0.55, 0.7);
      Result<std::vector<Rim>> rims = rim_paths(part, *mesh, run);
      if (!rims) return rims.error();
      surface.rims = std::move(*rims);
    }
    const Share share(run, 0.7, 0.95);
    Result<Mesh> reduced = reduce_volume(part, *mesh, surface.rims, {}, run);
    if (!reduced) return reduced.error();
    mesh = std::move(reduced);
    trace("rims", curves_of(*mesh, surface.rims));
  }
  trace("surface", *mesh);

  surface.mesh = std::move(*mesh);
  surface.distance = std::move(field);
  mesh_distance(surface.mesh, kBand, surface.distance);
  run.report(1);
  return surface;
}

}  // namespace artisketch

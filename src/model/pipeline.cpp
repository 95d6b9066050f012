// The whole of it, as the paper's section 1.3 tells it: calibrate the poses, reconstruct every
// part, make them one skin, bind that to the skeleton.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/blocking.h"
#include "base/words.h"
#include "document/place_words.h"
#include "model/calibrate/bends.h"
#include "model/consolidate/consolidated.h"
#include "model/one_order.h"
#include "model/rig/snap_rims.h"
#include "model/specks.h"
#include "model/stage_clock.h"
#include "model/stages.h"
#include "model/surface/carving.h"
#include "model/surface/mirror.h"
#include "model/texture/props.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Closed contours that parts_of left out.
void name_specks(const Document& document, const std::vector<Part>& parts,
                 std::vector<std::string>& warnings) {
  for (const Part& part : parts)
    for (const PartView& view : part.views) {
      const Frame& frame = document.frames[view.frame];
      const std::size_t specks = contours_of(frame, part.joint).size() - view.contours.size();
      if (specks > 0)
        warnings.push_back(frame_words(document, view.frame) + ": " +
                           (specks == 1 ? "a speck" : std::to_string(specks) + " specks") +
                           " of a few pixels beside the outline of '" + part.name +
                           "' can be neither a hole nor a piece of it, and counts for nothing");
    }
}

void name_missed_triangles(int made, int wanted, std::vector<std::string>& warnings) {
  constexpr double kNear = 0.02;
  if (std::abs(made - wanted) <= kNear * wanted) return;
  warnings.push_back("the model has " + counted(made, "triangle") + ", not " +
                     std::to_string(wanted) +
                     (made > wanted ? ": with fewer its surface would fold"
                                    : ": its surface has no more to show"));
}

// Drawings that say nothing yet, since nobody has posed them.
void name_unposed(const Document& document, std::vector<std::string>& warnings) {
  for (int f = 0; f < int(document.frames.size()); ++f)
    if (!is_posed(document, f) && !document.frames[f].contours.empty())
      warnings.push_back(
          frame_words(document, f) +
          " isn't posed yet: neither its outlines nor its colours are used. Pose its "
          "skeleton, or let a pose be suggested");
}

// Says where drawings leave the depth to guess though there are several.
void warn_of_one_side(const Document& document, const std::vector<Part>& parts,
                      std::vector<std::string>& warnings) {
  constexpr double kLittle = 0.25;  // sin² of 30°
  const auto drawn = std::count_if(document.frames.begin(), document.frames.end(),
                                   [](const Frame& f) { return !f.contours.empty(); });
  const auto guessed = std::count_if(
      parts.begin(), parts.end(), [](const Part& part) { return widest_spread(part) < kLittle; });
  if (drawn > 1 && 2 * guessed > std::ptrdiff_t(parts.size()))
    warnings.push_back(
        "the drawings show most parts from nearly the same side, or its opposite: how deep those "
        "are is a guess. A drawing from another side would tell");
}

// The drawings as large as they are painted from, where they may be already, empty where nobody has
// posed them and without what is no part of the character. Kept in `made` where they differ from
// those given.
//   drawn  the document so large, with all its contours
std::span<const Image> worked_on(const Document& drawn, std::span<const Image> drawings,
                                 double scale, std::vector<Image>& made) {
  const auto is_ready = [&](std::size_t f) {
    return drawings[f].empty() || (drawings[f].width == drawn.frames[f].width &&
                                   drawings[f].height == drawn.frames[f].height);
  };
  const auto is_apart = [&](const Contour& contour) {
    return role_of(drawn, contour.joint) == Role::apart;
  };
  const std::size_t count = std::min(drawings.size(), drawn.frames.size());
  bool as_given = true;
  for (std::size_t f = 0; f < count; ++f) {
    const std::vector<Contour>& contours = drawn.frames[f].contours;
    as_given = as_given && is_posed(drawn, int(f)) && is_ready(f) &&
               std::none_of(contours.begin(), contours.end(), is_apart);
  }
  if (as_given) return drawings;
  for (std::size_t f = 0; f < count; ++f) {
    made.push_back(!is_posed(drawn, int(f)) ? Image()
                   : is_ready(f)            ? drawings[f]
                                            : scaled(drawings[f], scale));
    Image without = without_things_apart(drawn, int(f), made.back());
    if (!without.empty()) made.back() = std::move(without);
  }
  return made;
}

// Of a texture's texels, the share that the surface shows: the rest lies between its charts.
double share_of_texels_shown(const Model& model) {
  double area = 0;
  const Triangles& F = model.mesh.F;
  for (Eigen::Index f = 0; f < F.rows() && model.texture; ++f) {
    const Vec2 &a = model.texcoords[F(f, 0)], &b = model.texcoords[F(f, 1)],
               &c = model.texcoords[F(f, 2)];
    area += std::abs(cross(b - a, c - a)) / 2;
  }
  return area;
}

}  // namespace

Method method_named(const std::string& name, Method otherwise) {
  for (std::size_t m = 0; m < std::size(kMethodNames); ++m)
    if (name == kMethodNames[m]) return Method(m);
  return otherwise;
}

PipelineOptions with_settings(PipelineOptions options, const DocumentSettings& settings) {
  options.method = method_named(settings.method.value_or(""), options.method);
  options.grid = settings.grid.value_or(options.grid);
  options.triangles = settings.triangles.value_or(options.triangles);
  options.mirror = settings.mirror.value_or(options.mirror);
  options.texture = settings.texture.value_or(options.texture);
  return options;
}

namespace {

// The model's colours, where there are drawings.
//   posed  the document with what shapes the model
Result<Done> paint(const Document& posed, std::span<const Image> drawings, StageClock& stages,
                   Reconstruction& out, Run& run) {
  if (std::all_of(drawings.begin(), drawings.end(), [](const Image& d) { return d.empty(); }))
    return Done();
  stages.start("texture", 0.95, 0.97);
  // A large drawing's colours are as fine as the texture can keep them.
  const double scale = working_scale(posed);
  std::vector<Image> made;
  Result<Model> painted = textured(scaled(posed, scale),
                                   worked_on(scaled(out.calibrated, scale), drawings, scale, made),
                                   out.model, run, &out.coloured);
  if (!painted) return painted.error();
  Model& model = out.model;
  model = std::move(*painted);
  const double texels = model.texture ? double(model.texture->width) * model.texture->height : 0;
  stages.finish({{"texels", texels},
                 {"share of texels shown", share_of_texels_shown(model)},
                 {"vertices", double(model.mesh.V.rows())}});
  return Done();
}

// Of a document whose joints are in one order.
Result<Reconstruction> reconstruct_ordered(const Document& document, const PipelineOptions& options,
                                           Run& run) {
  Reconstruction out;
  StageClock stages(run, out.stages);
  out.calibrated = document;
  if (options.calibrate) {
    stages.start("calibrate", 0, 0.3);
    Result<Calibration> calibration = calibrate(document, {options.method}, run);
    if (!calibration) return calibration.error();
    out.calibrated = with_poses(document, *calibration);
    append(out.warnings, calibration->warnings);
    stages.finish(
        {{"frames", double(document.frames.size())}, {"iterations", calibration->iterations}});
    out.calibration = std::move(*calibration);
  }

  stages.start("surfaces", 0.3, 0.8);
  name_unposed(document, out.warnings);
  const Document shaping = with_shaping_contours(out.calibrated);
  const Document posed = without_specks(shaping);
  const Document drawn = scaled(posed, shape_scale(posed));
  std::vector<Part> parts = parts_of(drawn);
  name_specks(shaping, parts, out.warnings);
  warn_of_one_side(posed, parts, out.warnings);
  for (const Bend& bend : bends_of(parts)) out.warnings.push_back(bend_words(posed, bend));
  if (options.mirror) add_mirrored_views(drawn, parts);
  double cells = 0, part_vertices = 0;
  for (Result<PartSurface>& surface :
       reconstruct_parts(parts, {options.method, options.grid, options.visual_hull}, run)) {
    if (!surface) return surface.error();
    append(out.warnings, surface->warnings);
    cells += double(surface->distance.values.size());
    part_vertices += double(surface->mesh.V.rows());
    out.parts.push_back(std::move(*surface));
  }
  stages.finish({{"parts", double(parts.size())}, {"cells", cells}, {"vertices", part_vertices}});

  stages.start("one skin", 0.8, 0.9);
  const bool by_paper = options.method == Method::paper;
  Result<Mesh> mesh = (by_paper ? consolidated_by_paper : consolidate)(
      drawn, out.parts, {!options.visual_hull, options.triangles}, out.warnings, run);
  if (!mesh) return mesh.error();
  if (run.trace) run.trace->add("skin", *mesh);
  const bool as_few_as_show = options.triangles == 0;
  *mesh =
      simplified(*mesh, options.triangles,
                 as_few_as_show ? pixel_size(drawn) / 2 : std::numeric_limits<double>::infinity());
  if (!as_few_as_show) name_missed_triangles(int(mesh->F.rows()), options.triangles, out.warnings);
  stages.finish({{"vertices", double(mesh->V.rows())}, {"triangles", double(mesh->F.rows())}});
  if (run.trace) run.trace->add("skin simplified", *mesh);

  stages.start("weights", 0.9, 0.95);
  Result<Weights> weights = skin(posed, out.parts, *mesh, run);
  if (!weights) return weights.error();
  stages.finish({{"unknowns", double(mesh->V.rows())}});

  if (!options.visual_hull && !by_paper) {  // the paper's part surfaces have their rims
    stages.start("rims", 0.95, 0.96);
    snap_rims(drawn, parts, *weights, *mesh, run);
    stages.finish({});
  }

  out.model = {
      document.name,           document.skeleton, std::move(*mesh), std::move(*weights), {}, {},
      clips_of(out.calibrated)};
  if (options.texture)
    if (const Result<Done> painted = paint(posed, options.drawings, stages, out, run); !painted)
      return painted.error();

  stages.start("fit", 0.97, 1);
  out.fits = measure_fit(posed, out.model, out.parts, run.threads);
  stages.finish({});
  run.report(1);
  return out;
}

}  // namespace

Result<Reconstruction> reconstruct(const Document& document, const PipelineOptions& options,
                                   Run& run) {
  fix_blocking();
  const std::vector<int> order = joints_in_one_order(document.skeleton);
  Result<Reconstruction> made = reconstruct_ordered(with_joints_in(document, order), options, run);
  if (!made) return made.error();
  return with_joints_in(std::move(*made), inverse(order));
}

}  // namespace artisketch

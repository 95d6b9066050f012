#include "app/job.h"

#include <algorithm>
#include <new>

#include "files/document_check.h"
#include "files/document_file.h"
#include "files/gltf.h"
#include "files/image_file.h"
#include "files/report_file.h"
#include "model/consolidate/thinned.h"
#include "model/stage_clock.h"

namespace artisketch {
namespace {

constexpr const char* kFaultsCallIt = "document";
constexpr double kThinningError = 0.1;  // of a cell: far less than the grid's own

// The document without drawings that stand in files: a job sees none.
Document drawings_inside(Document document) {
  for (Frame& frame : document.frames)
    if (frame.image.rfind("data:", 0) != 0) frame.image.clear();
  return document;
}

Result<JobResult> run_reconstruction(const Document& document, const JobRequest& request,
                                     Run& run) {
  PipelineOptions options = request.options;
  std::vector<std::string> missing;
  std::vector<Image> drawings;
  if (options.texture) drawings = load_drawings(drawings_inside(document), "", missing);
  options.drawings = drawings;
  Result<Reconstruction> made = reconstruct(document, options, run);
  if (!made) return made.error();
  Result<std::string> glb = glb_bytes(made->model);
  if (!glb) return glb.error();
  JobResult out;
  out.document = document_text(made->calibrated);
  out.glb = std::move(*glb);
  out.report = report_text(document, *made);
  if (!request.options.visual_hull) out.spheres = joint_spheres(made->calibrated, made->parts);
  if (made->calibration) {
    out.coverage = std::move(made->calibration->coverage);
    out.undetermined = std::move(made->calibration->undetermined);
  }
  out.fits = std::move(made->fits);
  out.warnings = std::move(made->warnings);
  out.warnings.insert(out.warnings.end(), missing.begin(), missing.end());
  return out;
}

Result<JobResult> run_calibration(const Document& document, const JobRequest& request, Run& run) {
  std::vector<StageTime> stages;
  StageClock clock(run, stages);
  clock.start("calibrate", 0, 1);
  Result<Calibration> found = calibrate(document, {request.options.method}, run);
  if (!found) return found.error();
  clock.finish({});
  JobResult out;
  out.document = document_text(with_poses(document, *found));
  out.report = report_text(document, *found, stages[0]);
  out.coverage = std::move(found->coverage);
  out.undetermined = std::move(found->undetermined);
  out.warnings = std::move(found->warnings);
  return out;
}

// What a part fails by becomes a warning.
Result<JobResult> run_parts(const JobRequest& request, Run& run) {
  const PipelineOptions& options = request.options;
  JobResult out;
  std::vector<Result<PartSurface>> surfaces =
      reconstruct_parts(request.parts, {options.method, options.grid, options.visual_hull}, run);
  if (run.cancelled()) return cancelled();
  for (std::size_t p = 0; p < surfaces.size(); ++p) {
    const Part& part = request.parts[p];
    PartMesh made;
    made.joint = part.joint;
    if (const Result<PartSurface>& surface = surfaces[p]) {
      made.mesh = thinned(surface->mesh, kThinningError * surface->distance.cell);
      made.distances = view_distances(part, made.mesh);
      for (const PartView& view : part.views) made.frames.push_back(view.frame);
    } else {
      const std::vector<std::string>& faults = surface.error().faults;
      out.warnings.insert(out.warnings.end(), faults.begin(), faults.end());
    }
    out.parts.push_back(std::move(made));
  }
  return out;
}

// As a reconstruction finds them. A part that fails joins nothing.
Result<JobResult> run_spheres(const Document& document, const JobRequest& request, Run& run) {
  const PipelineOptions& options = request.options;
  std::vector<PartSurface> surfaces;
  for (Result<PartSurface>& surface :
       reconstruct_parts(parts_of(with_shaping_contours(document)),
                         {options.method, options.grid, options.visual_hull}, run))
    if (surface) surfaces.push_back(std::move(*surface));
  if (run.cancelled()) return cancelled();
  JobResult out;
  out.spheres = joint_spheres(document, surfaces);
  return out;
}

Result<JobResult> run_sprites(const JobRequest& request, Run& run) {
  run.now.stage = "drawing sprites";
  const Result<Model> model = read_glb(request.glb, "the model");
  if (!model) return model.error();
  Result<std::string> archive = sprite_zip(*model, request.sprites, request.name, &run);
  if (!archive) return archive.error();
  JobResult out;
  out.sprites = std::move(*archive);
  return out;
}

Result<JobResult> run_unguarded(const JobRequest& request, Run& run) {
  if (request.kind == JobRequest::Kind::parts) return run_parts(request, run);
  if (request.kind == JobRequest::Kind::sprites) return run_sprites(request, run);
  const Result<Document> document = parse_document(request.document, kFaultsCallIt);
  if (!document) return document.error();
  if (request.kind == JobRequest::Kind::spheres) return run_spheres(*document, request, run);
  if (const Result<Done> sound = check_document(*document, kFaultsCallIt); !sound)
    return sound.error();
  return request.kind == JobRequest::Kind::calibrate ? run_calibration(*document, request, run)
                                                     : run_reconstruction(*document, request, run);
}

}  // namespace

Error out_of_memory(std::optional<int> grid) {
  std::string fault = "there is not enough memory";
  if (grid) fault += " for a grid of " + std::to_string(*grid);
  if (grid && *grid > 32)
    fault += "; try " + std::to_string(std::max(32, *grid * 2 / 3));
  else
    fault += "; try smaller drawings, or end other programs";
  return {Error::Kind::out_of_memory, {std::move(fault)}};
}

Error broke_off(const std::string& why) {
  return {Error::Kind::crashed, {"the computation broke off: " + why}};
}

Result<JobResult> run_job(const JobRequest& request, Run& run) {
  try {
    return run_unguarded(request, run);
  } catch (const std::bad_alloc&) {
    return out_of_memory(request.options.grid);
  } catch (const std::exception& thrown) {
    return broke_off(thrown.what());
  }
}

}  // namespace artisketch

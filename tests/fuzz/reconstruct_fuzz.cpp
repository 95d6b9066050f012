// Every document that can be read ends in a closed, bound mesh or in an error with words,
// whatever its strokes look like. Units are as small as they may be, since many documents say more
// than large ones: the stages in their order on a coarse lattice; one in 64 goes the whole way as
// people's do, at a hundred times the time.
#include <cstdint>
#include <cstdlib>

#include <fuzzer/FuzzedDataProvider.h>

#include "files/document_file.h"
#include "files/gltf.h"
#include "fuzz/random_document.h"
#include "model/consolidate/consolidated.h"
#include "model/rig/snap_rims.h"
#include "model/surface/mirror.h"

using namespace artisketch;

namespace {

constexpr fuzz::Most kFew{2, 2, 3, 8};
constexpr int kGrid = 16, kTriangles = 200, kVertices = 400;

template <class T>
void must_have_words(const Result<T>& failed) {
  if (failed.error().faults.empty()) std::abort();
}

void must_be_a_model(const Model& model) {
  if (!topology(model.mesh).closed() || !glb_bytes(model)) std::abort();
}

void the_whole_way(const Document& document, Method method) {
  PipelineOptions options;
  options.method = method;
  options.grid = kGrid;
  options.triangles = kTriangles;
  Run run;
  const Result<Reconstruction> result = reconstruct(document, options, run);
  if (!result) return must_have_words(result);
  must_be_a_model(result->model);
}

void stage_by_stage(Document document, Method method, bool calibrated) {
  Run run;
  if (calibrated) {
    const Result<Calibration> found = calibrate(document, {Method::rays}, run);
    if (!found) return must_have_words(found);
    document = with_poses(document, *found);
  }
  std::vector<Part> parts = parts_of(document);
  add_mirrored_views(document, parts);
  std::vector<PartSurface> surfaces;
  for (const Part& part : parts) {
    Result<PartSurface> surface = reconstruct_part(part, {method, kGrid, false}, run);
    if (!surface) return must_have_words(surface);
    if (!topology(surface->mesh).closed()) std::abort();
    surfaces.push_back(std::move(*surface));
  }
  std::vector<std::string> warnings;
  const Result<Mesh> skin_mesh =
      consolidated(document, surfaces, {true, kTriangles}, kVertices, warnings, run);
  if (!skin_mesh) return must_have_words(skin_mesh);
  Mesh mesh = simplified(*skin_mesh, kTriangles, 1e9);
  const Result<Weights> weights = skin(document, surfaces, mesh, run);
  if (!weights) return must_have_words(weights);
  snap_rims(document, parts, *weights, mesh, run);
  const Model model{document.name, document.skeleton, mesh, *weights, {}, {}, clips_of(document)};
  must_be_a_model(model);
  (void)measure_fit(document, model, surfaces);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kEnough = 400;  // bytes that the largest document takes
  if (size > kEnough) return 0;
  FuzzedDataProvider bytes(data, size);
  const int way = bytes.ConsumeIntegralInRange(0, 63);
  const Result<Document> document =
      parse_document(document_text(fuzz::document_from(bytes, kFew)), "fuzz");
  if (!document) return 0;
  const Method method = bytes.ConsumeIntegralInRange(0, 31) ? Method::rays : Method::paper;
  if (way == 1)
    the_whole_way(*document, method);
  else
    stage_by_stage(*document, method, way == 2 || way == 3);
  return 0;
}

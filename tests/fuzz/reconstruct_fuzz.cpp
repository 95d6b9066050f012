// Every document that passes its checks ends in a closed, bound mesh or in an error with words,
// whatever its strokes look like.
#include <cstdint>
#include <cstdlib>

#include <fuzzer/FuzzedDataProvider.h>

#include "files/document_file.h"
#include "files/gltf.h"
#include "fuzz/random_document.h"
#include "model/stages.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  PipelineOptions options;
  options.method = bytes.ConsumeBool() ? Method::paper : Method::rays;
  options.calibrate = bytes.ConsumeBool();
  options.grid = 16;
  options.triangles = 500;  // more would take the time of many documents
  const Result<Document> document =
      parse_document(document_text(fuzz::document_from(bytes)), "fuzz");
  if (!document) return 0;
  Run run;
  const Result<Reconstruction> result = reconstruct(*document, options, run);
  if (!result) {
    if (result.error().faults.empty()) std::abort();
    return 0;
  }
  if (!topology(result->model.mesh).closed() || !glb_bytes(result->model)) std::abort();
  return 0;
}

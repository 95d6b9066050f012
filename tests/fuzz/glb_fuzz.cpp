// Any bytes at all are a model of ours or are refused in words, and a model that was read can be
// written.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/gltf.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Result<Model> model = read_glb({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!model) {
    if (model.error().faults.empty()) std::abort();
    return 0;
  }
  const Result<std::string> again = glb_bytes(*model);
  if (!again && again.error().faults.empty()) std::abort();
  return 0;
}

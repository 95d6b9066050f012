// Any bytes at all are a model of ours or are refused in words, and a model that was read can be
// written; the same as motions, which can be put on a skeleton.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "document/templates.h"
#include "files/gltf.h"
#include "files/motion_file.h"
#include "model/rig/retarget.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto motions = parse_glb_motions(bytes, "fuzz", "fuzz.glb")) {
    Document document;
    document.skeleton = template_skeleton(Template::human);
    for (const Motion& motion : *motions)
      if (motion.poses.size() < 100) (void)retargeted(document, motion, {});
  } else if (motions.error().faults.empty()) {
    std::abort();
  }
  const Result<Model> model = read_glb(bytes, "fuzz");
  if (!model) {
    if (model.error().faults.empty()) std::abort();
    return 0;
  }
  const Result<std::string> again = glb_bytes(*model);
  if (!again && again.error().faults.empty()) std::abort();
  return 0;
}

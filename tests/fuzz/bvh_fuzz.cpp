// Any text at all is a motion of finite poses, or is refused in words.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/bvh_file.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<Motion> motion = parse_bvh(text, "fuzz", "fuzz.bvh");
  if (!motion) {
    if (motion.error().faults.empty()) std::abort();
    return 0;
  }
  if (motion->skeleton.size() < 1) std::abort();
  for (const Joint& joint : motion->skeleton.joints)
    if (!joint.offset.allFinite()) std::abort();
  return 0;
}

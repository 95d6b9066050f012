#include "model/stages.h"
namespace artisketch {
Result<Weights> skin(const Document&, std::span<const PartSurface>, const Mesh&, Run&) {
  return bad_input("not yet");
}
}  // namespace artisketch

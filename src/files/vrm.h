// VRM 1.0 (.vrm): glTF with what an avatar is asked for. Source: the VRM consortium's
// VRMC_vrm-1.0 and VRMC_springBone-1.0.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "document/document.h"
#include "model/stages.h"

namespace artisketch {

// Who made it, and what others may do with it; VRM wants it of every file.
struct VrmMeta {
  std::string name;
  std::vector<std::string> authors;  // one or more
  std::string license = "https://vrm.dev/licenses/1.0/";
  // Fields of VRM's own meta besides, as a JSON object: "commercialUsage" and so on; or empty.
  std::string more;
};

// The document's `about` (FORMAT.md). Fails, saying what to write there, where it names no authors
// or where a field is of the wrong kind.
Result<VrmMeta> vrm_meta(const Document& document, const std::string& file);

// The document with these words as its `about`'s only author; what else stands there stays.
Document with_author(Document document, const std::string& author);

// The model of a person at rest in the T-pose, its joints named and completed as with_rig's "unity"
// does, facing +z:
//   - the humanoid's bones by these names; first person shows all but what hangs on the head;
//   - a spring for every chain below joints named hair, skirt, tail or ear, two joints or more.
// Clips stay, as glTF's animations. Fails as with_rig and glb_bytes do.
Result<std::string> vrm_bytes(const Model& model, const VrmMeta& meta);

}  // namespace artisketch

// One skin, as fine as asked for.
#pragma once

#include "model/stages.h"

namespace artisketch {

// As consolidate, by a lattice whose surface has about so many vertices, up to three times as many
// where parts are thin. consolidate() takes as many as look smooth; fewer are for trying very many
// documents.
Result<Mesh> consolidated(const Document& document, std::span<const PartSurface> parts,
                          const ConsolidateOptions& options, int vertices,
                          std::vector<std::string>& warnings, Run& run);

}  // namespace artisketch

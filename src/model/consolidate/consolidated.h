// One skin, as fine as asked for.
#pragma once

#include "model/stages.h"

namespace artisketch {

// What becomes of the joints' spheres.
//   closing  gaps in them are closed as far as a smaller ball can't enter, and creases blended; a
//            ball as thick as the limb is united with the parts where the document has the sphere
//            otherwise than it comes by itself
//   united   with the parts, and all vertices in them freed: the paper's section 5
enum class SphereUse { closing, united };

// As consolidate, by a lattice whose surface has about so many vertices, up to three times as many
// where parts are thin. consolidate() takes as many as look smooth; fewer are for trying very many
// documents.
Result<Mesh> consolidated(const Document& document, std::span<const PartSurface> parts,
                          const ConsolidateOptions& options, int vertices,
                          std::vector<std::string>& warnings, Run& run,
                          SphereUse use = SphereUse::closing);

// As the paper has it.
Result<Mesh> consolidated_by_paper(const Document& document, std::span<const PartSurface> parts,
                                   const ConsolidateOptions& options,
                                   std::vector<std::string>& warnings, Run& run);

}  // namespace artisketch

// A joint's mirror image as further views of its part: the other joint's contours, reflected.
#pragma once

#include <vector>

#include "model/surface/carving.h"

namespace artisketch {

// Fills each part's `mirrors` with the contours of its joint's mirror image, reflected in the rest
// pose's plane x = x(root). A joint that is its own image gives its part its own contours from the
// other side. Candidates only: carving_with_mirrors tells whether a part can
// use them.
void add_mirrored_views(const Document& document, std::vector<Part>& parts);

// The part's own outlines and its mirrored ones, all of these or none: only where they say nothing
// that the part's own contours deny.
// - The same on both sides: all are covered by the part's own hull and by all the rest, and cost
//   the own contours no coverage. They bound the part and have rims on it.
// - Alike, as limbs in poses not quite right or a head with its hair to one side: most of their
//   rays are covered by the part's own hull, and swollen where the own contours ask it they cost
//   these no coverage. They bound the part only.
// None where the own views share one direction: they would deny nothing. Fails as carving_of does.
Result<Carving> carving_with_mirrors(const Part& part, int cells);

}  // namespace artisketch

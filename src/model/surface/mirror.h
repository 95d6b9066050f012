// A joint's mirror image as further views of its part: the other joint's contours, reflected.
#pragma once

#include <vector>

#include "model/surface/carving.h"

namespace artisketch {

// Fills each part's `mirrors` with the contours of its joint's mirror image, reflected in the rest
// pose's plane x = x(root). A joint that is its own image gives its part its own contours from the
// other side.
void add_mirrored_views(const Document& document, std::vector<Part>& parts);

// The part's own outlines and its mirrored ones, which take nothing that the own ones show: where
// these ask it, mirrored outlines are swollen, and grown until they give way. They bound the part
// everywhere, and tell where its rims are the less, the more they differ from the own ones: without
// a switch.
//   contradiction  by how much the part's own outlines contradict each other (proportions.h): what
//                  a hand draws is never quite alike
// Fails as carving_of does.
Result<Carving> carving_with_mirrors(const Part& part, double contradiction, int cells);

}  // namespace artisketch

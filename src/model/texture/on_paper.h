// Drawings as they look on paper: what a marker's layer at 40 % shows is pale, and no hole.
#pragma once

#include <span>
#include <vector>

#include "base/image.h"

namespace artisketch {

// Whether parts of the picture are half transparent: not only what fades at the edges of a figure
// that is cut out.
bool half_transparent(const Image& picture);

// The picture with what is half transparent laid on white, opaque. Edges that fade (beside what is
// less than half as opaque) and what is next to nothing (below 10 %) stay as they are.
Image on_paper(const Image& picture);

// All of them so; none where no picture is half transparent, and they may be used as they are.
std::vector<Image> laid_on_paper(std::span<const Image> pictures);

}  // namespace artisketch

// Pictures in few colours, as pixel artists make them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace artisketch {

using Rgb = std::uint32_t;  // 0xRRGGBB

// The colours that an image is of, the commonest first, opaque pixels alone: those that it really
// has, without what lies near one of them already (mixtures along edges), 48 at most.
std::vector<Rgb> palette_of(const Image& image);

// A picture drawn `fine` times too large along each side, in pixels again: each in the colour of
// the palette that most of it is nearest to, or clear where most of it is; without a palette their
// mean. Then every pixel is drawn as `scale` by `scale` of them.
Image in_pixels(const Image& drawn, int fine, int scale, const std::vector<Rgb>& palette);

// The same for what are no colours: means, clear where most is.
Image in_pixels(const Image& drawn, int fine, int scale);

}  // namespace artisketch

// Several figures on one sheet, taken apart.
#pragma once

#include <vector>

#include "document/region_outline.h"

namespace artisketch {

// A rectangle of an image, in pixels.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

// One figure: what of the sheet is its own, and the drawing that it becomes, which may reach
// beyond.
struct Sprite {
  PixelBox own, drawing;
  int column = 0, row = 0;
};

// The figures between which paper runs right across the sheet: rows from the top, each from the
// left; specks are left out. All drawings are of one size, with a little room about the largest
// figure; each stands in the middle of its drawing and as high as it does in its row. None where
// there are no several figures of about one size.
std::vector<Sprite> sprites_by_gaps(const SegmentedImage& sheet);

// Equal cells; what doesn't fill one at the right and the bottom is left out. None where a cell
// would have no pixel.
std::vector<Sprite> sprites_by_grid(int width, int height, int columns, int rows);

// A sprite's drawing; around what is its own it has the colour of the sheet's corner.
Image cut_out(const Image& sheet, const Sprite& sprite);

}  // namespace artisketch

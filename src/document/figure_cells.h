// A drawing's figure in cells, squares of pixels, and a walk in it that tells whose each cell is.
#pragma once

#include <cstdint>
#include <vector>

#include "document/region_outline.h"

namespace artisketch {

using Flags = std::vector<std::uint8_t>;  // 0 or 1

struct Cells {
  int size = 1;  // of the image's pixels, along a cell
  int width = 0, height = 0;
  Flags figure;                             // half of the cell and more isn't paper
  std::vector<SegmentedImage::Tone> tones;  // means of what isn't paper
  int count() const { return width * height; }
  // Of a place in cells; −1 beyond the picture.
  int at(const Vec2& p) const {
    if (!(p.x() >= 0 && p.y() >= 0 && p.x() < width && p.y() < height)) return -1;
    return int(p.y()) * width + int(p.x());
  }
  Vec2 middle(int cell) const { return {cell % width + 0.5, cell / width + 0.5}; }
};

// By cell and label.
struct Shares {
  int labels = 0;
  std::vector<float> values;
  Shares(int cells, int labels) : labels(labels), values(std::size_t(cells) * labels, 0) {}
  float& at(int cell, int label) { return values[std::size_t(cell) * labels + label]; }
  float at(int cell, int label) const { return values[std::size_t(cell) * labels + label]; }
  int largest(int cell) const;  // −1: none above 0
};

// So many that the figure's longer side has at least 160, where it has as many pixels. None where
// all is paper.
Cells cells_of(const SegmentedImage& image);

// Calls f for the four neighbours.
template <class F>
void beside(const Cells& cells, int c, const F& f) {
  const int x = c % cells.width, y = c / cells.width;
  if (x > 0) f(c - 1);
  if (x + 1 < cells.width) f(c + 1);
  if (y > 0) f(c - cells.width);
  if (y + 1 < cells.height) f(c + cells.width);
}

// Cells from the nearest that isn't chosen, or from the picture's rim; diagonal steps are longer.
std::vector<float> inset(const Cells& cells, const Flags& chosen);

// By cell and label, how likely a random walk in the figure from there meets that label's seeds
// first, where steps across an edge of colour are unlikely; zeros where it meets none.
//   seeds  by cell a label, −1: none
//   pulls  by cell and label, the weight with which a cell is that label's anyhow; a step within
//          one colour weighs 1
// Source: Grady 2006, "Random walks for image segmentation"; pulls are the priors of Grady 2005,
// "Multilabel random walker image segmentation using prior models".
Shares meetings(const Cells& cells, const std::vector<int>& seeds, const Shares& pulls);

}  // namespace artisketch

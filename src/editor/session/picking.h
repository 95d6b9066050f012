// Boxes picked on a picture: the figures of a sheet, or what a drawing is cropped to.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "document/sprite_sheet.h"

namespace artisketch {

struct PickedBox {
  Sprite sprite;
  bool taken = true;
};

struct Picking {
  std::string title, words, action;
  std::string picture;  // key into the drawings
  int width = 0, height = 0;
  bool one = false;  // a box at most: drawing another replaces it
  std::vector<PickedBox> boxes;
  std::string grid, as_found;  // "4 × 2", being typed, and as it was; `one` has none
  std::function<void(const std::vector<Sprite>&)> with;  // those taken
  std::function<void()> whole;                           // in place of it; may be empty
  // The box under the hand, in the picture's pixels.
  bool drawing = false;
  PixelBox begun;

  std::vector<Sprite> taken() const;
  // Columns × rows of one size, as `grid` says; false where that is none.
  bool cut_by_grid();
  // One more, or the only one. Nothing of less than two pixels; what reaches beyond is cut.
  void add(PixelBox box);
};

// "2": the second of a row; of several rows "B2".
std::string cell_words(const Sprite& sprite, const std::vector<Sprite>& all);

}  // namespace artisketch

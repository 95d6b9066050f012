// What is small in a drawing and stands out from what lies round it: an eye, a buckle, a letter.
#pragma once

#include <vector>

#include "model/texture/drawn_surface.h"

namespace artisketch {

struct DrawnDetail {
  std::vector<std::size_t> pixels;  // of the sketch
  int joint = 0;                    // that holds most of them
  Vec2 middle = Vec2::Zero();       // pixels
  Rgb colour = Rgb::Zero();
  bool whole =
      true;  // doesn't run on where the drawing shows nothing of it, or something before it
};

// largest: pixels across; what is larger is the ground that details lie on
// step:    units of depth between neighbours that are an edge of the model
// label:   filled: per pixel of the sketch the detail that it belongs to, −1 where none
std::vector<DrawnDetail> drawn_details(const Sketch& sketch, double largest, double step,
                                       std::vector<int>& label);

// Visits the pixels that share a side with one.
template <class Visit>
void each_beside(const Sketch& sketch, std::size_t p, const Visit& visit) {
  const std::size_t width = sketch.width, x = p % width, y = p / width;
  if (x > 0) visit(p - 1);
  if (x + 1 < width) visit(p + 1);
  if (y > 0) visit(p - width);
  if (y + 1 < std::size_t(sketch.height)) visit(p + width);
}

// The pixels within so many steps to the side of some, ascending.
std::vector<std::size_t> grown(const Sketch& sketch, const std::vector<std::size_t>& pixels,
                               int steps);

}  // namespace artisketch

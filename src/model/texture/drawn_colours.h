// The colours that one drawing gives to a model laid over it, freed of ink and paper.
#pragma once

#include "base/raster.h"
#include "model/texture/drawn_surface.h"

namespace artisketch {

// Takes the drawing's colours where they can be trusted, and spreads them from there to the model's
// outlines without crossing one. Fills the sketch.
//   frame, picture  the drawing, of one size
//   F, seen         the model's triangles, and which of them each pixel shows
//   pixel           units that a pixel takes
void fill_colours(const Frame& frame, const Image& picture, const Triangles& F, Visible seen,
                  double pixel, Sketch& sketch);

}  // namespace artisketch

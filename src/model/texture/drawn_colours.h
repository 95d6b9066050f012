// The colours that one drawing gives to a model laid over it, freed of ink and paper.
#pragma once

#include "base/raster.h"
#include "model/texture/part_colours.h"

namespace artisketch {

// Takes the drawing's colours where they can be trusted, and spreads them from there to the model's
// outlines without crossing one. Where parts are outlined, a part has no colours but those inside
// its own outline, and none there that the outline of a part before it takes, or that by their look
// are another part's. Fills the sketch.
//   frame, picture  the drawing, of one size
//   F, seen         the model's triangles, and which of them each pixel shows
//   holders         #F, the joints of each
//   colours         of the parts, over all drawings
//   held            per pixel, the joint of the thing held before all else there, or −1; or empty
//   pixel, fine     units that a pixel takes in figures of the size that is worked on (see
//                   working_scale.h), and how many of the drawing's pixels lie along it
void fill_colours(const Frame& frame, const Image& picture, const Triangles& F,
                  const std::vector<Holders>& holders, const PartColours& colours, Visible seen,
                  std::span<const int> held, double pixel, int fine, Sketch& sketch);

}  // namespace artisketch

// The colours of what no drawing shows.
#pragma once

#include "model/texture/drawn_surface.h"

namespace artisketch {

// One colour per vertex of the model's mesh: what the views that paint round it show there, else
// one of the few colours of its part, as those seen along the part's surface have it. Ways round a
// part's bone count as shorter than ways along it, since belts, cuffs and stockings run round.
// Parts that are seen nowhere take what lies beside them.
//   beside  the mesh's vertices
//   chosen  #F, the view that paints each triangle; −1: none
std::vector<Rgb> plain_colours(const Model& model, const Adjacency& beside,
                               const std::vector<int>& chosen, const DrawnSurface& surface);

}  // namespace artisketch

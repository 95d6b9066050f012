// The colours of what no drawing shows.
#pragma once

#include <array>
#include <vector>

#include "model/texture/drawn_surface.h"

namespace artisketch {

// The few colours of each part, and how much each vertex has of each: what has the most paints it.
struct PlainPaint {
  static constexpr int kMostColours = 6;               // of a part
  std::vector<std::vector<Rgb>> palettes;              // of each joint's part, at most kMostColours
  std::vector<int> part;                               // #V, whose palette; -1: nothing is known
  std::vector<std::array<float, kMostColours>> share;  // #V, of each of its colours
  std::vector<int> own;     // #V: of which colour it has its own tone, as a view shows it; -1: none
  Rgb usual = Rgb::Zero();  // what most of the figure is: for parts of which nothing is known
  std::vector<Rgb> colour;  // #V: that tone
};

// What the views show of a part votes for the rest of it, by how near it lies: heights along the
// bone count above all, since belts, cuffs and stockings run round it. Parts that are seen nowhere
// take what lies beside them.
//   beside  the mesh's vertices
//   chosen  #F, the view that paints each triangle; -1: none
PlainPaint plain_paint(const Model& model, const Adjacency& beside, const std::vector<int>& chosen,
                       const DrawnSurface& surface);

}  // namespace artisketch

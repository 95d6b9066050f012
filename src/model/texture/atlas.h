// Charts of a surface, packed into one picture.
#pragma once

#include "model/texture/view_choice.h"

namespace artisketch {

struct Atlas {
  int width = 0, height = 0;  // texels
  std::vector<int> chart;     // #F
  Triangles corners;          // #F×3 indices into the lists below
  std::vector<int> vertex;    // the mesh's vertex at each: seams split them
  std::vector<Vec2> texels;   // its place in the picture, texels from the top-left corner
};

// A chart is a connected set of triangles that one view paints, laid out as that view sees it, a
// texel a pixel (fewer where all would pass 4 million); or one that none paints and that faces one
// way, laid flat at `scale` texels a unit. Charts lie kGutter texels apart at least, twice; the
// picture is as small as that leaves it, its sides multiples of four.
inline constexpr int kGutter = 4;
Atlas make_atlas(const Mesh& mesh, const FaceNeighbours& neighbours, const std::vector<int>& views,
                 const DrawnSurface& surface, double scale);

// Gives texels without alpha the colour of the nearest one that has it, by steps along rows and
// columns.
void fill_gutters(Image& picture);

}  // namespace artisketch

// Rasters: masks of polygons and meshes, distances between outlines, and which triangle of a mesh
// each pixel sees. Pixel (x, y) covers [x, x + 1) × [y, y + 1); its centre decides, and a centre on
// an edge belongs to the side toward +x: polygons and triangles that share an edge share no pixel
// and leave none between them. Polygons and triangles with a coordinate that isn't finite, or is
// beyond kFarthestPixel, are left out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/mesh.h"

namespace artisketch {

inline constexpr double kFarthestPixel = 1e9;

struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> in;  // rows from the top, 0 or 1
  Mask() = default;
  Mask(int width, int height) : width(width), height(height), in(std::size_t(width) * height, 0) {}
  std::uint8_t& at(int x, int y) { return in[std::size_t(y) * width + x]; }
  std::uint8_t at(int x, int y) const { return in[std::size_t(y) * width + x]; }
};

// Adds to the mask the inside of polygons (even-odd over all of them), in pixels of the mask.
void add_polygons(std::span<const std::vector<Vec2>> polygons, Mask& mask);

// Adds the triangles F of the projected vertices `pixels` (#V) to the mask.
void add_triangles(std::span<const Vec2> pixels, const Triangles& F, Mask& mask);

// The same for a closed surface, of which the triangles that turn one way cover what all do: half
// the work.
void add_surface(std::span<const Vec2> pixels, const Triangles& F, Mask& mask);

// 1 where both are empty. Masks of one size.
double intersection_over_union(const Mask& a, const Mask& b);

// Symmetric mean distance between the outlines of two masks of one size, in pixels of the mask: the
// mean way from each mask's outline to the nearest point of the other's, averaged over the two. An
// outline is made of the pixels in the mask that have a neighbour (of four) out of it or lie at the
// border. +infinity where just one mask is empty, 0 where both are.
double outline_distance(const Mask& a, const Mask& b);

// The triangle that each pixel sees.
struct Visible {
  int width = 0, height = 0;
  std::vector<int> face;     // the nearest triangle's index, −1 where there is none
  std::vector<float> depth;  // its depth there, +infinity where there is none
};

// Rasters the triangles F of the projected vertices `pixels` (#V).
//   depth  #V, smaller is nearer; of equal depths the first triangle is seen
//   w      #V distances before a perspective camera, > 0, which make the interpolation
//          perspective-correct; empty: affine
Visible raster_triangles(std::span<const Vec2> pixels, std::span<const double> depth,
                         std::span<const double> w, const Triangles& F, int width, int height);

// The weights of a triangle's corners at p (pixels), perspective-correct by the corners' distances
// `w`; ones make them affine. They sum to 1, none is negative: a point outside counts as on the
// border.
Vec3 corner_weights(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c, const Vec3& w);

}  // namespace artisketch

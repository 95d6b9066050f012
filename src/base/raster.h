// Rasters: masks of polygons and meshes, distances between outlines, a depth-buffered triangle
// raster. Pixel (x, y) covers [x, x + 1) × [y, y + 1); its centre decides.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/mesh.h"

namespace artisketch {

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

double intersection_over_union(const Mask& a, const Mask& b);  // 1 where both are empty

// Symmetric mean distance between the outlines of two masks, in pixels of the mask; +infinity where
// just one is empty, 0 where both are.
double outline_distance(const Mask& a, const Mask& b);

// Calls draw(x, y, face, barycentric weights, depth) for each pixel's nearest triangle, later in
// no set order. depth: #V, smaller is nearer; weights are perspective-correct where w (#V, the
// depth before the camera) is given, else affine.
using ShadePixel = std::function<void(int x, int y, int face, const Vec3& weights, double depth)>;
void raster_triangles(std::span<const Vec2> pixels, std::span<const double> depth,
                      std::span<const double> w, const Triangles& F, int width, int height,
                      const ShadePixel& draw);

}  // namespace artisketch

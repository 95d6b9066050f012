// A part's outlines made ready for the many questions that carving and rims ask: how far does this
// point of rest space lie outside of what the views allow?
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "base/distance_raster.h"
#include "model/stages.h"

namespace artisketch {

// One view's outline as a cone in rest space.
struct Silhouette {
  const PartView* view = nullptr;
  DistanceRaster raster;
  double grown = 0;                // pixels given to the outline all round
  bool bounds_only = false;        // tells where the part can't be, not where its rim is
  Vec3 direction = Vec3::UnitZ();  // of the ray through the outline's middle, away from the camera

  Silhouette(const PartView& view, int cells);
  // Signed distance to the cone at p in units, negative inside; +infinity behind the camera.
  double distance(const Vec3& p) const;
  enum class Unit { units, pixels };
  // values[i] = max(values[i], distance(start + i · step)), i = 0 … n − 1.
  void raise(const Vec3& start, const Vec3& step, int n, float* values,
             Unit unit = Unit::units) const;
  // The same for the samples (i, j, k) of a block, `cell` apart along the axes: x fastest, rows
  // stride_y and stride_z apart in `values`.
  void raise(const Vec3& start, double cell, const Index3& n, float* values,
             std::ptrdiff_t stride_y, std::ptrdiff_t stride_z) const;
};

// Whether two view directions leave the same depth open: within 10° of each other or of each
// other's opposite.
bool same_direction(const Vec3& a, const Vec3& b);

// The depths that views of one direction leave to a part: as deep as its narrow side is wide, about
// its bone.
struct Slab {
  Vec3 centre = Vec3::Zero(), direction = Vec3::UnitZ();
  double half = std::numeric_limits<double>::infinity();  // units; infinite: no limit
  double distance(const Vec3& p) const {
    return std::isinf(half) ? -half : std::abs((p - centre).dot(direction)) - half;
  }
};

struct Carving {
  std::string name;  // of the part
  std::vector<Silhouette> views;
  Slab slab;
  Vec3 middle = Vec3::Zero();  // of the part's bones, or its joint
  double radius = 0;           // units: of the largest ball that every outline could hold
  Box3 room;                   // a cube that surely holds the hull

  double distance(const Vec3& p) const {
    double most = slab.distance(p);
    for (const Silhouette& view : views) most = std::max(most, view.distance(p));
    return most;
  }
  bool one_direction() const { return !std::isinf(slab.half); }
};

// The closed outlines of the part's own views. `cells` along the longest side sets the rasters'
// resolution. Fails where no view has a closed outline.
Result<Carving> carving_of(const Part& part, int cells);
// The part's carving with the outlines of further views beside its own.
void add_views(const Part& part, std::span<const PartView> views, int cells, Carving& carving);

// part_grid and visual_hull of stages.h for a carving. Distances of up to about `band` cells are
// true; beyond, the sign is, and the value lies beyond `band`.
Result<Grid3<float>> carving_grid(const Carving& carving, int cells);
Result<Grid3<float>> carve(const Carving& carving, int cells, Run& run, double band = 4);

// Grows all outlines until they share a volume, if they share none, and says so in a warning.
void widen_until_they_meet(Carving& carving, std::vector<std::string>& warnings);

}  // namespace artisketch

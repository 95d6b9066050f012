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
  double grown = 0;  // pixels given to the outline all round
  double trust = 1;  // 0 … 1: how much it says of where its rim is, beside where the part can't be
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

// sin² of the angle between two view directions: 0 too where they are opposite, for then they leave
// the same depth open.
double sin2_between(const Vec3& a, const Vec3& b);
// … up to which they count as one: that of 10°.
inline constexpr double kOneDirection = 0.0301536896;

// sin² of the largest angle between the directions from which a part's outlines show it; 0 of one.
double widest_spread(const Part& part);

// The depths that views leave to a part which are all near one direction: as deep as its narrow
// side is wide, about its bones, and the deeper the farther the views are apart.
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
  double spread = 0;           // sin² of the largest angle between the directions of two views
  double open_depth = 1;       // how little the part's own views tell of its depth, 0 … 1
  Vec3 middle = Vec3::Zero();  // of the part's bones, or its joint
  Vec3 centre = Vec3::Zero();  // that moved along the first view to where outlines' middles agree
  double radius = 0;           // units: of the largest ball that every outline could hold
  Box3 room;                   // a cube that surely holds the hull

  double distance(const Vec3& p) const {
    double most = slab.distance(p);
    for (const Silhouette& view : views) most = std::max(most, view.distance(p));
    return most;
  }
  // Whether the views leave the depth wholly open: none is 10° off another, or off its opposite.
  bool one_direction() const { return spread <= kOneDirection; }
};

// A point of the part's bones (or its joint), about which a part without a depth of its own lies.
Vec3 middle_of_bones(const Part& part);

// The closed outlines of the part's own views. `cells` along the longest side sets the rasters'
// resolution. Fails where no view has a closed outline.
Result<Carving> carving_of(const Part& part, int cells);
// The part's carving with the outlines of further views beside its own.
void add_views(const Part& part, std::span<const PartView> views, int cells, Carving& carving);

// The grid of visual_hull in stages.h, and the hull on it. Distances of up to about `band` cells
// are true; beyond, the sign is, and the value lies beyond `band`: nearly as far as the sample
// does, or anywhere where only signs are wanted.
enum class Beyond { near, signs };
Result<Grid3<float>> carving_grid(const Carving& carving, int cells);
Result<Grid3<float>> carve(const Carving& carving, int cells, Run& run, double band = 4,
                           Beyond beyond = Beyond::near);

// Grows all outlines until they share a volume, if they share none, and says so in a warning.
void widen_until_they_meet(Carving& carving, std::vector<std::string>& warnings);

}  // namespace artisketch

// All parts as one body: the union of their signed distances, in which non-adjacent parts keep a
// gap between them and capsules bridge parts that touch no other.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "base/block_grid.h"
#include "model/consolidate/part_tree.h"

namespace artisketch {

// All within `radius` (units) of a segment: a bridge between two parts that don't touch.
struct Capsule {
  Segment axis;
  double radius = 0;
  double distance(const Vec3& p) const { return axis.distance(p) - radius; }
  Box3 box() const {
    const Vec3 around = Vec3::Constant(radius);
    return {axis.a.cwiseMin(axis.b) - around, axis.a.cwiseMax(axis.b) + around};
  }
};

class Body {
 public:
  // parts must outlive the body. A part ends where its samples do. `gap` (units) is the least
  // distance that is left between parts that aren't adjacent, outside the spheres of the joints
  // between them.
  Body(std::span<const PartSurface> parts, const PartTree& tree,
       std::span<const JointSphere> spheres, double gap);

  std::vector<Capsule> capsules;

  int size() const { return int(fields_.size()); }
  void set_gap(double gap) { gap_ = gap; }
  // Distance of one part at p; beyond its grid the border's value plus the way to it.
  double part_distance(int part, const Vec3& p) const;
  double part_distance(int part, const Vec3& p, Vec3& gradient) const;

  // The body at p; the gradient is of about unit length, `part` the one that p belongs to (−1: a
  // capsule). Only the parts in `near` are considered.
  struct Reading {
    double distance = BlockGrid::kOutside;
    Vec3 gradient = Vec3::Zero();
    int part = -1;
  };
  Reading read(const Vec3& p, std::span<const int> near) const;

  // Whether a third part, not adjacent to one of the two that meet at p, is about as near as they.
  bool crowded(const Vec3& p, std::span<const int> near) const;

  // The body on those blocks of a lattice that its surface may cross, that are inside it, or where
  // two parts that meet both come within `reach`.
  struct Sampled {
    BlockGrid grid;
    std::vector<float> seam;  // as grid.values: how far both of two parts that meet are at most
    std::vector<std::vector<int>> near;  // per stored block: the parts to ask there
    // Stores what is missing beside inside samples, after samples were turned inside.
    void close();
    // The parts to ask at p; none away from everything that is stored.
    std::span<const int> near_at(const Vec3& p) const;
  };
  Result<Sampled> sample(double cell, double reach, Run& run) const;

 private:
  struct Field {  // a part's samples, laid out for speed
    const float* values;
    Vec3 origin;
    double cell;
    Index3 size;
    std::ptrdiff_t sy, sz;
    Box3 box;
  };
  struct Cell;
  // The least and the largest of a part's samples over blocks of kBounds³ of its cells, so that
  // most of space is told apart without reading them.
  struct Bounds {
    static constexpr int kBounds = 8;
    Index3 size = Index3::Zero();
    std::vector<std::array<float, 2>> blocks;
  };
  static Bounds bounds_of(const Field& field);
  // Bounds on a part's distance over a box.
  static std::array<float, 2> range(const Field& field, const Bounds& bounds, const Box3& box);
  // The distance by which p counts as outside part i because it is nearer to the non-adjacent j.
  double apart(int i, int j, double di, double dj, const Vec3& p) const;
  void fill_block(const Vec3& first, double cell, std::span<const int> near, float* values,
                  float* seam) const;

  std::vector<Field> fields_;
  std::vector<std::unique_ptr<Grid3<float>>> cut_;  // samples of parts that their grid cuts off
  const PartTree& tree_;
  double gap_;
  std::vector<int> sphere_of_;  // part → index into spheres_, −1
  std::vector<JointSphere> spheres_;
};

}  // namespace artisketch

// Contour rays through a part's voxels, and the voxel pairs at which rays of different frames come
// nearest (the paper's section 2.2).
#pragma once

#include <memory>
#include <vector>

#include "base/types.h"
#include "document/camera.h"

namespace artisketch {

// A cube of voxels in part space; voxel (i, j, k) is centred at origin + cell · (i + ½, j + ½, k +
// ½).
struct VoxelCube {
  Vec3 origin = Vec3::Zero();
  double cell = 1;  // units
  int side = 0;     // voxels along an edge

  Vec3 centre(int voxel) const {
    return origin +
           cell * Vec3(voxel % side + 0.5, voxel / side % side + 0.5, voxel / (side * side) + 0.5);
  }
};

// The voxels that a ray passes through, in order (Amanatides and Woo 1987). Rays are lines: both
// directions count where `whole_line`.
std::vector<int> voxels_along(const VoxelCube& cube, const Ray& ray, bool whole_line);

// One frame's rays, each as the voxels that it passes through.
using VoxelRays = std::vector<std::vector<int>>;

// How many frames hit each voxel (the paper's nhits).
class HitCount {
 public:
  explicit HitCount(const VoxelCube& cube);
  void add(const VoxelRays& frame);  // counts as one, however many of its rays hit a voxel

  int frames() const { return frames_; }  // the paper's ncam; those without a ray count, too
  int of(int voxel) const { return hits_[voxel]; }

 private:
  int frames_ = 0;
  std::vector<std::uint8_t> hits_;  // at most 255
};

// The voxels that one frame's rays hit.
class HitVoxels {
 public:
  // `all` counts the frame itself and every other; it must outlive this.
  HitVoxels(const VoxelCube& cube, const VoxelRays& frame, const HitCount& all);
  ~HitVoxels();
  HitVoxels(HitVoxels&&) noexcept;

  struct Pair {
    int on_ray = -1, hit = -1;  // voxels; −1: none nearer than the bound
    double distance = 0;        // units, between their centres
    double cost = 0;            // units: distance + λ (frames − hits)
  };
  // The pair of a voxel of `ray` and one of the frame's of least cost (paper: distance + λ (ncam −
  // nhits)), among pairs no farther apart than `reach` units; lambda in units per missing frame.
  // through: the ray that passes through them; of voxels equally near, the one nearest to it.
  Pair best_pair(const std::vector<int>& ray, const Ray& through, double lambda,
                 double reach) const;

 private:
  class Blocks;
  VoxelCube cube_;
  const HitCount& all_;
  std::vector<char> own_;                          // per voxel: the frame hits it
  std::vector<std::unique_ptr<Blocks>> at_least_;  // its voxels with 1, 2, … hits of all
};

}  // namespace artisketch

#include "model/calibrate/ray_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <nanoflann.hpp>

#include "base/within.h"

namespace artisketch {

std::vector<int> voxels_along(const VoxelCube& cube, const Ray& ray, bool whole_line) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double enter = whole_line ? -kFar : 0, leave = kFar;
  const double size = cube.cell * cube.side;
  for (int a = 0; a < 3; ++a) {
    const double o = ray.origin[a] - cube.origin[a], d = ray.direction[a];
    if (std::abs(d) < 1e-12) {
      if (o < 0 || o > size) return {};
      continue;
    }
    enter = std::max(enter, std::min(-o / d, (size - o) / d));
    leave = std::min(leave, std::max(-o / d, (size - o) / d));
  }
  if (enter >= leave) return {};
  const Vec3 start = (ray.at(enter) - cube.origin) / cube.cell;
  std::array<int, 3> at, step;
  std::array<double, 3> next, delta;  // depth (in cells) to the next face, and from face to face
  for (int a = 0; a < 3; ++a) {
    at[a] = int(within(start[a], 0, cube.side - 1));
    const double d = ray.direction[a];
    step[a] = d > 0 ? 1 : -1;
    delta[a] = std::abs(d) < 1e-12 ? kFar : 1 / std::abs(d);
    next[a] = std::abs(d) < 1e-12 ? kFar : (at[a] + (d > 0) - start[a]) / d;
  }
  std::vector<int> voxels;
  const double end = (leave - enter) / cube.cell;
  while (true) {
    voxels.push_back(at[0] + cube.side * (at[1] + cube.side * at[2]));
    const int a = int(std::min_element(next.begin(), next.end()) - next.begin());
    if (next[a] > end) break;
    at[a] += step[a];
    if (at[a] < 0 || at[a] >= cube.side) break;
    next[a] += delta[a];
  }
  return voxels;
}

// A k-d tree over voxel centres, in voxel coordinates.
struct HitVoxels::Tree {
  explicit Tree(std::vector<int> voxels, int side)
      : voxels(std::move(voxels)), side(side), index(3, *this) {
    index.buildIndex();
  }
  std::size_t kdtree_get_point_count() const { return voxels.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return coordinate(voxels[i], int(axis));
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  double coordinate(int voxel, int axis) const {
    return axis == 0 ? voxel % side : axis == 1 ? voxel / side % side : voxel / (side * side);
  }

  std::vector<int> voxels;
  int side;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Tree>, Tree, 3> index;
};

HitCount::HitCount(const VoxelCube& cube)
    : hits_(std::size_t(cube.side) * cube.side * cube.side, 0) {}

void HitCount::add(const VoxelRays& frame) {
  ++frames_;
  std::vector<char> counted(hits_.size(), 0);
  for (const std::vector<int>& ray : frame)
    for (const int voxel : ray)
      if (!counted[voxel] && hits_[voxel] < 255) counted[voxel] = 1, ++hits_[voxel];
}

HitVoxels::HitVoxels(const VoxelCube& cube, const VoxelRays& frame, const HitCount& all)
    : cube_(cube), all_(all), own_(std::size_t(cube.side) * cube.side * cube.side, 0) {
  std::vector<std::vector<int>> voxels(std::min(all.frames(), 255));
  for (const std::vector<int>& ray : frame)
    for (const int voxel : ray) {
      if (own_[voxel]) continue;
      own_[voxel] = 1;
      for (int h = 0; h < all.of(voxel); ++h) voxels[h].push_back(voxel);
    }
  for (std::vector<int>& list : voxels)
    if (!list.empty()) at_least_.push_back(std::make_unique<Tree>(std::move(list), cube.side));
}

HitVoxels::~HitVoxels() = default;
HitVoxels::HitVoxels(HitVoxels&&) noexcept = default;

HitVoxels::Pair HitVoxels::best_pair(const std::vector<int>& ray, double lambda,
                                     double reach) const {
  Pair best;
  best.cost = std::numeric_limits<double>::infinity();
  const auto offer = [&](int on_ray, int hit, double distance) {
    const double cost = distance + lambda * (all_.frames() - all_.of(hit));
    if (cost < best.cost) best = {on_ray, hit, distance, cost};
  };
  // Voxels that the ray shares with the frame come first: they cost no search, and bound it.
  for (const int voxel : ray)
    if (own_[voxel]) offer(voxel, voxel, 0);
  for (int h = int(at_least_.size()); h-- > 0;) {
    const double unseen = lambda * (all_.frames() - (h + 1));
    const Tree& tree = *at_least_[h];
    for (std::size_t i = 0; i < ray.size();) {
      const double bound = std::min(reach, best.cost - unseen) / cube_.cell;
      if (bound <= 1e-9) break;
      const double at[3] = {tree.coordinate(ray[i], 0), tree.coordinate(ray[i], 1),
                            tree.coordinate(ray[i], 2)};
      std::size_t found = 0;
      double squared = 0;
      nanoflann::KNNResultSet<double> nearest(1);
      nearest.init(&found, &squared);
      tree.index.findNeighbors(nearest, at, nanoflann::SearchParams());
      const double distance = std::sqrt(squared);
      if (distance < bound) offer(ray[i], tree.voxels[found], distance * cube_.cell);
      // Voxels along the ray are a step of one apart, so the next ones are no nearer than this.
      const double near = std::min(bound, std::min(reach, best.cost - unseen) / cube_.cell);
      i += std::max(1, int(std::ceil(distance - near)));
    }
  }
  if (best.on_ray < 0) best.cost = best.distance = reach;
  return best;
}

}  // namespace artisketch

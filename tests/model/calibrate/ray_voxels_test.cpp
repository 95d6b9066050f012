#include "model/calibrate/ray_voxels.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

VoxelRays rays_about(const VoxelCube& cube, int count, const Vec3& about, double spread,
                      std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto direction = [&] { return Vec3(share(random), share(random), share(random)); };
  VoxelRays rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 through = about + spread * direction();
    rays.push_back(voxels_along(cube, {through, direction().normalized()}, true));
  }
  return rays;
}

// Every voxel of the ray with every one that the frame hits.
double least_cost_of_any(const VoxelCube& cube, const std::vector<int>& ray, const VoxelRays& frame,
                  const HitCount& all, double lambda, double reach) {
  double least = std::numeric_limits<double>::infinity();
  for (const int on_ray : ray)
    for (const std::vector<int>& hits : frame)
      for (const int hit : hits) {
        const double distance = (cube.centre(on_ray) - cube.centre(hit)).norm();
        if (distance < reach)
          least = std::min(least, distance + lambda * (all.frames() - all.of(hit)));
      }
  return least;
}

// Near each other and far apart, in cubes whose edges are whole blocks of voxels and aren't.
TEST(RayVoxels, TheBestPairCostsNoMoreThanAnyOther) {
  std::mt19937 random(7);
  for (const int side : {24, 27, 50}) {
    const double cell = 0.1, lambda = 1.5 * cell, reach = 0.5 * cell * side;
    const VoxelCube cube{Vec3(-1, 2, 0.5), cell, side};
    const Vec3 middle = cube.origin + Vec3::Constant(cell * side / 2);
    for (const double apart : {0.0, 0.2, 0.4}) {
      const Vec3 aside = Vec3(apart, -apart, apart) * cell * side;
      const VoxelRays newest = rays_about(cube, 12, middle - aside, 0.05, random);
      const VoxelRays earlier = rays_about(cube, 12, middle + aside, 0.05, random);
      const VoxelRays another = rays_about(cube, 12, middle, 0.3, random);
      HitCount all(cube);
      for (const VoxelRays* frame : {&newest, &earlier, &another}) all.add(*frame);
      const HitVoxels hits(cube, earlier, all);
      for (const std::vector<int>& ray : newest) {
        const HitVoxels::Pair pair = hits.best_pair(ray, lambda, reach);
        const double least = least_cost_of_any(cube, ray, earlier, all, lambda, reach);
        if (least == std::numeric_limits<double>::infinity()) {
          EXPECT_EQ(pair.on_ray, -1);
          continue;
        }
        EXPECT_NEAR(pair.cost, least, 1e-9) << side << " " << apart;
        EXPECT_NEAR((cube.centre(pair.on_ray) - cube.centre(pair.hit)).norm(), pair.distance, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace artisketch

#include "model/calibrate/ray_voxels.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

std::vector<Ray> rays_about(int count, const Vec3& about, double spread, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto direction = [&] { return Vec3(share(random), share(random), share(random)); };
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3 through = about + spread * direction();
    rays.push_back({through, direction().normalized()});
  }
  return rays;
}

VoxelRays voxels_of_rays(const VoxelCube& cube, const std::vector<Ray>& rays) {
  VoxelRays voxels;
  for (const Ray& ray : rays) voxels.push_back(voxels_along(cube, ray, true));
  return voxels;
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
      const std::vector<Ray> lines = rays_about(12, middle - aside, 0.05, random);
      const VoxelRays newest = voxels_of_rays(cube, lines);
      const VoxelRays earlier = voxels_of_rays(cube, rays_about(12, middle + aside, 0.05, random));
      const VoxelRays another = voxels_of_rays(cube, rays_about(12, middle, 0.3, random));
      HitCount all(cube);
      for (const VoxelRays* frame : {&newest, &earlier, &another}) all.add(*frame);
      const HitVoxels hits(cube, earlier, all);
      for (std::size_t i = 0; i < newest.size(); ++i) {
        const std::vector<int>& ray = newest[i];
        const HitVoxels::Pair pair = hits.best_pair(ray, lines[i], lambda, reach);
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

// A voxel on either side of the ray's: the ray runs nearer to one of them.
TEST(RayVoxels, OfVoxelsEquallyNearTheRaysNearestIsTaken) {
  const VoxelCube cube{Vec3::Zero(), 1, 16};
  const VoxelRays beside = voxels_of_rays(
      cube, {{Vec3(0, 4.5, 8.5), Vec3::UnitX()}, {Vec3(0, 8.5, 8.5), Vec3::UnitX()}});
  for (const double off : {-0.3, 0.3}) {
    const Ray line{Vec3(8.5, 6.5 + off, 0), Vec3::UnitZ()};
    const VoxelRays ray = voxels_of_rays(cube, {line});
    HitCount all(cube);
    all.add(beside);
    all.add(ray);
    const HitVoxels::Pair pair = HitVoxels(cube, beside, all).best_pair(ray[0], line, 1.5, 10);
    EXPECT_EQ(pair.distance, 2);
    EXPECT_EQ(cube.centre(pair.hit).y(), off < 0 ? 4.5 : 8.5);
  }
}

}  // namespace
}  // namespace artisketch

#include "document/camera.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(NearestToRays, IsWhereRaysMeet) {
  const Vec3 meeting(0.3, -0.2, 0.7);
  NearestToRays nearest(Vec3(5, 5, 5), 1e-9);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0.6, 0, 0.8)})
    nearest.add({meeting - 3 * direction, direction});
  EXPECT_LT((nearest.point() - meeting).norm(), 1e-6);
}

TEST(NearestToRays, ParallelRaysLeaveTheDepthOpen) {
  NearestToRays nearest(Vec3(9, 9, 4), 1e-6);
  nearest.add({Vec3(0, 0, 0), Vec3(0, 0, 1)});
  nearest.add({Vec3(2, 0, 0), Vec3(0, 0, 1)});
  EXPECT_LT((nearest.point() - Vec3(1, 0, 4)).norm(), 1e-4);
}

}  // namespace
}  // namespace artisketch

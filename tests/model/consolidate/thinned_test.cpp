#include "model/consolidate/thinned.h"

#include <gtest/gtest.h>

#include "base/grid.h"
#include "model/stages.h"

namespace artisketch {
namespace {

TEST(Thinned, ABallKeepsItsRadiusInFarFewerTriangles) {
  constexpr double kRadius = 1, kError = 0.005;
  Grid3<float> field(Vec3::Constant(-1.2), 0.05, Index3::Constant(49));
  for (int k = 0; k < 49; ++k)
    for (int j = 0; j < 49; ++j)
      for (int i = 0; i < 49; ++i) field(i, j, k) = float(field.position(i, j, k).norm() - kRadius);
  const Result<Mesh> ball = isosurface(field);
  ASSERT_TRUE(ball);
  const Mesh fewer = thinned(*ball, kError);
  EXPECT_LT(fewer.F.rows(), ball->F.rows() / 3);
  EXPECT_TRUE(topology(fewer).manifold());
  for (Eigen::Index v = 0; v < fewer.V.rows(); ++v)
    EXPECT_NEAR(fewer.V.row(v).norm(), kRadius, 2 * kError);
  EXPECT_NEAR(signed_volume(fewer), 4 * kPi / 3, 0.05);
}

TEST(Thinned, NothingStaysNothing) {
  EXPECT_EQ(thinned(Mesh{Points3(0, 3), Triangles(0, 3)}, 0.1).F.rows(), 0);
}

}  // namespace
}  // namespace artisketch

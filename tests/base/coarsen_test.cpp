#include "base/coarsen.h"

#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(Coarsened, KeepsASphereAManifoldSphere) {
  const Mesh sphere = icosphere({1, 2, 3}, 2, 4);  // 2562 vertices
  const Mesh coarse = coarsened(sphere, 500);
  const Topology t = topology(coarse);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.genus(), 0);
  EXPECT_EQ(coarse.V.rows(), 500);
  EXPECT_NEAR(signed_volume(coarse), signed_volume(sphere), 0.04 * signed_volume(sphere));
  for (int v = 0; v < coarse.V.rows(); ++v)
    EXPECT_NEAR((coarse.V.row(v) - Vec3(1, 2, 3).transpose()).norm(), 2, 0.06);
}

TEST(Coarsened, MakesEdgesAlike) {
  const Mesh coarse = coarsened(icosphere({0, 0, 0}, 1, 4), 600);
  double least = 1e9, most = 0;
  for (int f = 0; f < coarse.F.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const double d =
          (coarse.V.row(coarse.F(f, c)) - coarse.V.row(coarse.F(f, (c + 1) % 3))).norm();
      least = std::min(least, d);
      most = std::max(most, d);
    }
  EXPECT_LT(most, 4 * least);
}

// A torus can't lose its hole, however few vertices are asked for.
TEST(Coarsened, NeverChangesTheGenus) {
  const int n = 24, m = 48;
  Mesh torus{Points3(n * m, 3), Triangles(2 * n * m, 3)};
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = 2 * kPi * i / m, b = 2 * kPi * j / n, r = 1 + 0.2 * std::cos(b);
      torus.V.row(i * n + j) << r * std::cos(a), r * std::sin(a), 0.2 * std::sin(b);
      const int i1 = (i + 1) % m, j1 = (j + 1) % n;
      torus.F.row(2 * (i * n + j)) << i * n + j, i1 * n + j, i1 * n + j1;
      torus.F.row(2 * (i * n + j) + 1) << i * n + j, i1 * n + j1, i * n + j1;
    }
  ASSERT_GT(signed_volume(torus), 0);
  for (const int wanted : {600, 100, 4}) {
    const Mesh coarse = coarsened(torus, wanted);
    EXPECT_TRUE(topology(coarse).manifold());
    EXPECT_EQ(topology(coarse).genus(), 1);
    EXPECT_GT(signed_volume(coarse), 0);
    EXPECT_LT(coarse.V.rows(), torus.V.rows());
  }
}

TEST(Coarsened, LeavesWhatIsSmallEnough) {
  const Mesh sphere = icosphere({0, 0, 0}, 1, 1);
  EXPECT_EQ(coarsened(sphere, 100).V, sphere.V);
}

}  // namespace
}  // namespace artisketch

#include "base/mesh.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(Mesh, IcosphereIsAClosedSphere) {
  const Mesh ball = icosphere({1, 2, 3}, 2, 4);
  const Topology t = topology(ball);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.genus(), 0);
  EXPECT_NEAR(signed_volume(ball), 4.0 / 3 * kPi * 8, 0.15);
  EXPECT_NEAR(surface_area(ball), 4 * kPi * 4, 0.1);
  const Points3 N = vertex_normals(ball);
  for (int v = 0; v < N.rows(); ++v)
    EXPECT_GT(N.row(v).dot((ball.V.row(v) - Eigen::RowVector3d(1, 2, 3)) / 2), 0.999);
}

TEST(Mesh, TopologyNamesEachFault) {
  Mesh ball = icosphere(Vec3::Zero(), 1, 1);
  const Mesh whole = ball;
  ball.F.conservativeResize(ball.F.rows() - 1, 3);
  EXPECT_EQ(topology(ball).boundary_edges, 3);
  ball = whole;
  std::swap(ball.F(0, 0), ball.F(0, 1));
  EXPECT_EQ(topology(ball).misoriented_edges, 3);
  // Two balls that share one vertex: closed, but pinched there.
  Mesh two{Points3(2 * whole.V.rows(), 3), Triangles(2 * whole.F.rows(), 3)};
  two.V << whole.V, whole.V.rowwise() + Eigen::RowVector3d(5, 0, 0);
  two.F << whole.F, (whole.F.array() + int(whole.V.rows())).matrix();
  EXPECT_EQ(topology(two).components, 2);
  for (int f = 0; f < two.F.rows(); ++f)
    for (int c = 0; c < 3; ++c)
      if (two.F(f, c) == whole.V.rows()) two.F(f, c) = 0;
  EXPECT_TRUE(topology(two).closed());
  EXPECT_EQ(topology(two).pinched_vertices, 1);
  EXPECT_FALSE(topology(two).manifold());
}

TEST(Mesh, WeldingClosesASoup) {
  const Mesh ball = icosphere(Vec3::Zero(), 1, 2);
  Mesh soup{Points3(3 * ball.F.rows(), 3), Triangles(ball.F.rows(), 3)};
  for (int i = 0; i < 3 * ball.F.rows(); ++i) {
    soup.V.row(i) = ball.V.row(ball.F(i / 3, i % 3));
    soup.F(i / 3, i % 3) = i;
  }
  EXPECT_FALSE(topology(soup).closed());
  const Mesh one = welded(soup);
  EXPECT_EQ(one.V.rows(), ball.V.rows());
  EXPECT_TRUE(topology(one).manifold());
}

TEST(Mesh, LargestComponentKeepsTheBiggerBall) {
  const Mesh small = icosphere({5, 0, 0}, 0.5, 3), big = icosphere(Vec3::Zero(), 1, 2);
  Mesh both{Points3(small.V.rows() + big.V.rows(), 3), Triangles(small.F.rows() + big.F.rows(), 3)};
  both.V << small.V, big.V;
  both.F << small.F, (big.F.array() + int(small.V.rows())).matrix();
  EXPECT_EQ(largest_component(both).V, big.V);
}

}  // namespace
}  // namespace artisketch

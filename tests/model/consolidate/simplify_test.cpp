#include <cmath>

#include <gtest/gtest.h>

#include "base/dual_surface.h"
#include "base/self_intersection.h"
#include "base/well_composed.h"
#include "model/consolidate/unfold.h"
#include "model/stages.h"

namespace artisketch {
namespace {

TEST(Simplify, ABallKeepsItsShapeWithATenthOfTheTriangles) {
  const Mesh ball = icosphere({1, 2, 3}, 1, 6);
  const Mesh fewer = simplified(ball, int(ball.F.rows()) / 10, 0.01);
  EXPECT_LE(fewer.F.rows(), ball.F.rows() / 9);
  EXPECT_TRUE(topology(fewer).manifold());
  EXPECT_EQ(topology(fewer).genus(), 0);
  EXPECT_NEAR(signed_volume(fewer), signed_volume(ball), 0.01 * signed_volume(ball));
}

// A ball as the lattice of one skin makes it: nearly even squares, cut in two.
Mesh lattice_ball(double cell) {
  BlockGrid grid(Vec3::Constant(-1 - 4 * cell), cell,
                 Index3::Constant(int((2 + 8 * cell) / cell / BlockGrid::kSide) + 1));
  grid.store(std::vector<char>(grid.slot.size(), 1));
  for (std::ptrdiff_t s = 0; s < std::ptrdiff_t(grid.values.size()); ++s) {
    const Index3 at = grid.sample_of(s);
    grid.values[s] = float(grid.position(at.x(), at.y(), at.z()).norm() - 1);
  }
  make_well_composed(grid);
  const QuadMesh quads = dual_surface(grid);
  Mesh ball{quads.V, split_quads(quads.V, quads.Q)};
  for (int v = 0; v < ball.V.rows(); ++v) ball.V.row(v).normalize();
  return ball;
}

TEST(Simplify, ABallHasNoFoldsAndItsNormalsStayTrue) {
  const Mesh ball = lattice_ball(0.0175);
  ASSERT_GT(ball.F.rows(), 50000);
  for (const int wanted : {30000, 15000, 4000}) {
    const Mesh fewer = simplified(ball, wanted, 0.01);
    EXPECT_NEAR(fewer.F.rows(), wanted, 0.02 * wanted);
    EXPECT_TRUE(folds(fewer, face_neighbours(fewer.F)).empty());
    const Points3 normals = vertex_normals(fewer);
    double worst = 1;
    for (int v = 0; v < fewer.V.rows(); ++v)
      worst = std::min(worst, normals.row(v).dot(fewer.V.row(v).normalized()));
    EXPECT_GT(worst, std::cos(radians(2))) << wanted;
    for (int f = 0; f < fewer.F.rows(); ++f) {
      const Vec3 a = fewer.V.row(fewer.F(f, 0)), b = fewer.V.row(fewer.F(f, 1)),
                 c = fewer.V.row(fewer.F(f, 2));
      EXPECT_GT((b - a).cross(c - a).normalized().dot(a), 0.9) << wanted;
    }
  }
}

TEST(Simplify, ABoxKeepsItsEdges) {
  Mesh box = icosphere(Vec3::Zero(), 1, 6);
  for (int v = 0; v < box.V.rows(); ++v) box.V.row(v) /= box.V.row(v).cwiseAbs().maxCoeff();
  const Mesh fewer = simplified(box, int(box.F.rows()) / 20, 0.05);
  EXPECT_TRUE(folds(fewer, face_neighbours(fewer.F)).empty());
  EXPECT_NEAR(signed_volume(fewer), 8, 0.01 * 8);
}

TEST(Simplify, StopsAtTheErrorAskedFor) {
  const Mesh ball = icosphere(Vec3::Zero(), 1, 5);
  const Mesh fewer = simplified(ball, 4, 0.02);
  EXPECT_GT(fewer.F.rows(), 40);
  for (int f = 0; f < fewer.F.rows(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (int c = 0; c < 3; ++c) middle += fewer.V.row(fewer.F(f, c)).transpose() / 3;
    EXPECT_GT(middle.norm(), 1 - 3 * 0.02);
  }
}

TEST(Simplify, ABladesSidesStayApart) {
  Mesh blade = icosphere(Vec3::Zero(), 1, 6);
  for (int v = 0; v < blade.V.rows(); ++v)  // bent, and much thinner than the error
    blade.V(v, 2) = 0.002 * blade.V(v, 2) + 0.3 * blade.V(v, 0) * blade.V(v, 0);
  const Mesh fewer = simplified(blade, int(blade.F.rows()) / 20, 0.02);
  EXPECT_TRUE(topology(fewer).manifold());
  EXPECT_TRUE(self_intersections(fewer).empty());
  // Nor once a file has rounded them: sides as near as these would touch.
  const double step = position_step(fewer.V);
  EXPECT_EQ((fewer.V / step).array().round().matrix(), fewer.V / step);
}

TEST(Simplify, AThinNeckIsNotPinched) {
  Mesh beads = icosphere(Vec3::Zero(), 1, 6);
  for (int v = 0; v < beads.V.rows(); ++v) {  // a row of beads on a thin string
    const double thick = 0.004 + 0.3 * std::pow(std::sin(9 * beads.V(v, 0)), 2);
    beads.V.block<1, 2>(v, 1) *= thick;
    beads.V(v, 0) *= 3;
  }
  for (const int share : {10, 20}) {
    const int wanted = int(beads.F.rows()) / share;
    const Mesh fewer = simplified(beads, wanted, 0.05);
    EXPECT_TRUE(topology(fewer).manifold());
    EXPECT_EQ(topology(fewer).components, 1);
    EXPECT_LE(fewer.F.rows(), 1.1 * wanted);
  }
}

// Where the first try pinches, more triangles are tried: never more than there are.
TEST(Simplify, AMeshThatPinchesAtOnceKeepsWhatItHas) {
  Mesh beads = icosphere(Vec3::Zero(), 1, 4);
  for (int v = 0; v < beads.V.rows(); ++v) {  // on a string of nearly nothing
    beads.V.block<1, 2>(v, 1) *= 1e-5 + 0.3 * std::pow(std::sin(15 * beads.V(v, 0)), 2);
    beads.V(v, 0) *= 3;
  }
  for (const int fewer : {0, 1, 2, 10, 100, 1000, 2000}) {
    const int wanted = int(beads.F.rows()) - fewer;
    const Mesh mesh = simplified(beads, wanted, 0.5);
    EXPECT_LE(mesh.F.rows(), beads.F.rows());
    EXPECT_TRUE(topology(mesh).closed());
  }
}

TEST(Simplify, AskingForMoreThanThereAreChangesNothing) {
  const Mesh ball = icosphere(Vec3::Zero(), 1, 2);
  EXPECT_EQ(simplified(ball, 1 << 20, 0.1).V, ball.V);
}

}  // namespace
}  // namespace artisketch

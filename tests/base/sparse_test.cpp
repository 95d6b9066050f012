#include "base/sparse.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(CotangentLaplacian, OfASphereGivesTheMeanCurvatureNormal) {
  const double r = 2;
  const Mesh sphere = icosphere(Vec3::Zero(), r, 4);
  const SparseMatrix L = cotangent_laplacian(sphere);
  const Eigen::VectorXd areas = lumped_areas(sphere);
  // Δx = −2/r · n on a sphere of radius r.
  const Points3 Lx = L * sphere.V;
  for (int v = 0; v < sphere.V.rows(); ++v) {
    const Vec3 expected = -2 / r * sphere.V.row(v).transpose() / r;
    EXPECT_NEAR((Lx.row(v).transpose() / areas[v] - expected).norm(), 0, 0.15);
  }
}

TEST(CotangentLaplacian, IsSymmetricAndItsRowsSumToZero) {
  const Mesh sphere = icosphere({1, 2, 3}, 0.5, 2);
  const SparseMatrix L = cotangent_laplacian(sphere);
  EXPECT_NEAR((L * Eigen::VectorXd::Ones(L.cols())).norm(), 0, 1e-10);
  EXPECT_NEAR(SparseMatrix(L - SparseMatrix(L.transpose())).norm(), 0, 1e-12);
}

// A linear function has no Laplacian inside a flat mesh, however its triangles lie.
TEST(CotangentLaplacian, OfALinearFunctionVanishesInThePlane) {
  Mesh fan{Points3(7, 3), Triangles(6, 3)};
  fan.V.row(0) << 0.1, -0.2, 0;
  for (int i = 0; i < 6; ++i) {
    fan.V.row(i + 1) << std::cos(i * kPi / 3), std::sin(i * kPi / 3), 0;
    fan.F.row(i) << 0, i + 1, (i + 1) % 6 + 1;
  }
  const Eigen::VectorXd f = fan.V * Vec3(3, -2, 0);
  EXPECT_NEAR((cotangent_laplacian(fan) * f)[0], 0, 1e-12);
}

TEST(CotangentLaplacian, StaysFiniteAndSemiDefiniteOnSlivers) {
  Mesh sliver{Points3(5, 3), Triangles(6, 3)};
  sliver.V << 0, 0, 0, 1, 0, 0, 0.5, 1e-9, 0, 0.5, 1, 0, 0.5, 1, 0;
  sliver.F << 0, 1, 2, 1, 0, 3, 0, 2, 3, 1, 3, 2, 2, 3, 4, 4, 4, 4;
  const Eigen::MatrixXd L = cotangent_laplacian(sliver);
  EXPECT_TRUE(L.allFinite());
  EXPECT_LE(L.cwiseAbs().maxCoeff(), 6 * kMostCotangent);
  EXPECT_LE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(L).eigenvalues().maxCoeff(), 1e-9);
}

TEST(LumpedAreas, SumToTheSurface) {
  const Mesh sphere = icosphere({1, 2, 3}, 0.5, 3);
  EXPECT_NEAR(lumped_areas(sphere).sum(), surface_area(sphere), 1e-9);
}

TEST(LumpedAreas, ArePositiveWithoutArea) {
  Mesh flat{Points3::Zero(4, 3), Triangles(1, 3)};
  flat.F << 0, 1, 2;
  EXPECT_GT(lumped_areas(flat).minCoeff(), 0);
}

TEST(Solve, ManySidesAtOnceAsOneByOne) {
  const Mesh sphere = icosphere({1, 2, 3}, 0.5, 3);
  SparseMatrix A = -cotangent_laplacian(sphere);
  A += SparseMatrix(lumped_areas(sphere).asDiagonal());
  const Factors factors(A);
  ASSERT_EQ(factors.info(), Eigen::Success);
  Columns B(sphere.V.rows(), 5);
  for (Eigen::Index i = 0; i < B.size(); ++i) B.data()[i] = std::sin(double(i));
  const Columns X = solve(factors, B);
  EXPECT_LT((A * X - B).norm(), 1e-9 * B.norm());
  for (int c = 0; c < 5; ++c) {
    const Eigen::VectorXd x = factors.solve(Eigen::VectorXd(B.col(c)));
    EXPECT_LT((X.col(c) - x).norm(), 1e-12 * x.norm());
  }
}

}  // namespace
}  // namespace artisketch

#include "base/sparse.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace artisketch {
namespace {

Vec3 corner(const Mesh& mesh, int f, int c) {
  return mesh.V.row(mesh.F(f, c)).transpose();
}

}  // namespace

SparseMatrix cotangent_laplacian(const Mesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    // Each cotangent is a dot product of two sides over twice the triangle's area.
    const Vec3 p[3] = {corner(mesh, f, 0), corner(mesh, f, 1), corner(mesh, f, 2)};
    const double longest2 = std::max(
        {(p[1] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm()});
    const double twice_area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
    const double divisor = std::max(twice_area, longest2 / kMostCotangent);
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3, i = mesh.F(f, a), j = mesh.F(f, b);
      const double w = divisor > 0 ? (p[a] - p[c]).dot(p[b] - p[c]) / divisor / 2 : 0.0;
      entries.emplace_back(i, j, w);
      entries.emplace_back(j, i, w);
      entries.emplace_back(i, i, -w);
      entries.emplace_back(j, j, -w);
    }
  }
  SparseMatrix L(mesh.V.rows(), mesh.V.rows());
  L.setFromTriplets(entries.begin(), entries.end());
  return L;
}

Eigen::VectorXd lumped_areas(const Mesh& mesh) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.V.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = corner(mesh, f, 0);
    const double area = (corner(mesh, f, 1) - a).cross(corner(mesh, f, 2) - a).norm() / 2;
    for (int c = 0; c < 3; ++c) areas[mesh.F(f, c)] += area / 3;
  }
  if (areas.size() == 0) return areas;
  const double least = std::max(1e-6 * areas.mean(), std::numeric_limits<double>::min());
  return areas.cwiseMax(least);
}

Columns solve(const Factors& factors, const Columns& B) {
  const auto& L = factors.matrixL().nestedExpression();  // its unit diagonal isn't stored
  const Eigen::VectorXd D = factors.vectorD();
  Columns X = factors.permutationP() * B;
  for (Eigen::Index j = 0; j < X.rows(); ++j)
    for (SparseMatrix::InnerIterator it(L, j); it; ++it) X.row(it.row()) -= it.value() * X.row(j);
  for (Eigen::Index j = X.rows(); j-- > 0;) {
    X.row(j) /= D[j];
    for (SparseMatrix::InnerIterator it(L, j); it; ++it) X.row(j) -= it.value() * X.row(it.row());
  }
  return factors.permutationPinv() * X;
}

}  // namespace artisketch

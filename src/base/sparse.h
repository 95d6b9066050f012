// The sparse operators of a triangle mesh.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "base/mesh.h"

namespace artisketch {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Factors = Eigen::SimplicialLDLT<SparseMatrix>;

// Right-hand sides or solutions side by side, #unknowns × #sides.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// X with A X = B for all right-hand sides at once: the factors are read once, not once for each.
// factors: of A, successful.
Columns solve(const Factors& factors, const Columns& B);

// No cotangent exceeds this (an angle of 2.9°). Marching cubes leaves slivers whose true cotangents
// (10⁴ and more) would drown every other weight in the rounding.
inline constexpr double kMostCotangent = 20;

// #V×#V symmetric, negative semi-definite, rows sum to 0: L(i, j) = (cot α + cot β) / 2 over the
// angles opposite the edge (Pinkall and Polthier 1993). Cotangents stay within ±kMostCotangent: a
// sliver counts as if it had area enough for that, all its three cotangents scaled alike, which
// keeps the matrix semi-definite where clamping them one by one would not.
SparseMatrix cotangent_laplacian(const Mesh& mesh);

// #V barycentric lumped areas: a third of each triangle's area to each of its corners, > 0: a
// vertex without area gets a millionth of the mean, so that dividing by areas stays finite.
Eigen::VectorXd lumped_areas(const Mesh& mesh);

}  // namespace artisketch

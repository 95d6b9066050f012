// The sparse operators of a triangle mesh.
#pragma once

#include <Eigen/SparseCore>

#include "base/mesh.h"

namespace artisketch {

using SparseMatrix = Eigen::SparseMatrix<double>;

// #V×#V symmetric, negative semi-definite: L(i, j) = (cot α + cot β) / 2, rows sum to 0 (Pinkall
// and Polthier 1993). Cotangents are clamped to ±kMostCotangent, so that a sliver stays finite.
SparseMatrix cotangent_laplacian(const Mesh& mesh);

// #V barycentric lumped areas: a third of each triangle's area to each of its corners, > 0.
Eigen::VectorXd lumped_areas(const Mesh& mesh);

}  // namespace artisketch

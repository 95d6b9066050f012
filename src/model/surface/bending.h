// The linear system behind volume reduction: least bending, with some vertices held.
#pragma once

#include "base/sparse.h"

namespace artisketch {

struct BendingSystem {
  SparseMatrix A;            // of the free vertices, symmetric; its lower half alone
  Columns right;             // #free×3
  std::vector<int> unknown;  // per vertex: its row, −1: fixed at its target
};

// xᵀ K x + Σ w (x − t)² is least where A x = right. Vertices with an infinite weight are fixed.
//   K  #V×#V, symmetric, positive semi-definite
BendingSystem bending_system(const SparseMatrix& K, const Eigen::VectorXd& weights,
                             const Points3& targets);

// The bi-Laplacian Δ² of a mesh with cotangent weights, #V×#V: L M⁻¹ L.
SparseMatrix bi_laplacian(const Mesh& mesh);

}  // namespace artisketch

// The linear system behind the weights: (−Δ + H) w = H p, one right-hand side per part.
#pragma once

#include "base/sparse.h"
#include "model/stages.h"

namespace artisketch {

struct HeatSystem {
  SparseMatrix A;        // #V×#V, symmetric, positive definite
  Columns right;         // #V×#parts
  Eigen::VectorXd heat;  // #V, the diagonal of H
};

// Fails without parts that have a body, and if cancelled.
Result<HeatSystem> heat_system(const Document& document, std::span<const PartSurface> parts,
                               const Mesh& mesh, Run& run);

}  // namespace artisketch

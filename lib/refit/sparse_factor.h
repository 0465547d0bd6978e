// SPDX-License-Identifier: Apache-2.0
// P S A S P' = L L' by Eigen: S makes the diagonal 1, P keeps L sparse.
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "refit/quadratic.h"

namespace awd {

struct SparseFactor {
  std::vector<double> scale;          ///< S
  std::vector<int> unknown;           ///< that of each row of L
  Eigen::SparseMatrix<double> lower;  ///< L, column by column, each from the diagonal down
  uint64_t entries = 0;               ///< of L
};

/// L is empty where it would have more entries than allowed, or where A is not positive definite
/// to rounding.
SparseFactor sparseFactor(const Quadratic& quadratic, uint64_t mostEntries);

}  // namespace awd

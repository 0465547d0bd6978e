// SPDX-License-Identifier: Apache-2.0
// The Gram matrix G_jk = int N_j N_k of one axis. Solving G c = b turns coefficients in the dual
// basis into coefficients in the basis itself (eq. 7; for an orthonormal basis eq. 6).
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "basis/family.h"

namespace awd {

/// Banded Cholesky factors of a level's Gram matrix; never an explicit inverse.
class GramSolver {
 public:
  /// Fails with AWD_ERROR_PLUGIN_SELF_TEST if the matrix is not positive definite.
  GramSolver(std::pmr::memory_resource* memory, const BasisLevel& level);

  /// Overwrites `count` vectors b, with `stride` between the elements of one and `vectorStride`
  /// between their firsts, by G^-1 b.
  void solve(double* b, std::size_t stride, std::size_t vectorStride, std::size_t count) const;

 private:
  uint32_t n_;
  uint32_t band_ = 0;                    ///< sub-diagonals of the permuted matrix
  std::pmr::vector<uint32_t> position_;  ///< row of function j in the permuted matrix
  std::pmr::vector<double> factor_;      ///< L(i, i - d) at [i * (band_ + 1) + d]
};

/// G_jk itself by exact integration of Bernstein polynomials, dense, for tests and reports.
std::pmr::vector<double> gramMatrix(std::pmr::memory_resource* memory, const BasisLevel& level);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// A refit solver of the tests' own: sweeps of projected Gauss-Seidel until nothing changes.
#pragma once

#include <algorithm>
#include <cmath>

#include "refit/refit_module.h"

namespace awd {

inline AWDResult solvePlainly(const AWDRefitProblem* p, double* c, AWDRefitOutcome* outcome) {
  std::copy_n(p->start, p->unknowns, c);
  outcome->status = AWD_REFIT_LIMIT;
  while (outcome->iterations < 3000 && outcome->status != AWD_REFIT_CONVERGED) {
    ++outcome->iterations;
    outcome->status = AWD_REFIT_CONVERGED;
    for (uint64_t j = 0; j < p->unknowns; ++j) {
      double rest = p->rhs[j], diagonal = 0.0;
      for (uint64_t i = p->rowBegin[j]; i < p->rowBegin[j + 1]; ++i) {
        if (p->columns[i] == j) {
          diagonal = p->values[i];
        } else {
          rest -= p->values[i] * c[p->columns[i]];
        }
      }
      const double next = std::max(rest / diagonal, p->lower[j]);
      if (!(std::abs(next - c[j]) <= 1e-15 * std::abs(next))) outcome->status = AWD_REFIT_LIMIT;
      c[j] = next;
    }
  }
  return AWD_SUCCESS;
}

constexpr AWDRefitSolver kPlainSolver = {sizeof(AWDRefitSolver), "plain", "of the tests",
                                         solvePlainly};

}  // namespace awd

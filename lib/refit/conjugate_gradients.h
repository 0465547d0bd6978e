// SPDX-License-Identifier: Apache-2.0
// Iterative solution of (A + E)_FF x = r, where a direct one takes too much.
#pragma once

#include <cstdint>
#include <vector>

#include "refit/free_solver.h"

namespace awd {

/// Conjugate gradients, preconditioned by a sweep of Gauss-Seidel there and back. Overwrites r,
/// which is 0 where unknowns are not free, by x; returns whether its residual came down by
/// `reduction` in mostSteps. Throws Cancelled if the host wants no more.
bool conjugateGradients(const Quadratic& quadratic, const FreeSet& set, double reduction,
                        uint32_t mostSteps, double fraction, std::vector<double>& r);

}  // namespace awd

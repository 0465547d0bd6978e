// SPDX-License-Identifier: Apache-2.0
// Which bounds hold, without a guess: a primal-dual interior-point method (Mehrotra 1992). Some
// twenty solutions whatever the condition of A, so it is what starved samples under a small lambda
// want, where pivoting goes round in circles.
#pragma once

#include <vector>

#include "refit/free_solver.h"

namespace awd {

/// Takes x near the optimum, inside of the bounds, and frees the unknowns that won't be held.
void followCentralPath(const Quadratic& quadratic, FreeSolver& solver, double fraction,
                       FreeSet& set, std::vector<double>& x);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// Which bounds hold, from a guess: block principal pivoting (Portugal, Judice and Vicente 1994).
#pragma once

#include <vector>

#include "refit/free_solver.h"

namespace awd {

/// Takes x to the optimum over the free unknowns, all others at their bounds; then all that ended
/// on the wrong side of their bound, or of their gradient, change places; and again until there are
/// none, which is the optimum. Returns false if their number ceases to fall.
bool pivot(const Quadratic& quadratic, FreeSolver& solver, double fraction, FreeSet& set,
           std::vector<double>& x);

}  // namespace awd

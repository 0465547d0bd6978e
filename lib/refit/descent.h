// SPDX-License-Identifier: Apache-2.0
// The solver "descent": projected Gauss-Seidel sweeps find out which bounds hold, and Newton steps
// over the unknowns left free go to the optimum of these at once. Exact to rounding, the same bits
// on every machine, one thread.
#pragma once

#include "refit/solver.h"

namespace awd {

Ending minimiseByDescent(const Quadratic& quadratic, std::vector<double>& c);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// Is a problem what refit_module.h promises? Solvers rely on it: a NaN would make Ceres print, and
// a matrix that is far from positive definite would send them astray.
#pragma once

#include <string>

#include "refit/refit_module.h"

namespace awd {

/// What is wrong and where, or an empty text. Looks at every number.
std::string problemFault(const AWDRefitProblem& problem);

/// Whether n, solution and start are such that the start can be handed back as the solution.
bool hasStart(const AWDRefitProblem& problem);

}  // namespace awd

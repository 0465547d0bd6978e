// SPDX-License-Identifier: Apache-2.0
// What every solver has in common: problems checked, nothing thrown at the host, the start handed
// back where there is no solution.
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "refit/quadratic.h"
#include "refit/refit_module.h"

namespace awd {

/// The host wants no more.
class Cancelled : public std::exception {};

/// Throws Cancelled if the host wants no more.
void reportProgress(const AWDRefitProblem& problem, double fraction);

struct Ending {
  AWDRefitStatus status = AWD_REFIT_FAILED;
  uint32_t iterations = 0;
  std::string message;
};

/// Moves c, which is feasible at first, to the optimum.
using Minimise = Ending (*)(const Quadratic& quadratic, std::vector<double>& c);

/// The whole of AWDRefitSolver::solve around a method.
AWDResult solveBy(Minimise minimise, const AWDRefitProblem* problem, double* solution,
                  AWDRefitOutcome* outcome) noexcept;

}  // namespace awd

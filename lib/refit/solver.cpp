// SPDX-License-Identifier: Apache-2.0
#include "refit/solver.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

#include "refit/problem_check.h"

namespace awd {

namespace {

void describe(AWDRefitOutcome& outcome, AWDRefitStatus status, const char* message) noexcept {
  outcome.status = status;
  std::snprintf(outcome.message, sizeof outcome.message, "%s", message);
  for (char* c = outcome.message; *c; ++c) {
    if (static_cast<unsigned char>(*c) < ' ') *c = ' ';  // one line
  }
}

Ending minimiseChecked(Minimise minimise, const AWDRefitProblem& problem, double* solution,
                       uint64_t& atBound) {
  const Quadratic quadratic(problem);
  std::vector<double> c(problem.start, problem.start + problem.unknowns);
  Ending ending = minimise(quadratic, c);
  if (ending.status != AWD_REFIT_CONVERGED && ending.status != AWD_REFIT_LIMIT) return ending;
  if (!std::all_of(c.begin(), c.end(), [](double value) { return std::isfinite(value); })) {
    return {AWD_REFIT_FAILED, ending.iterations, "diverged: the matrix is not positive definite"};
  }
  for (uint64_t j = 0; j < problem.unknowns; ++j) solution[j] = std::max(c[j], problem.lower[j]);
  atBound = quadratic.optimality(c).atBound;
  return ending;
}

}  // namespace

void reportProgress(const AWDRefitProblem& problem, double fraction) {
  if (problem.progress && !problem.progress(problem.user, fraction)) throw Cancelled();
}

AWDResult solveBy(Minimise minimise, const AWDRefitProblem* problem, double* solution,
                  AWDRefitOutcome* outcome) noexcept {
  outcome->iterations = 0;
  outcome->atBound = 0;
  describe(*outcome, AWD_REFIT_FAILED, "");
  if (hasStart(*problem)) std::copy_n(problem->start, problem->unknowns, solution);
  try {
    const std::string fault = problemFault(*problem);
    if (!fault.empty()) {
      describe(*outcome, AWD_REFIT_FAILED, fault.c_str());
      return AWD_SUCCESS;
    }
    const Ending ending = minimiseChecked(minimise, *problem, solution, outcome->atBound);
    outcome->iterations = ending.iterations;
    describe(*outcome, ending.status, ending.message.c_str());
    return AWD_SUCCESS;
  } catch (const Cancelled&) {
    describe(*outcome, AWD_REFIT_FAILED, "cancelled by the host");
    return AWD_ERROR_CANCELLED;
  } catch (const std::bad_alloc&) {
    describe(*outcome, AWD_REFIT_FAILED, "out of memory");
    return AWD_ERROR_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    describe(*outcome, AWD_REFIT_FAILED, error.what());
    return AWD_SUCCESS;
  } catch (...) {
    describe(*outcome, AWD_REFIT_FAILED, "an exception of unknown kind");
    return AWD_SUCCESS;
  }
}

}  // namespace awd

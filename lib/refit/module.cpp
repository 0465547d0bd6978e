// SPDX-License-Identifier: Apache-2.0
// The module's table: the one thing that it exports.
#include "refit/ceres_solver.h"
#include "refit/descent.h"
#include "refit/refit_module.h"

namespace {

const AWDRefitSolver kDescent = {
    sizeof(AWDRefitSolver), "descent", "projected coordinate descent with Newton steps, exact",
    [](const AWDRefitProblem* problem, double* solution, AWDRefitOutcome* outcome) {
      return awd::solveBy(awd::minimiseByDescent, problem, solution, outcome);
    }};

const AWDRefitSolver kCeres = {
    sizeof(AWDRefitSolver), "ceres", "trust region of Ceres Solver, bounds held in turns",
    [](const AWDRefitProblem* problem, double* solution, AWDRefitOutcome* outcome) {
      return awd::solveBy(awd::minimiseByCeres, problem, solution, outcome);
    }};

const AWDRefitSolver* const kSolvers[] = {&kDescent, &kCeres};

const AWDRefitModule kModule = {sizeof(AWDRefitModule), AWD_REFIT_ABI, 2, kSolvers};

}  // namespace

extern "C" AWD_EXPORT const AWDRefitModule* AWD_REFIT_ENTRY(void) { return &kModule; }

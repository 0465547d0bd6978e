/* SPDX-License-Identifier: Apache-2.0
 *
 * What libawd and its refit module say to each other. The module is a file of its own, loaded when
 * the estimator `refit` is asked for, so that nobody else carries Ceres.
 *
 * A problem: minimise Q(c) = c' A c / 2 - b' c over c >= lower, A symmetric and positive definite,
 * sparse. The caller has scaled it so that the diagonal of A and the unknowns are about 1 unless
 * the samples say otherwise.
 */
#ifndef AWD_REFIT_MODULE_H
#define AWD_REFIT_MODULE_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bumped when a module compiled for the former one would break; part of the entry's name. */
#define AWD_REFIT_ABI 1u
#define AWD_REFIT_ENTRY awdRefitModule_v1
#define AWD_REFIT_FILE "refit-1.so"

typedef struct AWDRefitProblem {
  size_t structSize;
  uint64_t unknowns;        /* n, 1 to 2^31 - 1 */
  const uint64_t* rowBegin; /* n + 1; row j of A has the entries rowBegin[j] .. rowBegin[j + 1] */
  const uint32_t* columns;  /* ascending in each row, the diagonal among them; both halves of A */
  const double* values;
  const double* rhs;   /* b */
  const double* lower; /* bound of each unknown; finite */
  const double* start; /* a guess at c, not below the bounds */
  /* fraction is an estimate, 0 to 1. Returns 0 if the host wants no more. May be NULL. */
  int32_t (*progress)(void* user, double fraction);
  void* user;
} AWDRefitProblem;

typedef struct AWDRefitOutcome {
  size_t structSize;
  AWDRefitStatus status;
  uint32_t iterations; /* of the solver: sweeps, or trust-region steps */
  uint64_t atBound;    /* unknowns that the bounds hold */
  char message[192];   /* the solver's own account in one line, ended by 0 */
} AWDRefitOutcome;

typedef struct AWDRefitSolver {
  size_t structSize;
  const char* name;
  const char* summary;
  /* Writes the solution and the outcome. A problem that is not as described above, such as one with
     a NaN, is refused with AWD_REFIT_FAILED and a message; whenever the status is neither converged
     nor limit the solution is the start. Returns AWD_SUCCESS, AWD_ERROR_CANCELLED or
     AWD_ERROR_OUT_OF_MEMORY. Prints nothing. Free. */
  AWDResult (*solve)(const AWDRefitProblem* problem, double* solution, AWDRefitOutcome* outcome);
} AWDRefitSolver;

typedef struct AWDRefitModule {
  size_t structSize;
  uint32_t abi; /* AWD_REFIT_ABI */
  uint32_t solverCount;
  const AWDRefitSolver* const* solvers; /* the first one is the default */
} AWDRefitModule;

typedef const AWDRefitModule* (*AWDRefitModuleFn)(void);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: Apache-2.0
 *
 * Integrates a function of 1 to 6 variables over a box by Monte Carlo, with densities that libawd
 * learns from the function itself. README.md tells the method.
 */
#ifndef INTEGRATE_H
#define INTEGRATE_H

#include "awd/awd.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The smallest budget. */
#define INTEGRATE_LEAST_EVALUATIONS 256u

/* f(x); x has as many numbers as the box has dimensions. */
typedef double (*Integrand)(void* user, const double* x);

typedef struct IntegrateProgress {
  double fraction;      /* of the budget: an upper bound, since the goal may be met before */
  uint64_t evaluations; /* so far */
  double value, error;  /* of the last round; the error is infinite before there was one */
} IntegrateProgress;

/* Returns nonzero to go on and 0 to stop. Called every few hundred evaluations. */
typedef int (*IntegrateProgressFn)(void* user, const IntegrateProgress* progress);

typedef struct IntegrateOptions {
  /* Goals: enough when the reported error is at most absoluteError, or relativeError times the
     value. Both 0: spend the whole budget in one round, which makes the most of it. */
  double absoluteError, relativeError;
  uint64_t evaluations;         /* the budget, never exceeded */
  uint64_t seed;                /* same seed, same bits */
  IntegrateProgressFn progress; /* NULL: none */
  void* progressUser;
} IntegrateOptions;

#ifdef __cplusplus
#define INTEGRATE_OPTIONS_INIT                                                                     \
  IntegrateOptions { 0.0, 0.0, 100000u, 1u, nullptr, nullptr }
#else
#define INTEGRATE_OPTIONS_INIT                                                                     \
  { 0.0, 0.0, 100000u, 1u, NULL, NULL }
#endif

typedef enum IntegrateStatus {
  INTEGRATE_DONE = 0,      /* the goal is met, or there was none and the budget is spent */
  INTEGRATE_NOT_MET = 1,   /* the budget is spent and the goal isn't met; the result stands */
  INTEGRATE_CANCELLED = 2, /* by the progress callback; the result is that of the last round */
  INTEGRATE_INVALID = -1,  /* a wrong argument; nothing was evaluated */
  INTEGRATE_FAILED = -2    /* out of memory, or libawd failed */
} IntegrateStatus;

typedef struct IntegrateResult {
  double value;
  double error;         /* one standard deviation; infinite before the first round is done */
  uint64_t evaluations; /* of f, all included */
  uint64_t nonFinite;   /* of these gave NaN or infinity, and were taken as 0 */
  uint32_t rounds;      /* the value and error are those of the last one */
  uint32_t passes;      /* over the box, in all rounds */
  /* The sampling of the last round: level of the learned density of each axis, boxes that were
     given samples by their deviation, and the cells of 4 samples that these were cut into. */
  uint32_t levels[AWD_MAX_DIMENSIONS];
  uint64_t strata, cells;
  char message[256]; /* why the status is negative; else "" */
} IntegrateResult;

/* Integrates f over the box from lower to upper, `dimensions` finite numbers each. options NULL:
   the defaults above. Runs in the calling thread; several may integrate on one device. */
IntegrateStatus integrate(AWDDevice device, Integrand f, void* user, uint32_t dimensions,
                          const double* lower, const double* upper, const IntegrateOptions* options,
                          IntegrateResult* result);

#ifdef __cplusplus
}
#endif
#endif

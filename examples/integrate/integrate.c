/* SPDX-License-Identifier: Apache-2.0 */
#include "integrate.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "strata.h"
#include "warp.h"

/* Samples of a cell: two antithetic pairs. In a pair what is odd about the cell's centre cancels;
   the difference of the two pairs tells the error without bias. */
#define CELL_SAMPLES 4
#define BATCH_CELLS 64
#define BATCH (CELL_SAMPLES * BATCH_CELLS)

/* Shares of a round: passes that learn the warp, growing 1 : 2 : 3 : 4; then one whose samples
   build the strata. The rest goes to the final pass, which alone is the estimate: its densities
   and strata don't depend on it, so it has no bias. */
static const double kWarpShare = 0.2, kSurveyShare = 0.25;
static const int kWarpPasses = 4;
static const uint64_t kMostKept = (uint64_t)1 << 20; /* samples of a pass that are stored */

static const uint64_t kFirstRound = 8192;
static const double kLeastGrowth = 2.0, kMostGrowth = 16.0;
static const int kMostExponent = 1000;

typedef struct Estimate {
  double mean, variance;
} Estimate;

/* A call of integrate(). */
typedef struct Integration {
  AWDDevice device;
  Integrand f;
  void* user;
  uint32_t dimensions;
  double lower[AWD_MAX_DIMENSIONS], upper[AWD_MAX_DIMENSIONS], width[AWD_MAX_DIMENSIONS];
  double volume;
  IntegrateOptions options;
  IntegrateResult* result;
  IntegrateStatus status;

  Warp warp;
  Strata strata;
  Random random;
  int exponent; /* values are taken times 2^exponent, to be near 1: their squares must not overflow
                 */

  int keep;     /* whether this pass's samples are stored */
  double* rows; /* dimensions + 1 numbers a sample: the uniforms, and f / p */
  double* work;
  size_t rowCount;

  Estimate sum; /* of the pass at work */
  size_t batchCells;
  double cellVolumes[BATCH_CELLS];
  double uniforms[AWD_MAX_DIMENSIONS][BATCH], points[AWD_MAX_DIMENSIONS][BATCH];
  double pdfs[AWD_MAX_DIMENSIONS][BATCH], values[BATCH];
} Integration;

/* Gives up; 0, for functions that return whether to go on. */
static int stop(Integration* run, IntegrateStatus status, const char* format, ...) {
  va_list arguments;
  run->status = status;
  va_start(arguments, format);
  vsnprintf(run->result->message, sizeof run->result->message, format, arguments);
  va_end(arguments);
  return 0;
}

static int check(Integration* run, AWDResult result) {
  return result == AWD_SUCCESS ? 1 : stop(run, INTEGRATE_FAILED, "%s", awdGetLastErrorMessage());
}

static int reportProgress(Integration* run) {
  IntegrateProgress progress;
  if (!run->options.progress) return 1;
  progress.evaluations = run->result->evaluations;
  progress.fraction = (double)progress.evaluations / (double)run->options.evaluations;
  progress.value = run->result->value;
  progress.error = run->result->error;
  return run->options.progress(run->options.progressUser, &progress) ||
         stop(run, INTEGRATE_CANCELLED, "%s", "");
}

/* f / p at sample i of the batch. */
static double evaluate(Integration* run, size_t i) {
  double x[AWD_MAX_DIMENSIONS], pdf = 1.0, value;
  uint32_t a;
  for (a = 0; a < run->dimensions; ++a) {
    /* Rounding must not lead out of the box. */
    x[a] = fmin(run->lower[a] + run->width[a] * run->points[a][i], run->upper[a]);
    pdf *= run->pdfs[a][i];
  }
  ++run->result->evaluations;
  /* What overflows when scaled to other values counts as infinite. */
  value = ldexp(run->f(run->user, x), run->exponent) / pdf;
  if (isfinite(value)) return value;
  ++run->result->nonFinite;
  return 0.0;
}

static void keepRow(Integration* run, size_t i) {
  double* row = run->rows + run->rowCount++ * (run->dimensions + 1);
  uint32_t a;
  for (a = 0; a < run->dimensions; ++a) row[a] = run->uniforms[a][i];
  row[run->dimensions] = run->values[i];
}

static int flushBatch(Integration* run) {
  const size_t count = run->batchCells * CELL_SAMPLES;
  size_t i, c;
  uint32_t a;
  if (count == 0) return 1;
  for (a = 0; a < run->dimensions; ++a) {
    if (!check(run, awdSampleDensity(run->warp.axes[a], count, run->uniforms[a], run->points[a],
                                     run->pdfs[a], NULL))) {
      return 0;
    }
  }
  for (i = 0; i < count; ++i) {
    run->values[i] = evaluate(run, i);
    if (run->keep) keepRow(run, i);
  }
  for (c = 0; c < run->batchCells; ++c) {
    const double* v = run->values + c * CELL_SAMPLES;
    const double first = 0.5 * (v[0] + v[1]), second = 0.5 * (v[2] + v[3]);
    const double error = 0.5 * (first - second) * run->cellVolumes[c];
    run->sum.mean += 0.5 * (first + second) * run->cellVolumes[c];
    run->sum.variance += error * error;
  }
  run->batchCells = 0;
  return reportProgress(run);
}

/* Draws the samples of a cell. */
static int addCell(void* user, const Box* cell, double volume) {
  Integration* run = user;
  const size_t first = run->batchCells * CELL_SAMPLES;
  size_t i;
  uint32_t a;
  for (i = first; i < first + CELL_SAMPLES; i += 2) {
    for (a = 0; a < run->dimensions; ++a) {
      const double lower = cell->lower[a], upper = cell->upper[a];
      const double u = lower + (upper - lower) * nextUniform(&run->random);
      run->uniforms[a][i] = fmin(u, 1.0 - 0x1p-53);
      run->uniforms[a][i + 1] = fmin(fmax(lower, lower + upper - u), 1.0 - 0x1p-53);
    }
  }
  run->cellVolumes[run->batchCells++] = volume;
  return run->batchCells < BATCH_CELLS || flushBatch(run);
}

static void beginPass(Integration* run, int keep) {
  ++run->result->passes;
  run->keep = keep;
  run->sum.mean = run->sum.variance = 0.0;
  run->batchCells = 0;
  if (keep) run->rowCount = 0;
}

/* Brings the largest stored value near 1, and later values with it. */
static void rescale(Integration* run) {
  const size_t columns = run->dimensions + 1;
  double most = 0.0;
  int shift;
  size_t i;
  for (i = 0; i < run->rowCount; ++i) {
    most = fmax(most, fabs(run->rows[i * columns + run->dimensions]));
  }
  if (!(most > 0.0) || !isfinite(most)) return;
  shift = -ilogb(most);
  if (run->exponent + shift > kMostExponent) shift = kMostExponent - run->exponent;
  if (run->exponent + shift < -kMostExponent) shift = -kMostExponent - run->exponent;
  run->exponent += shift;
  for (i = 0; i < run->rowCount; ++i) {
    double* value = &run->rows[i * columns + run->dimensions];
    *value = ldexp(*value, shift);
  }
}

/* A pass of about `samples` over equal cells of the unit cube, its samples stored. */
static int storedPass(Integration* run, double samples) {
  const uint64_t cells = (uint64_t)fmin(samples, (double)kMostKept) / CELL_SAMPLES;
  Box box;
  if (cells == 0) return 1;
  makeUnitBox(&box);
  beginPass(run, 1);
  if (!divideBox(&box, run->dimensions, 1.0, cells, &run->random, addCell, run) ||
      !flushBatch(run)) {
    return 0;
  }
  rescale(run);
  return 1;
}

static int learn(Integration* run, uint64_t evaluations) {
  const double whole = kWarpShare * (double)evaluations;
  int k;
  for (k = 1; k <= kWarpPasses; ++k) {
    if (!storedPass(run, whole * (2.0 * k / (kWarpPasses * (kWarpPasses + 1)))) ||
        !check(run, learnWarp(&run->warp, run->rows, run->rowCount, run->work))) {
      return 0;
    }
  }
  return storedPass(run, kSurveyShare * (double)evaluations);
}

static int finalPass(Integration* run, uint64_t evaluations) {
  const uint64_t cells = evaluations / CELL_SAMPLES;
  IntegrateResult* result = run->result;
  size_t i;
  if (!buildStrata(&run->strata, run->dimensions, run->rows, run->rowCount, &run->random)) {
    return stop(run, INTEGRATE_FAILED, "out of memory");
  }
  shareCells(&run->strata, cells);
  beginPass(run, 0);
  result->strata = run->strata.count;
  result->cells = 0;
  memcpy(result->levels, run->warp.levels, sizeof result->levels);
  for (i = 0; i < run->strata.count; ++i) {
    Stratum* s = &run->strata.items[i];
    result->cells += s->cells;
    if (!divideBox(&s->box, run->dimensions, s->volume, s->cells, &run->random, addCell, run)) {
      return 0;
    }
  }
  return flushBatch(run);
}

/* Spends about `evaluations`, never more. A cancelled round leaves the last one's result. */
static int playRound(Integration* run, uint64_t evaluations) {
  IntegrateResult* result = run->result;
  const uint64_t before = result->evaluations;
  if (!learn(run, evaluations) || !finalPass(run, evaluations - (result->evaluations - before))) {
    return 0;
  }
  ++result->rounds;
  result->value = ldexp(run->sum.mean, -run->exponent) * run->volume;
  result->error = ldexp(sqrt(run->sum.variance), -run->exponent) * run->volume;
  return 1;
}

static double goalOf(const Integration* run) {
  return fmax(run->options.absoluteError, run->options.relativeError * fabs(run->result->value));
}

/* Rounds, each so large that it should meet the goal if errors fall with N^(-3/4): what strata do
   for a function that jumps. */
static void play(Integration* run) {
  const uint64_t budget = run->options.evaluations;
  const int goal = run->options.absoluteError > 0.0 || run->options.relativeError > 0.0;
  const IntegrateResult* result = run->result;
  uint64_t next = goal && kFirstRound < budget ? kFirstRound : budget;
  while (playRound(run, next)) {
    const uint64_t left = budget - result->evaluations;
    double growth;
    run->status = !goal || result->error <= goalOf(run) ? INTEGRATE_DONE : INTEGRATE_NOT_MET;
    if (run->status == INTEGRATE_DONE || left < next) return;
    growth = pow(1.1 * result->error / goalOf(run), 4.0 / 3.0);
    growth = fmin(fmax(growth, kLeastGrowth), kMostGrowth);
    next = growth * (double)next < (double)left ? (uint64_t)(growth * (double)next) : left;
  }
}

/* --- arguments ------------------------------------------------------------------------------ */

static int checkBox(Integration* run, const double* lower, const double* upper) {
  uint32_t a;
  run->volume = 1.0;
  for (a = 0; a < run->dimensions; ++a) {
    if (!isfinite(lower[a]) || !isfinite(upper[a]) || !(lower[a] < upper[a])) {
      return stop(run, INTEGRATE_INVALID,
                  "axis %u goes from %g to %g: give two finite numbers, the smaller first", a,
                  lower[a], upper[a]);
    }
    run->lower[a] = lower[a];
    run->upper[a] = upper[a];
    run->width[a] = upper[a] - lower[a];
    run->volume *= run->width[a];
  }
  if (!isfinite(run->volume) || !(run->volume > 0.0)) {
    return stop(run, INTEGRATE_INVALID, "the volume of the box is %g: scale the variables",
                run->volume);
  }
  return 1;
}

static int checkArguments(Integration* run, const double* lower, const double* upper) {
  const IntegrateOptions* options = &run->options;
  if (run->dimensions < 1 || run->dimensions > AWD_MAX_DIMENSIONS) {
    return stop(run, INTEGRATE_INVALID, "dimensions is %u: give 1 to %u", run->dimensions,
                AWD_MAX_DIMENSIONS);
  }
  if (!run->device) return stop(run, INTEGRATE_INVALID, "device is NULL");
  if (!run->f) return stop(run, INTEGRATE_INVALID, "f is NULL");
  if (!lower || !upper) return stop(run, INTEGRATE_INVALID, "lower or upper is NULL");
  if (!(options->absoluteError >= 0.0) || !(options->relativeError >= 0.0)) {
    return stop(run, INTEGRATE_INVALID, "the goals are %g and %g: give errors from 0 up",
                options->absoluteError, options->relativeError);
  }
  if (options->evaluations < INTEGRATE_LEAST_EVALUATIONS) {
    return stop(run, INTEGRATE_INVALID, "evaluations is %llu: give at least %u",
                (unsigned long long)options->evaluations, INTEGRATE_LEAST_EVALUATIONS);
  }
  return checkBox(run, lower, upper);
}

static int allocate(Integration* run) {
  /* No stored pass takes more than kSurveyShare of the budget. */
  const double most =
      fmin(kSurveyShare * (double)run->options.evaluations, (double)kMostKept) + CELL_SAMPLES;
  run->rows = malloc((size_t)most * (run->dimensions + 1) * sizeof *run->rows);
  run->work = malloc((size_t)most * 4 * sizeof *run->work);
  return (run->rows && run->work) || stop(run, INTEGRATE_FAILED, "out of memory");
}

IntegrateStatus integrate(AWDDevice device, Integrand f, void* user, uint32_t dimensions,
                          const double* lower, const double* upper, const IntegrateOptions* options,
                          IntegrateResult* result) {
  const IntegrateOptions defaults = INTEGRATE_OPTIONS_INIT;
  IntegrateStatus status = INTEGRATE_FAILED;
  Integration* run;
  memset(result, 0, sizeof *result);
  result->error = HUGE_VAL;
  run = calloc(1, sizeof *run);
  if (!run) {
    snprintf(result->message, sizeof result->message, "out of memory");
    return status;
  }
  run->device = device;
  run->f = f;
  run->user = user;
  run->dimensions = dimensions;
  run->options = options ? *options : defaults;
  seedRandom(&run->random, run->options.seed);
  run->result = result;
  if (checkArguments(run, lower, upper)) {
    if (check(run, makeWarp(&run->warp, device, dimensions)) && allocate(run)) play(run);
    releaseWarp(&run->warp);
  }
  status = run->status;
  releaseStrata(&run->strata);
  free(run->rows);
  free(run->work);
  free(run);
  return status;
}

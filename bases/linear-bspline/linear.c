/* SPDX-License-Identifier: Apache-2.0
 *
 * Linear B-splines, clamped and periodic. README.md has the formulas.
 */
#include "../bspline.h"

enum { kDegree = 1 };

/* On both: functions c and c + 1 are alive on cell c. */
static uint32_t AWD_CALL eval(uint32_t level, double x, uint32_t* first, double* values) {
  double t;
  *first = bsplineLocate(level, x, &t);
  values[0] = 1.0 - t;
  values[1] = t;
  return 2;
}

/* --- clamped ---------------------------------------------------------------------------------- */

static uint32_t AWD_CALL count(uint32_t level) { return bsplineCells(level) + kDegree; }

static void AWD_CALL support(uint32_t level, uint32_t j, double ab[2]) {
  clampedSupport(level, kDegree, j, ab);
}

static double AWD_CALL weight(uint32_t level, uint32_t j) {
  return clampedWeight(level, kDegree, j);
}

static double AWD_CALL sample(uint32_t level, uint32_t j, const double* u) {
  return clampedSample(level, kDegree, j, u);
}

/* 1/2 1 1/2 at 2j - 1 to 2j + 1, cut at both ends */
static uint32_t AWD_CALL twoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  uint32_t size = 0;
  *first = j > 0 ? 2 * j - 1 : 0;
  if (j > 0) h[size++] = 0.5;
  h[size++] = 1.0;
  if (j < bsplineCells(level)) h[size++] = 0.5;
  return size;
}

/* --- periodic --------------------------------------------------------------------------------- */

static void AWD_CALL supportAround(uint32_t level, uint32_t j, double ab[2]) {
  periodicSupport(level, kDegree, j, ab);
}

static double AWD_CALL weightAround(uint32_t level, uint32_t j) {
  (void)j;
  return periodicWeight(level);
}

static double AWD_CALL sampleAround(uint32_t level, uint32_t j, const double* u) {
  return periodicSample(level, kDegree, j, u);
}

static uint32_t AWD_CALL twoScaleAround(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  *first = j > 0 ? 2 * j - 1 : bsplineCells(level + 1) - 1;
  h[0] = 0.5;
  h[1] = 1.0;
  h[2] = 0.5;
  return 3;
}

static const AWDBasisFamily clamped = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "linear-bspline",
    .summary = "Piecewise linear and continuous on 2^level cells",
    .order = kDegree + 1,
    .sampleDims = kDegree + 1,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = count,
    .cells = bsplineCells,
    .support = support,
    .weight = weight,
    .eval = eval,
    .sample = sample,
    .twoScale = twoScale,
};

static const AWDBasisFamily periodic = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "linear-bspline-periodic",
    .summary = "Piecewise linear and continuous around a circle",
    .flags = AWD_BASIS_PERIODIC,
    .order = kDegree + 1,
    .sampleDims = kDegree + 1,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = bsplineCells,
    .cells = bsplineCells,
    .support = supportAround,
    .weight = weightAround,
    .eval = eval,
    .sample = sampleAround,
    .twoScale = twoScaleAround,
};

static const AWDBasisFamily* const families[] = {&clamped, &periodic};

static const AWDBasisModule module = {
    .structSize = sizeof(AWDBasisModule),
    .abi = AWD_BASIS_ABI,
    .familyCount = 2,
    .version = "0.1.0",
    .license = "Apache-2.0",
    .families = families,
};

AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host) {
  return host->abi == AWD_BASIS_ABI ? &module : NULL;
}

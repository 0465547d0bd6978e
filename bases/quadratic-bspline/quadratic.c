/* SPDX-License-Identifier: Apache-2.0
 *
 * Quadratic B-splines, clamped and periodic. README.md has the formulas.
 */
#include "../bspline.h"

enum { kDegree = 2 };

/* The three functions alive on a cell. A clamped end doubles the outermost; as a sum of
   non-negative terms the one in the middle loses nothing to rounding. */
static uint32_t pieces(double t, double left, double right, double* values) {
  const double s = 1.0 - t;
  values[0] = left * s * s;
  values[1] = (1.0 - left) * s * s + 2.0 * s * t + (1.0 - right) * t * t;
  values[2] = right * t * t;
  return 3;
}

/* --- clamped ---------------------------------------------------------------------------------- */

static uint32_t AWD_CALL count(uint32_t level) { return bsplineCells(level) + kDegree; }

static void AWD_CALL support(uint32_t level, uint32_t j, double ab[2]) {
  clampedSupport(level, kDegree, j, ab);
}

static double AWD_CALL weight(uint32_t level, uint32_t j) {
  return clampedWeight(level, kDegree, j);
}

static uint32_t AWD_CALL eval(uint32_t level, double x, uint32_t* first, double* values) {
  double t;
  const uint32_t cell = bsplineLocate(level, x, &t);
  *first = cell;
  return pieces(t, cell == 0 ? 1.0 : 0.5, cell + 1 == bsplineCells(level) ? 1.0 : 0.5, values);
}

static double AWD_CALL sample(uint32_t level, uint32_t j, const double* u) {
  return clampedSample(level, kDegree, j, u);
}

/* Share of N_j in N'_k, k = 2j - 2 to 2j + 1: inserting the middles of cells as knots. */
static double share(uint32_t level, uint32_t j, uint32_t k) {
  const uint32_t last = count(level) - 1, fineLast = count(level + 1) - 1;
  if (k == 0 || k == fineLast) return j == 0 || j == last ? 1.0 : 0.0;
  if (k == 1 || k + 1 == fineLast) return 0.5;
  return k + 2 == 2 * j || k == 2 * j + 1 ? 0.25 : 0.75;
}

static uint32_t AWD_CALL twoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  const uint32_t fineLast = count(level + 1) - 1;
  uint32_t k, size = 0;
  for (k = j > 0 ? 2 * j - 2 : 0; k <= 2 * j + 1 && k <= fineLast; ++k) {
    const double value = share(level, j, k);
    if (value == 0.0) continue;
    if (size == 0) *first = k;
    h[size++] = value;
  }
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

static uint32_t AWD_CALL evalAround(uint32_t level, double x, uint32_t* first, double* values) {
  double t;
  *first = bsplineLocate(level, x, &t);
  return pieces(t, 0.5, 0.5, values);
}

static double AWD_CALL sampleAround(uint32_t level, uint32_t j, const double* u) {
  return periodicSample(level, kDegree, j, u);
}

static uint32_t AWD_CALL twoScaleAround(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  const uint32_t fine = bsplineCells(level + 1);
  *first = (2 * j + fine - 2) % fine;
  h[0] = 0.25;
  h[1] = 0.75;
  h[2] = 0.75;
  h[3] = 0.25;
  return 4;
}

static const AWDBasisFamily clamped = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "quadratic-bspline",
    .summary = "Piecewise quadratic and smooth on 2^level cells",
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
    .name = "quadratic-bspline-periodic",
    .summary = "Piecewise quadratic and smooth around a circle",
    .flags = AWD_BASIS_PERIODIC,
    .order = kDegree + 1,
    .sampleDims = kDegree + 1,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = bsplineCells,
    .cells = bsplineCells,
    .support = supportAround,
    .weight = weightAround,
    .eval = evalAround,
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

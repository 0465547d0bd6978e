/* SPDX-License-Identifier: Apache-2.0
 *
 * Uniform B-splines of degree q on 2^level cells, written out from their formulas. A clamped axis
 * has the knots t_i = clamp(i - q, 0, cells) h and 2^level + q functions; on a periodic one
 * function j lives on the cells from j - 1 on.
 */
#include "honest.h"

static uint32_t AWD_CALL cells(uint32_t level) { return (uint32_t)1 << level; }

/* Place on the grid: cell, and t within it. */
static uint32_t locate(uint32_t level, double x, double* t) {
  const double scaled = x * cells(level);
  uint32_t cell = (uint32_t)scaled;
  if (cell >= cells(level)) cell = cells(level) - 1;
  *t = scaled - cell;
  return cell;
}

/* Knot i of a clamped spline of degree q, in cells. */
static double knot(uint32_t level, uint32_t q, uint32_t i) {
  const double n = cells(level), t = (double)i - q;
  return t < 0.0 ? 0.0 : t > n ? n : t;
}

/* Curry and Schoenberg: gaps between knots times sorted uniforms. */
static double clampedSample(uint32_t level, uint32_t q, uint32_t j, const double* u) {
  double v[3], x = knot(level, q, j);
  uint32_t i, k;
  for (i = 0; i <= q; ++i) {
    for (k = i; k > 0 && v[k - 1] < u[i]; --k) v[k] = v[k - 1];
    v[k] = u[i];
  }
  for (i = 0; i <= q; ++i) {
    x += (knot(level, q, j + i + 1) - knot(level, q, j + i)) * v[i];
  }
  return x / cells(level);
}

static double clampedWeight(uint32_t level, uint32_t q, uint32_t j) {
  return (knot(level, q, j + q + 1) - knot(level, q, j)) / (q + 1) / cells(level);
}

static void clampedSupport(uint32_t level, uint32_t q, uint32_t j, double ab[2]) {
  ab[0] = knot(level, q, j) / cells(level);
  ab[1] = knot(level, q, j + q + 1) / cells(level);
}

/* --- linear, clamped -------------------------------------------------------------------------- */

static uint32_t AWD_CALL linearCount(uint32_t level) { return cells(level) + 1; }
static void AWD_CALL linearSupport(uint32_t level, uint32_t j, double ab[2]) {
  clampedSupport(level, 1, j, ab);
}
static double AWD_CALL linearWeight(uint32_t level, uint32_t j) {
  return clampedWeight(level, 1, j);
}
static uint32_t AWD_CALL linearEval(uint32_t level, double x, uint32_t* first, double* values) {
  double t;
  *first = locate(level, x, &t);
  values[0] = 1.0 - t;
  values[1] = t;
  return 2;
}
static double AWD_CALL linearSample(uint32_t level, uint32_t j, const double* u) {
  return clampedSample(level, 1, j, u);
}
/* 1/2 1 1/2 at 2j-1 .. 2j+1, cut at both ends */
static uint32_t AWD_CALL linearTwoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  uint32_t size = 0;
  *first = j > 0 ? 2 * j - 1 : 0;
  if (j > 0) h[size++] = 0.5;
  h[size++] = 1.0;
  if (j < cells(level)) h[size++] = 0.5;
  return size;
}

/* --- linear, periodic: the peak of function j is at knot j ------------------------------------ */

static void AWD_CALL periodicSupport(uint32_t level, uint32_t j, double ab[2]) {
  if (level == 0) { /* both halves on the one cell */
    ab[0] = 0.0;
    ab[1] = 1.0;
    return;
  }
  ab[0] = (double)((j + cells(level) - 1) % cells(level)) / cells(level);
  ab[1] = ab[0] + 2.0 / cells(level);
}
static double AWD_CALL periodicWeight(uint32_t level, uint32_t j) {
  (void)j;
  return 1.0 / cells(level);
}
static double AWD_CALL periodicSample(uint32_t level, uint32_t j, const double* u) {
  const double x = (j + u[0] + u[1] - 1.0) / cells(level);
  return x < 0.0 ? x + 1.0 : x < 1.0 ? x : x - 1.0;
}
static uint32_t AWD_CALL periodicTwoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  *first = j > 0 ? 2 * j - 1 : 2 * cells(level) - 1;
  h[0] = 0.5;
  h[1] = 1.0;
  h[2] = 0.5;
  return 3;
}

/* --- quadratic, clamped ------------------------------------------------------------------------
 */

static uint32_t AWD_CALL quadraticCount(uint32_t level) { return cells(level) + 2; }
static void AWD_CALL quadraticSupport(uint32_t level, uint32_t j, double ab[2]) {
  clampedSupport(level, 2, j, ab);
}
static double AWD_CALL quadraticWeight(uint32_t level, uint32_t j) {
  return clampedWeight(level, 2, j);
}
static uint32_t AWD_CALL quadraticEval(uint32_t level, double x, uint32_t* first, double* values) {
  double t;
  const uint32_t cell = locate(level, x, &t);
  const double left = cell == 0 ? 1.0 : 2.0;
  const double right = cell + 1 == cells(level) ? 1.0 : 2.0;
  *first = cell;
  values[0] = (1.0 - t) * (1.0 - t) / left;
  values[2] = t * t / right;
  values[1] = 1.0 - values[0] - values[2];
  if (values[1] < 0.0) values[1] = 0.0; /* rounding */
  return 3;
}
static double AWD_CALL quadraticSample(uint32_t level, uint32_t j, const double* u) {
  return clampedSample(level, 2, j, u);
}
/* Inside 1/4 3/4 3/4 1/4 at 2j-2 .. 2j+1; other values at the ends, where knots fall together.
   Column by column: what finer function k is made of, from knot insertion. */
static uint32_t AWD_CALL quadraticTwoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  const uint32_t last = quadraticCount(level) - 1, fineLast = quadraticCount(level + 1) - 1;
  uint32_t k, size = 0;
  *first = fineLast;
  for (k = 0; k <= fineLast; ++k) {
    double value = 0.0;
    if (k == 0) {
      value = j == 0 ? 1.0 : 0.0;
    } else if (k == fineLast) {
      value = j == last ? 1.0 : 0.0;
    } else if (k == 1) {
      value = j <= 1 ? 0.5 : 0.0;
    } else if (k + 1 == fineLast) {
      value = j + 1 >= last ? 0.5 : 0.0;
    } else if (k % 2 == 0) { /* k = 2i: 3/4 of i, 1/4 of i + 1 */
      value = j == k / 2 ? 0.75 : j == k / 2 + 1 ? 0.25 : 0.0;
    } else { /* k = 2i + 1: 1/4 of i, 3/4 of i + 1 */
      value = j == k / 2 ? 0.25 : j == k / 2 + 1 ? 0.75 : 0.0;
    }
    if (value == 0.0) continue;
    if (size == 0) *first = k;
    h[size++] = value;
  }
  return size;
}

static const AWDBasisFamily linear = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "test-linear",
    .summary = "Linear B-splines",
    .flags = 0,
    .order = 2,
    .sampleDims = 2,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = linearCount,
    .cells = cells,
    .support = linearSupport,
    .weight = linearWeight,
    .eval = linearEval,
    .sample = linearSample,
    .twoScale = linearTwoScale,
};

static const AWDBasisFamily linearPeriodic = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "test-linear-periodic",
    .summary = "Linear B-splines on a circle",
    .flags = AWD_BASIS_PERIODIC,
    .order = 2,
    .sampleDims = 2,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = cells,
    .cells = cells,
    .support = periodicSupport,
    .weight = periodicWeight,
    .eval = linearEval,
    .sample = periodicSample,
    .twoScale = periodicTwoScale,
};

static const AWDBasisFamily quadratic = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "test-quadratic",
    .summary = "Quadratic B-splines",
    .flags = 0,
    .order = 3,
    .sampleDims = 3,
    .minLevel = 0,
    .maxLevel = 12,
    .count = quadraticCount,
    .cells = cells,
    .support = quadraticSupport,
    .weight = quadraticWeight,
    .eval = quadraticEval,
    .sample = quadraticSample,
    .twoScale = quadraticTwoScale,
};

static const AWDBasisFamily* const families[] = {&linear, &linearPeriodic, &quadratic};

static const AWDBasisModule module = {sizeof(AWDBasisModule), AWD_BASIS_ABI, 3, "1",
                                      "Apache-2.0",           families};

const AWDBasisModule* honestModule(void) { return &module; }

AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host) {
  (void)host;
  return &module;
}

/* SPDX-License-Identifier: Apache-2.0
 *
 * What uniform B-splines of degree q on 2^level cells have in common. A clamped axis has the knots
 * t_i = clamp(i - q, 0, cells) h and 2^level + q functions; on a periodic one, of 2^level, function
 * j lives on the cells j - q to j. On cell c the functions c to c + q are alive.
 */
#ifndef AWD_BASES_BSPLINE_H
#define AWD_BASES_BSPLINE_H

#include "awd/basis.h"

#define BSPLINE_MAX_DEGREE 2

static inline uint32_t AWD_CALL bsplineCells(uint32_t level) { return (uint32_t)1 << level; }

/* Place on the grid: cell, and t within it. */
static inline uint32_t bsplineLocate(uint32_t level, double x, double* t) {
  const double scaled = x * bsplineCells(level);
  uint32_t cell = (uint32_t)scaled;
  if (cell >= bsplineCells(level)) cell = bsplineCells(level) - 1; /* x = 1 is in the last */
  *t = scaled - cell;
  return cell;
}

/* The q + 1 uniforms, descending. */
static inline void bsplineSort(uint32_t q, const double* u, double* v) {
  uint32_t i, k;
  for (i = 0; i <= q; ++i) {
    for (k = i; k > 0 && v[k - 1] < u[i]; --k) v[k] = v[k - 1];
    v[k] = u[i];
  }
}

/* --- clamped ---------------------------------------------------------------------------------- */

/* Knot i, in cells. */
static inline double clampedKnot(uint32_t level, uint32_t q, uint32_t i) {
  const double last = bsplineCells(level), t = (double)i - q;
  return t < 0.0 ? 0.0 : t > last ? last : t;
}

static inline void clampedSupport(uint32_t level, uint32_t q, uint32_t j, double ab[2]) {
  ab[0] = clampedKnot(level, q, j) / bsplineCells(level);
  ab[1] = clampedKnot(level, q, j + q + 1) / bsplineCells(level);
}

static inline double clampedWeight(uint32_t level, uint32_t q, uint32_t j) {
  return (clampedKnot(level, q, j + q + 1) - clampedKnot(level, q, j)) /
         ((q + 1.0) * bsplineCells(level));
}

/* Curry and Schoenberg: gaps between knots times sorted uniforms. */
static inline double clampedSample(uint32_t level, uint32_t q, uint32_t j, const double* u) {
  double v[BSPLINE_MAX_DEGREE + 1], x = clampedKnot(level, q, j);
  uint32_t i;
  bsplineSort(q, u, v);
  for (i = 0; i <= q; ++i) {
    x += (clampedKnot(level, q, j + i + 1) - clampedKnot(level, q, j + i)) * v[i];
  }
  return x / bsplineCells(level);
}

/* --- periodic --------------------------------------------------------------------------------- */

static inline void periodicSupport(uint32_t level, uint32_t q, uint32_t j, double ab[2]) {
  const uint32_t cells = bsplineCells(level);
  if (cells <= q + 1) { /* all around, and repeats add up */
    ab[0] = 0.0;
    ab[1] = 1.0;
    return;
  }
  ab[0] = (double)((j + cells - q) % cells) / cells;
  ab[1] = ab[0] + (q + 1.0) / cells;
}

static inline double periodicWeight(uint32_t level) { return 1.0 / bsplineCells(level); }

/* Gaps of 1 each: the sum of q + 1 uniforms. */
static inline double periodicSample(uint32_t level, uint32_t q, uint32_t j, const double* u) {
  double x = (double)j - q;
  uint32_t i;
  for (i = 0; i <= q; ++i) x += u[i];
  x /= bsplineCells(level);
  while (x < 0.0) x += 1.0;
  return x;
}

#endif

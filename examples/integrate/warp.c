/* SPDX-License-Identifier: Apache-2.0 */
#include "warp.h"

#include <math.h>

/* Coefficients below this share of the mean are raised to it. Where the density says too little,
   a sample weighs up to 1 / kFloor too much on each axis; what it says too much, the strata mend.
 */
static const double kFloor = 0.1;
/* Samples that the coarser level is worth in the cascade, if f / p were constant. */
static const double kShrinkage = 15.0;
static const uint32_t kMostLevel = 6;
static const size_t kSamplesPerCoefficient = 20;

static AWDResult newAxis(const Warp* warp, uint32_t level, double shrinkage, AWDDensity* density) {
  AWDDensityAxis axis = {"linear-bspline", AWD_LEVEL(level), AWD_LEVEL(level)};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 1;
  desc.structure = AWD_STRUCTURE_GRID;
  desc.axes = &axis;
  desc.estimator = AWD_ESTIMATOR_QUASI;
  desc.tau = kFloor;
  desc.shrinkage = shrinkage;
  return awdNewDensity(warp->device, &desc, density);
}

AWDResult makeWarp(Warp* warp, AWDDevice device, uint32_t dimensions) {
  uint32_t a;
  warp->device = device;
  warp->dimensions = dimensions;
  for (a = 0; a < AWD_MAX_DIMENSIONS; ++a) {
    warp->axes[a] = NULL;
    warp->levels[a] = 0;
  }
  for (a = 0; a < dimensions; ++a) {
    const AWDResult result = newAxis(warp, 0, kShrinkage, &warp->axes[a]);
    if (result != AWD_SUCCESS) return result;
  }
  return AWD_SUCCESS;
}

void releaseWarp(Warp* warp) {
  uint32_t a;
  for (a = 0; a < warp->dimensions; ++a) awdReleaseDensity(warp->axes[a]);
}

/* E[v^2] / E[|v|]^2: 1 if |v| is constant, and the less a sample is worth the larger. */
static double scatter(const double* rows, size_t count, size_t columns) {
  double sum = 0.0, squares = 0.0;
  size_t i;
  for (i = 0; i < count; ++i) {
    const double v = rows[i * columns + columns - 1];
    sum += fabs(v);
    squares += v * v;
  }
  return sum > 0.0 ? squares * (double)count / (sum * sum) : 1.0;
}

/* The density of one axis: seen from it, f / p is a sample of the marginal of |f| over the
   marginal of p. */
static AWDResult learnAxis(Warp* warp, uint32_t a, const double* rows, size_t count, uint32_t level,
                           double shrinkage, double* work) {
  const size_t columns = warp->dimensions + 1;
  double *uniforms = work, *points = work + count, *pdfs = work + 2 * count;
  double* values = work + 3 * count;
  AWDDensity next = NULL;
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
  AWDResult result;
  size_t i;
  for (i = 0; i < count; ++i) uniforms[i] = rows[i * columns + a];
  result = awdSampleDensity(warp->axes[a], count, uniforms, points, pdfs, NULL);
  if (result != AWD_SUCCESS) return result;
  for (i = 0; i < count; ++i) values[i] = fabs(rows[i * columns + columns - 1]) * pdfs[i];
  result = newAxis(warp, level, shrinkage, &next);
  if (result == AWD_SUCCESS) {
    result = awdRecordDensity(next, count, points, pdfs, NULL, values);
  }
  if (result == AWD_SUCCESS) result = awdAdaptDensity(next, &report);
  if (result != AWD_SUCCESS || report.kept) {
    awdReleaseDensity(next);
    return result;
  }
  awdReleaseDensity(warp->axes[a]);
  warp->axes[a] = next;
  warp->levels[a] = level;
  return AWD_SUCCESS;
}

AWDResult learnWarp(Warp* warp, const double* rows, size_t count, double* work) {
  const double shrinkage = kShrinkage * scatter(rows, count, warp->dimensions + 1);
  uint32_t level = 0, a;
  while (level < kMostLevel && kSamplesPerCoefficient * (((size_t)2 << level) + 1) <= count) {
    ++level;
  }
  for (a = 0; a < warp->dimensions; ++a) {
    const AWDResult result = learnAxis(warp, a, rows, count, level, shrinkage, work);
    if (result != AWD_SUCCESS) return result;
  }
  return AWD_SUCCESS;
}

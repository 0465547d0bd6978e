/* SPDX-License-Identifier: Apache-2.0
 *
 * Flatlets of two: two boxes a cell, and wavelets with two vanishing moments. README.md has the
 * formulas.
 */
#include "awd/basis.h"

/* Boxes: two in each of 2^level cells. */
static uint32_t AWD_CALL count(uint32_t level) { return (uint32_t)2 << level; }

static void AWD_CALL support(uint32_t level, uint32_t j, double ab[2]) {
  ab[0] = (double)j / count(level);
  ab[1] = (j + 1.0) / count(level);
}

static double AWD_CALL weight(uint32_t level, uint32_t j) {
  (void)j;
  return 1.0 / count(level);
}

static uint32_t AWD_CALL eval(uint32_t level, double x, uint32_t* first, double* values) {
  const uint32_t box = (uint32_t)(x * count(level));
  *first = box < count(level) ? box : count(level) - 1; /* x = 1 is in the last box */
  values[0] = 1.0;
  return 1;
}

static double AWD_CALL sample(uint32_t level, uint32_t j, const double* u) {
  return (j + u[0]) / count(level);
}

static uint32_t AWD_CALL twoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  (void)level;
  *first = 2 * j;
  h[0] = 1.0;
  h[1] = 1.0;
  return 2;
}

static void AWD_CALL wavelet(uint32_t k, double* g) {
  g[0] = -1.0;
  g[1] = k == 0 ? 3.0 : 1.0;
  g[2] = k == 0 ? -3.0 : 1.0;
  g[3] = k == 0 ? 1.0 : -1.0;
}

static const AWDBasisFamily flatlet = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "f2",
    .summary = "Flatlets: two boxes a cell, two vanishing moments",
    .flags = AWD_BASIS_ORTHOGONAL | AWD_BASIS_NESTED,
    .order = 1,
    .sampleDims = 1,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = count,
    .cells = count,
    .support = support,
    .weight = weight,
    .eval = eval,
    .sample = sample,
    .twoScale = twoScale,
    .wavelet = wavelet,
    .vanishingMoments = 2,
};

static const AWDBasisFamily* const families[] = {&flatlet};

static const AWDBasisModule module = {
    .structSize = sizeof(AWDBasisModule),
    .abi = AWD_BASIS_ABI,
    .familyCount = 1,
    .version = "0.1.0",
    .license = "Apache-2.0",
    .families = families,
};

AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host) {
  return host->abi == AWD_BASIS_ABI ? &module : NULL;
}

/* SPDX-License-Identifier: Apache-2.0
 *
 * Plugins that lie: compiled once for each LIE_... of CMakeLists.txt. Without a lie this is an
 * honest basis of box functions, so each is refused for its own lie alone.
 */
#include "awd/basis.h"

#ifdef LIE_ROUNDING /* the truth, but loading it leaves traces, as with -ffast-math */
#include <fenv.h>

static void __attribute__((constructor)) changeRounding(void) { fesetround(FE_UPWARD); }
#endif

#ifndef LIE_NO_ENTRY

#ifdef LIE_FLAGS
#define LEVELS 0 /* two straight lines on one cell, said to be orthogonal */
#elif defined(LIE_MIDDLE)
#define LEVELS 16
#else
#define LEVELS 8
#endif

static double cellsOf(uint32_t level) { return (double)((uint32_t)1 << level); }

static uint32_t AWD_CALL cells(uint32_t level) { return (uint32_t)1 << level; }

static uint32_t AWD_CALL count(uint32_t level) {
#if defined(LIE_COUNT)
  return level == 3 ? 0xFFFFFFFFu : cells(level);
#elif defined(LIE_FLAGS)
  return 2 * cells(level);
#else
  return cells(level);
#endif
}

static void AWD_CALL support(uint32_t level, uint32_t j, double ab[2]) {
#if defined(LIE_FLAGS)
  (void)j;
  ab[0] = 0.0;
  ab[1] = 1.0 / cellsOf(level);
#elif defined(LIE_SUPPORT)
  ab[0] = level > 1 && j > 0 ? (j - 1.0) / cellsOf(level) : j / cellsOf(level);
  ab[1] = (j + 1.0) / cellsOf(level);
#else
  ab[0] = j / cellsOf(level);
  ab[1] = (j + 1.0) / cellsOf(level);
#endif
}

static double AWD_CALL weight(uint32_t level, uint32_t j) {
  (void)j;
#if defined(LIE_WEIGHT)
  return level == 1 && j == 0 ? 0.50005 : 1.0 / cellsOf(level);
#elif defined(LIE_MIDDLE) /* between the levels that are tested in full and the highest */
  return (level == 9 && j == 1 ? 1.001 : 1.0) / cellsOf(level);
#elif defined(LIE_FLAGS)
  return 0.5 / cellsOf(level);
#else
  return 1.0 / cellsOf(level);
#endif
}

static uint32_t AWD_CALL eval(uint32_t level, double x, uint32_t* first, double* values) {
  uint32_t cell = (uint32_t)(x * cellsOf(level));
  if (cell >= cells(level)) cell = cells(level) - 1;
  *first = cell;
  values[0] = 1.0;
#if defined(LIE_UNITY)
  if (level == 2 && cell == 3) values[0] = 1.0 - 1e-9;
#elif defined(LIE_NEGATIVE)
  if (level == 2 && cell == 3) values[0] = -1e-9;
#elif defined(LIE_NAN)
  if (level == 2 && x == 0.75) values[0] = 0.0 * (1e308 * 10.0);
#elif defined(LIE_INDEX)
  if (x == 1.0) *first = cells(level);
#elif defined(LIE_ALIVE)
  uint32_t k;
  for (k = 0; k < 9; ++k) values[k] = 1.0 / 9;
  return 9;
#elif defined(LIE_POLYNOMIAL)
  if (level == 3 && cell < 2) {
    *first = 0;
    values[1] = x * 4.0;
    values[0] = 1.0 - values[1];
    return 2;
  }
#elif defined(LIE_FLAGS)
  *first = 0;
  values[1] = x;
  values[0] = 1.0 - x;
  return 2;
#endif
  return 1;
}

static double AWD_CALL sample(uint32_t level, uint32_t j, const double* u) {
#if defined(LIE_SAMPLER)
  return (j + u[0] * u[0]) / cellsOf(level);
#elif defined(LIE_SAMPLE_OUTSIDE)
  return (j + 1.001 * u[0]) / cellsOf(level);
#elif defined(LIE_SAMPLE_NAN)
  return u[0] == 0.0 ? 0.0 * (1e308 * 10.0) : (j + u[0]) / cellsOf(level);
#elif defined(LIE_STATE)
  static uint32_t calls = 0;
  return (j + (calls++ % 2 == 0 ? u[0] : 1.0 - u[0])) / cellsOf(level);
#elif defined(LIE_FLAGS)
  const double larger = u[0] > u[1] ? u[0] : u[1];
  return (j == 0 ? 1.0 - larger : larger) / cellsOf(level);
#else
  return (j + u[0]) / cellsOf(level);
#endif
}

#ifdef LIE_NULL_FUNCTION
#define REFINE NULL
#else
#define REFINE refine
static uint32_t AWD_CALL refine(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  (void)level;
  *first = 2 * j;
  h[0] = 1.0;
  h[1] = 1.0;
#if defined(LIE_TWO_SCALE)
  if (level == 4) *first = 2 * j > 0 ? 2 * j - 1 : 0; /* the mass is right, the place is not */
#endif
  return 2;
}
#endif

#if defined(LIE_WAVELET_MASS) || defined(LIE_WAVELET_NAN) || defined(LIE_WAVELET_NONE)
#define WAVELET wavelet
#define MOMENTS 1
static void AWD_CALL wavelet(uint32_t k, double* g) {
  (void)k;
#if defined(LIE_WAVELET_MASS)
  g[0] = 1.0;
  g[1] = -0.5;
#elif defined(LIE_WAVELET_NAN)
  g[0] = 1.0;
  g[1] = 0.0 * (1e308 * 10.0);
#else
  g[0] = g[1] = 0.0;
#endif
}
#else
#define WAVELET NULL
#define MOMENTS 0
#endif

#ifdef LIE_SHORT_STRUCT
#define SIZE (offsetof(AWDBasisFamily, twoScale))
#else
#define SIZE sizeof(AWDBasisFamily)
#endif

#if defined(LIE_NAME)
#define NAME "Bad Name"
#elif defined(LIE_NONE)
#define NAME "truthful"
#else
#define NAME "liar"
#endif

#if defined(LIE_FLAGS)
#define FLAGS AWD_BASIS_ORTHOGONAL
#define ORDER 2
#elif defined(LIE_UNKNOWN_FLAG)
#define FLAGS 0x100u
#define ORDER 1
#elif MOMENTS > 0
#define FLAGS AWD_BASIS_NESTED
#define ORDER 1
#else
#define FLAGS 0
#define ORDER 1
#endif

static const AWDBasisFamily family = {
    .structSize = SIZE,
    .name = NAME,
    .summary = "Box functions, with a lie",
    .flags = FLAGS,
    .order = ORDER,
    .sampleDims = ORDER,
    .minLevel = 0,
    .maxLevel = LEVELS,
    .count = count,
    .cells = cells,
    .support = support,
    .weight = weight,
    .eval = eval,
    .sample = sample,
    .twoScale = REFINE,
    .wavelet = WAVELET,
    .vanishingMoments = MOMENTS,
};

#ifdef LIE_TWICE
static const AWDBasisFamily* const families[] = {&family, &family};
#else
static const AWDBasisFamily* const families[] = {&family};
#endif

#ifdef LIE_ABI
#define ABI (AWD_BASIS_ABI + 6)
#else
#define ABI AWD_BASIS_ABI
#endif

static const AWDBasisModule module = {
    .structSize = sizeof(AWDBasisModule),
    .abi = ABI,
    .familyCount = sizeof families / sizeof families[0],
    .version = "1",
    .license = "Apache-2.0",
    .families = families,
};

#if defined(LIE_NEWER)
#define ENTRY awdBasisModule_v2
AWD_EXPORT const AWDBasisModule* AWD_CALL ENTRY(const AWDBasisHost* host);
#else
#define ENTRY AWD_BASIS_ENTRY
#endif

AWD_EXPORT const AWDBasisModule* AWD_CALL ENTRY(const AWDBasisHost* host) {
  (void)host;
#if defined(LIE_NULL_MODULE)
  return module.abi ? NULL : &module;
#else
  return &module;
#endif
}

#else

AWD_EXPORT int liarWithoutEntry(void);
AWD_EXPORT int liarWithoutEntry(void) { return 1; }

#endif

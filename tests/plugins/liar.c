/* SPDX-License-Identifier: Apache-2.0
 *
 * Plugins that lie: compiled once for each LIE_... of CMakeLists.txt. Without a lie this is an
 * honest basis of box functions, so each is refused for its own lie alone.
 */
#include "awd/basis.h"

#ifndef LIE_NO_ENTRY

#ifdef LIE_FLAGS
#define LEVELS 0 /* two straight lines on one cell, said to be orthogonal */
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
#define twoScale NULL
#else
static uint32_t AWD_CALL twoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
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

#ifdef LIE_SHORT_STRUCT
#define SIZE (sizeof(AWDBasisFamily) - 8)
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
#else
#define FLAGS 0
#define ORDER 1
#endif

static const AWDBasisFamily family = {SIZE,  NAME,    "Box functions, with a lie",
                                      FLAGS, ORDER,   ORDER,
                                      0,     LEVELS,  count,
                                      cells, support, weight,
                                      eval,  sample,  twoScale};

static const AWDBasisFamily* const families[] = {&family};

static const AWDBasisModule module = {sizeof(AWDBasisModule),
#if defined(LIE_ABI)
                                      AWD_BASIS_ABI + 6,
#else
                                      AWD_BASIS_ABI,
#endif
                                      1,
                                      "1",
                                      "Apache-2.0",
                                      families};

AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host) {
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

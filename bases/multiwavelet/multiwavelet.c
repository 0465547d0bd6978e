/* SPDX-License-Identifier: Apache-2.0
 *
 * Alpert's multiwavelets M_2 and M_3: k Bernstein polynomials of degree k - 1 on each dyadic cell,
 * function k c + i on cell c. README.md has the formulas.
 */
#include "awd/basis.h"

static uint32_t AWD_CALL cells(uint32_t level) { return (uint32_t)1 << level; }

static double binomial(uint32_t n, uint32_t i) { /* n <= 2 */
  return n == 2 && i == 1 ? 2.0 : 1.0;
}

/* --- for both orders k ------------------------------------------------------------------------ */

static void supportOf(uint32_t k, uint32_t level, uint32_t j, double ab[2]) {
  const uint32_t cell = j / k;
  ab[0] = (double)cell / cells(level);
  ab[1] = (cell + 1.0) / cells(level);
}

static double weightOf(uint32_t k, uint32_t level) { return 1.0 / ((double)k * cells(level)); }

/* B_i = C(k-1, i) t^i (1-t)^(k-1-i) */
static uint32_t evalOf(uint32_t k, uint32_t level, double x, uint32_t* first, double* values) {
  const double scaled = x * cells(level);
  uint32_t cell = (uint32_t)scaled, i, p;
  double t;
  if (cell >= cells(level)) cell = cells(level) - 1; /* x = 1 is in the last */
  t = scaled - cell;
  for (i = 0; i < k; ++i) {
    values[i] = binomial(k - 1, i);
    for (p = 0; p < k - 1; ++p) values[i] *= p < i ? t : 1.0 - t;
  }
  *first = k * cell;
  return k;
}

/* k B_i is the pdf of the (i+1)-th smallest of k uniforms. */
static double sampleOf(uint32_t k, uint32_t level, uint32_t j, const double* u) {
  double v[3]; /* ascending */
  const uint32_t cell = j / k;
  uint32_t i, p;
  for (i = 0; i < k; ++i) {
    for (p = i; p > 0 && v[p - 1] > u[i]; --p) v[p] = v[p - 1];
    v[p] = u[i];
  }
  return (cell + v[j % k]) / cells(level);
}

/* de Casteljau at 1/2 of the coefficients that are 1 at i, else 0: on the left half
   C(r,i) / 2^r, r = 0 .. k-1, on the right half C(k-1-r, i-r) / 2^(k-1-r) */
static uint32_t twoScaleOf(uint32_t k, uint32_t j, uint32_t* first, double* h) {
  const uint32_t i = j % k, degree = k - 1;
  uint32_t r;
  for (r = 0; r < k; ++r) {
    h[r] = i <= r ? binomial(r, i) / ((uint32_t)1 << r) : 0.0;
    h[k + r] = i >= r ? binomial(degree - r, i - r) / ((uint32_t)1 << (degree - r)) : 0.0;
  }
  *first = 2 * k * (j / k);
  return 2 * k;
}

/* --- k = 2 ------------------------------------------------------------------------------------ */

static uint32_t AWD_CALL count2(uint32_t level) { return 2 * cells(level); }
static void AWD_CALL support2(uint32_t level, uint32_t j, double ab[2]) {
  supportOf(2, level, j, ab);
}
static double AWD_CALL weight2(uint32_t level, uint32_t j) {
  (void)j;
  return weightOf(2, level);
}
static uint32_t AWD_CALL eval2(uint32_t level, double x, uint32_t* first, double* values) {
  return evalOf(2, level, x, first, values);
}
static double AWD_CALL sample2(uint32_t level, uint32_t j, const double* u) {
  return sampleOf(2, level, j, u);
}
static uint32_t AWD_CALL twoScale2(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  (void)level;
  return twoScaleOf(2, j, first, h);
}
static void AWD_CALL wavelet2(uint32_t k, double* g) {
  static const double root3 = 1.7320508075688772935, even[4] = {1.0, -1.0, -1.0, 1.0},
                      odd[4] = {-1.0, 2.0, -2.0, 1.0};
  uint32_t i;
  for (i = 0; i < 4; ++i) g[i] = k == 0 ? root3 * even[i] : odd[i];
}

/* --- k = 3 ------------------------------------------------------------------------------------ */

static uint32_t AWD_CALL count3(uint32_t level) { return 3 * cells(level); }
static void AWD_CALL support3(uint32_t level, uint32_t j, double ab[2]) {
  supportOf(3, level, j, ab);
}
static double AWD_CALL weight3(uint32_t level, uint32_t j) {
  (void)j;
  return weightOf(3, level);
}
static uint32_t AWD_CALL eval3(uint32_t level, double x, uint32_t* first, double* values) {
  return evalOf(3, level, x, first, values);
}
static double AWD_CALL sample3(uint32_t level, uint32_t j, const double* u) {
  return sampleOf(3, level, j, u);
}
static uint32_t AWD_CALL twoScale3(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  (void)level;
  return twoScaleOf(3, j, first, h);
}
static void AWD_CALL wavelet3(uint32_t k, double* g) {
  /* 1/3, sqrt(3)/2, sqrt(5)/6 */
  static const double scale[3] = {0.33333333333333333333, 0.86602540378443864676,
                                  0.37267799624996494940};
  static const double row[3][6] = {{-7.0, 11.0, -1.0, 1.0, -11.0, 7.0},
                                   {2.0, -5.0, 3.0, 3.0, -5.0, 2.0},
                                   {-2.0, 7.0, -8.0, 8.0, -7.0, 2.0}};
  uint32_t i;
  for (i = 0; i < 6; ++i) g[i] = scale[k] * row[k][i];
}

static const AWDBasisFamily m2 = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "m2",
    .summary = "Multiwavelets: linear on each of 2^level cells",
    .flags = AWD_BASIS_NESTED,
    .order = 2,
    .sampleDims = 2,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = count2,
    .cells = cells,
    .support = support2,
    .weight = weight2,
    .eval = eval2,
    .sample = sample2,
    .twoScale = twoScale2,
    .wavelet = wavelet2,
    .vanishingMoments = 2,
};

static const AWDBasisFamily m3 = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "m3",
    .summary = "Multiwavelets: quadratic on each of 2^level cells",
    .flags = AWD_BASIS_NESTED,
    .order = 3,
    .sampleDims = 3,
    .minLevel = 0,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = count3,
    .cells = cells,
    .support = support3,
    .weight = weight3,
    .eval = eval3,
    .sample = sample3,
    .twoScale = twoScale3,
    .wavelet = wavelet3,
    .vanishingMoments = 3,
};

static const AWDBasisFamily* const families[] = {&m2, &m3};

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

/* SPDX-License-Identifier: Apache-2.0
 *
 * Cubic B-splines on n = 2^level equal cells, clamped and periodic, with everything derived from
 * the knots. README.md has the formulas.
 *
 * Lengths are counted in cells here, so knots are whole numbers and differences of them exact.
 * Function j has the knots knot(j) .. knot(j + 4), and on cell c the functions c .. c + 3 are
 * alive. A clamped axis keeps its outer knots at its ends, which is where the n + 3 functions touch
 * on few cells; on a circle knots run on and indices count modulo n.
 */
#include <awd/basis.h>

#define DEGREE 3

typedef double Knots(uint32_t n, int64_t i);

static double clampedKnot(uint32_t n, int64_t i) {
  const int64_t t = i - DEGREE;
  return t < 0 ? 0.0 : t > n ? (double)n : (double)t;
}

static double evenKnot(uint32_t n, int64_t i) {
  (void)n;
  return (double)(i - DEGREE);
}

static uint32_t AWD_CALL cells(uint32_t level) { return (uint32_t)1 << level; }

/* --- what both share ------------------------------------------------------------------------- */

/* Cox and de Boor: the functions of the next degree from those of the last, which are convex
   combinations of non-negative numbers throughout. */
static uint32_t evaluate(Knots* knot, uint32_t n, double x, uint32_t* first, double* values) {
  uint32_t c = (uint32_t)(x * n), degree, i;
  double t;
  if (c >= n) c = n - 1; /* x = 1 is in the last cell */
  t = x * n - c;
  values[0] = 1.0;
  for (degree = 1; degree <= DEGREE; ++degree) {
    double carried = 0.0;
    for (i = 0; i < degree; ++i) {
      /* knots around the cell [c, c + 1], seen from its begin */
      const double right = knot(n, (int64_t)c + DEGREE + 1 + i) - c;
      const double left = knot(n, (int64_t)c + DEGREE + 1 + i - degree) - c;
      const double share = values[i] / (right - left);
      values[i] = carried + (right - t) * share;
      carried = (t - left) * share;
    }
    values[degree] = carried;
  }
  *first = c;
  return DEGREE + 1;
}

/* Curry and Schoenberg: a B-spline over its integral is the distribution of a mean of its knots
   with the gaps between sorted uniforms for weights. */
static double sampleCells(Knots* knot, uint32_t n, uint32_t j, const double* u) {
  double v[DEGREE + 1], x = knot(n, j);
  uint32_t i, k;
  for (i = 0; i <= DEGREE; ++i) { /* descending */
    for (k = i; k > 0 && v[k - 1] < u[i]; --k) v[k] = v[k - 1];
    v[k] = u[i];
  }
  for (i = 0; i <= DEGREE; ++i) x += (knot(n, (int64_t)j + i + 1) - knot(n, (int64_t)j + i)) * v[i];
  return x;
}

/* Oslo algorithm: the share of fine function k in coarse function j, for order functions. With a
   knot in the middle of every cell the fine knots in coarse cells are knot(2n, i) / 2. */
static double share(Knots* knot, uint32_t n, int64_t j, int64_t k, uint32_t order) {
  const double fine = knot(2 * n, k + order - 1) / 2.0;
  double sum = 0.0;
  double begin = knot(n, j), end = knot(n, j + order - 1);
  if (order == 1) return begin <= fine && fine < knot(n, j + 1) ? 1.0 : 0.0;
  if (end > begin) sum += (fine - begin) / (end - begin) * share(knot, n, j, k, order - 1);
  begin = knot(n, j + 1);
  end = knot(n, j + order);
  if (end > begin) sum += (end - fine) / (end - begin) * share(knot, n, j + 1, k, order - 1);
  return sum;
}

/* --- clamped --------------------------------------------------------------------------------- */

static uint32_t AWD_CALL clampedCount(uint32_t level) { return cells(level) + DEGREE; }

static void AWD_CALL clampedSupport(uint32_t level, uint32_t j, double ab[2]) {
  const uint32_t n = cells(level);
  ab[0] = clampedKnot(n, j) / n;
  ab[1] = clampedKnot(n, (int64_t)j + DEGREE + 1) / n;
}

static double AWD_CALL clampedWeight(uint32_t level, uint32_t j) {
  double ab[2];
  clampedSupport(level, j, ab);
  return (ab[1] - ab[0]) / (DEGREE + 1);
}

static uint32_t AWD_CALL clampedEval(uint32_t level, double x, uint32_t* first, double* values) {
  return evaluate(clampedKnot, cells(level), x, first, values);
}

static double AWD_CALL clampedSample(uint32_t level, uint32_t j, const double* u) {
  return sampleCells(clampedKnot, cells(level), j, u) / cells(level);
}

static uint32_t AWD_CALL clampedTwoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  /* Fine functions whose knots lie within those of j: 2j - 3 to 2j + 1, as far as there are. */
  const int64_t last = (int64_t)clampedCount(level + 1) - 1;
  const int64_t begin = 2 * (int64_t)j - DEGREE, end = 2 * (int64_t)j + 1;
  uint32_t size = 0;
  int64_t k;
  *first = (uint32_t)(begin > 0 ? begin : 0);
  for (k = *first; k <= end && k <= last; ++k) {
    h[size++] = share(clampedKnot, cells(level), j, k, DEGREE + 1);
  }
  return size;
}

/* --- periodic -------------------------------------------------------------------------------- */

static void AWD_CALL periodicSupport(uint32_t level, uint32_t j, double ab[2]) {
  const uint32_t n = cells(level);
  ab[0] = 0.0;
  ab[1] = 1.0;
  if (n <= DEGREE + 1) return; /* once round, or more */
  ab[0] = (double)((j + n - DEGREE) % n) / n;
  ab[1] = ab[0] + (DEGREE + 1.0) / n;
}

static double AWD_CALL periodicWeight(uint32_t level, uint32_t j) {
  (void)j;
  return 1.0 / cells(level);
}

static uint32_t AWD_CALL periodicEval(uint32_t level, double x, uint32_t* first, double* values) {
  return evaluate(evenKnot, cells(level), x, first, values);
}

static double AWD_CALL periodicSample(uint32_t level, uint32_t j, const double* u) {
  double x = sampleCells(evenKnot, cells(level), j, u) / cells(level);
  while (x < 0.0) x += 1.0;
  while (x >= 1.0) x -= 1.0;
  return x;
}

static uint32_t AWD_CALL periodicTwoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
  const uint32_t fine = cells(level + 1);
  uint32_t i;
  for (i = 0; i < DEGREE + 2; ++i) {
    h[i] = share(evenKnot, cells(level), j, 2 * (int64_t)j - DEGREE + i, DEGREE + 1);
  }
  *first = (uint32_t)((2 * (int64_t)j - DEGREE + 2 * (int64_t)fine) % fine);
  return DEGREE + 2;
}

/* --------------------------------------------------------------------------------------------- */

static const AWDBasisFamily clamped = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "cubic-bspline",
    .summary = "Cubic B-splines, clamped",
    .order = DEGREE + 1,
    .sampleDims = DEGREE + 1,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = clampedCount,
    .cells = cells,
    .support = clampedSupport,
    .weight = clampedWeight,
    .eval = clampedEval,
    .sample = clampedSample,
    .twoScale = clampedTwoScale,
};

static const AWDBasisFamily periodic = {
    .structSize = sizeof(AWDBasisFamily),
    .name = "cubic-bspline-periodic",
    .summary = "Cubic B-splines on a circle",
    .flags = AWD_BASIS_PERIODIC,
    .order = DEGREE + 1,
    .sampleDims = DEGREE + 1,
    .maxLevel = AWD_BASIS_MAX_LEVEL,
    .count = cells,
    .cells = cells,
    .support = periodicSupport,
    .weight = periodicWeight,
    .eval = periodicEval,
    .sample = periodicSample,
    .twoScale = periodicTwoScale,
};

static const AWDBasisFamily* const families[] = {&clamped, &periodic};

static const AWDBasisModule module = {
    .structSize = sizeof(AWDBasisModule),
    .abi = AWD_BASIS_ABI,
    .familyCount = sizeof families / sizeof families[0],
    .version = "1.0.0",
    .license = "Apache-2.0",
    .families = families,
};

AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host) {
  return host->abi == AWD_BASIS_ABI ? &module : NULL;
}

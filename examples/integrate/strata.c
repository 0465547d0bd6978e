/* SPDX-License-Identifier: Apache-2.0 */
#include "strata.h"

#include <math.h>
#include <stdlib.h>

/* A stratum is halved if it has this many samples at least, and each half this many. */
static const size_t kLeastToSplit = 64, kLeastInHalf = 16;
/* Samples that the deviation of the parent is worth. */
static const double kParentWeight = 4.0;
/* Cells go by volume times deviation^kPower: 1 were best if deviations were known exactly. */
static const double kPower = 0.7;
static const double kShareByVolume = 0.25;

typedef struct Builder {
  Strata* strata;
  uint32_t dimensions;
  double* rows;
  Random* random;
} Builder;

/* Sums over the samples of one half. Values are taken relative to the mean of the whole, so that
   squares don't cancel. */
typedef struct Half {
  size_t count;
  double sum, squares;
} Half;

static double deviationOf(const Half* half) {
  const double n = (double)half->count;
  return sqrt(fmax(0.0, half->squares - half->sum * half->sum / n) / (n - 1.0));
}

static const double* row(const Builder* builder, size_t i) {
  return builder->rows + i * (builder->dimensions + 1);
}

/* The axis whose halves have the least sum of deviations, which is what counts when samples go by
   deviation; or `dimensions` if no half would have samples enough. */
static uint32_t bestAxis(const Builder* builder, const Box* box, size_t first, size_t count,
                         double mean) {
  uint32_t best = builder->dimensions, a;
  double least = HUGE_VAL;
  for (a = 0; a < builder->dimensions; ++a) {
    const double middle = 0.5 * (box->lower[a] + box->upper[a]);
    Half halves[2] = {{0, 0.0, 0.0}, {0, 0.0, 0.0}};
    double sum;
    size_t i;
    for (i = first; i < first + count; ++i) {
      Half* half = &halves[row(builder, i)[a] >= middle];
      const double v = row(builder, i)[builder->dimensions] - mean;
      ++half->count;
      half->sum += v;
      half->squares += v * v;
    }
    if (halves[0].count < kLeastInHalf || halves[1].count < kLeastInHalf) continue;
    sum = deviationOf(&halves[0]) + deviationOf(&halves[1]);
    /* Near ties go at random, not always to the first axis. */
    sum *= 1.0 + 0.02 * nextUniform(builder->random);
    if (sum < least) {
      least = sum;
      best = a;
    }
  }
  return best;
}

/* Brings the rows below `middle` to the front; returns how many there are. */
static size_t partition(const Builder* builder, size_t first, size_t count, uint32_t axis,
                        double middle) {
  const size_t columns = builder->dimensions + 1;
  double *low = builder->rows + first * columns, *high = low + count * columns;
  double* const begin = low;
  while (low < high) {
    if (low[axis] < middle) {
      low += columns;
    } else {
      size_t c;
      high -= columns;
      for (c = 0; c < columns; ++c) {
        const double kept = low[c];
        low[c] = high[c];
        high[c] = kept;
      }
    }
  }
  return (size_t)(low - begin) / columns;
}

static int append(Strata* strata, const Stratum* stratum) {
  if (strata->count == strata->capacity) {
    const size_t capacity = strata->capacity ? 2 * strata->capacity : 256;
    Stratum* items = realloc(strata->items, capacity * sizeof *items);
    if (!items) return 0;
    strata->items = items;
    strata->capacity = capacity;
  }
  strata->items[strata->count++] = *stratum;
  return 1;
}

static int build(const Builder* builder, Stratum* stratum, size_t first, size_t count,
                 double parentDeviation) {
  double mean = 0.0, squares = 0.0, middle;
  Stratum half;
  uint32_t axis = builder->dimensions;
  size_t i, below;
  for (i = first; i < first + count; ++i) mean += row(builder, i)[builder->dimensions];
  if (count > 0) mean /= (double)count;
  for (i = first; i < first + count; ++i) {
    const double v = row(builder, i)[builder->dimensions] - mean;
    squares += v * v;
  }
  stratum->deviation = sqrt((squares + kParentWeight * parentDeviation * parentDeviation) /
                            ((double)count + kParentWeight - 1.0));
  if (count >= kLeastToSplit && squares > 0.0) {
    axis = bestAxis(builder, &stratum->box, first, count, mean);
  }
  if (axis == builder->dimensions) return append(builder->strata, stratum);

  middle = 0.5 * (stratum->box.lower[axis] + stratum->box.upper[axis]);
  below = partition(builder, first, count, axis, middle);
  half = *stratum;
  half.volume *= 0.5;
  half.box.upper[axis] = middle;
  if (!build(builder, &half, first, below, stratum->deviation)) return 0;
  half.box = stratum->box;
  half.box.lower[axis] = middle;
  return build(builder, &half, first + below, count - below, stratum->deviation);
}

void makeUnitBox(Box* box) {
  uint32_t a;
  for (a = 0; a < AWD_MAX_DIMENSIONS; ++a) {
    box->lower[a] = 0.0;
    box->upper[a] = 1.0;
  }
}

int buildStrata(Strata* strata, uint32_t dimensions, double* rows, size_t count, Random* random) {
  Builder builder;
  Stratum all;
  builder.strata = strata;
  builder.dimensions = dimensions;
  builder.rows = rows;
  builder.random = random;
  strata->count = 0;
  makeUnitBox(&all.box);
  all.volume = 1.0;
  all.deviation = 0.0;
  all.cells = 1;
  return build(&builder, &all, 0, count, 0.0);
}

void releaseStrata(Strata* strata) {
  free(strata->items);
  strata->items = NULL;
  strata->count = strata->capacity = 0;
}

void shareCells(Strata* strata, uint64_t cells) {
  const double rest = (double)(cells - strata->count); /* after one each */
  double total = 0.0, carried = 0.0;
  size_t i;
  for (i = 0; i < strata->count; ++i) {
    total += strata->items[i].volume * pow(strata->items[i].deviation, kPower);
  }
  for (i = 0; i < strata->count; ++i) {
    Stratum* s = &strata->items[i];
    double share = s->volume;
    if (total > 0.0) {
      share = kShareByVolume * s->volume +
              (1.0 - kShareByVolume) * s->volume * pow(s->deviation, kPower) / total;
    }
    carried += share * rest;
    s->cells = 1 + (uint64_t)carried;
    carried -= floor(carried);
  }
}

int divideBox(Box* box, uint32_t dimensions, double volume, uint64_t cells, Random* random,
              CellFn cell, void* user) {
  const uint64_t lowCells = cells / 2;
  double longest = 0.0, middle, kept;
  uint32_t axis = 0, a;
  int goOn;
  if (cells == 1) return cell(user, box, volume);
  for (a = 0; a < dimensions; ++a) {
    /* Of equal edges a random one. */
    const double edge = (box->upper[a] - box->lower[a]) * (1.0 + 1e-3 * nextUniform(random));
    if (edge > longest) {
      longest = edge;
      axis = a;
    }
  }
  middle =
      box->lower[axis] + (box->upper[axis] - box->lower[axis]) * ((double)lowCells / (double)cells);
  kept = box->upper[axis];
  box->upper[axis] = middle;
  goOn = divideBox(box, dimensions, volume * ((double)lowCells / (double)cells), lowCells, random,
                   cell, user);
  box->upper[axis] = kept;
  if (!goOn) return 0;
  kept = box->lower[axis];
  box->lower[axis] = middle;
  goOn = divideBox(box, dimensions, volume * ((double)(cells - lowCells) / (double)cells),
                   cells - lowCells, random, cell, user);
  box->lower[axis] = kept;
  return goOn;
}

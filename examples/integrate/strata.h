/* SPDX-License-Identifier: Apache-2.0
 *
 * Boxes that the unit cube is cut into where a function varies, and how many samples each gets.
 */
#ifndef STRATA_H
#define STRATA_H

#include <stddef.h>

#include "awd/awd.h"
#include "random.h"

typedef struct Box {
  double lower[AWD_MAX_DIMENSIONS], upper[AWD_MAX_DIMENSIONS];
} Box;

typedef struct Stratum {
  Box box;
  double volume;
  double deviation; /* standard deviation of the samples in it */
  uint64_t cells;   /* of equal volume, that it is to be cut into */
} Stratum;

typedef struct Strata {
  Stratum* items;
  size_t count, capacity;
} Strata;

void makeUnitBox(Box* box);

/* Cuts the unit cube in halves, and these again, along the axis that lowers the deviations most,
   as long as there are enough samples in a half. Rows of dimensions + 1 numbers, the point and
   the value; they are reordered. 0: out of memory. */
int buildStrata(Strata* strata, uint32_t dimensions, double* rows, size_t count, Random* random);
void releaseStrata(Strata* strata);

/* Shares out `cells`, at least one each: most by deviation, some by volume alone, lest a stratum
   that looked flat be forgotten. There must be more cells than strata. */
void shareCells(Strata* strata, uint64_t cells);

/* Called with each cell; 0 stops the division. */
typedef int (*CellFn)(void* user, const Box* cell, double volume);

/* Cuts a box into `cells` of equal volume, longest edge first. 0: stopped. The box is used as
   scratch and comes back as it was. */
int divideBox(Box* box, uint32_t dimensions, double volume, uint64_t cells, Random* random,
              CellFn cell, void* user);

#endif

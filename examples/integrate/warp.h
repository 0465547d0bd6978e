/* SPDX-License-Identifier: Apache-2.0
 *
 * A learned map of the unit cube to itself: one density per axis, drawn from by its inverse CDF.
 * Where f is a product of functions of one variable each, f / p comes out nearly constant, in any
 * number of dimensions; and since the densities are continuous, so is f / p where f is.
 */
#ifndef WARP_H
#define WARP_H

#include "awd/awd.h"

typedef struct Warp {
  AWDDevice device;
  uint32_t dimensions;
  AWDDensity axes[AWD_MAX_DIMENSIONS];
  uint32_t levels[AWD_MAX_DIMENSIONS];
} Warp;

/* The identity. What was made is to be released even after a failure. */
AWDResult makeWarp(Warp* warp, AWDDevice device, uint32_t dimensions);
void releaseWarp(Warp* warp);

/* Makes the warp anew from the `count` samples of a pass that it carried itself. Rows of
   dimensions + 1 numbers: the uniforms, and f / p. `work` has room for 4 numbers a sample. */
AWDResult learnWarp(Warp* warp, const double* rows, size_t count, double* work);

#endif

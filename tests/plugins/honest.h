/* SPDX-License-Identifier: Apache-2.0
 *
 * Families that are what they say, for tests that want more than Haar:
 *   test-linear           linear B-splines, clamped
 *   test-linear-periodic  the same on a circle
 *   test-quadratic        quadratic B-splines, clamped
 */
#ifndef AWD_TESTS_HONEST_H
#define AWD_TESTS_HONEST_H

#include "awd/basis.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The table, for programs that link honest.c. */
const AWDBasisModule* honestModule(void);

#ifdef __cplusplus
}
#endif
#endif

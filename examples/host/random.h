/* SPDX-License-Identifier: Apache-2.0
 *
 * Uniform random numbers: xorshift64* (Vigna 2016).
 */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

typedef struct Random {
  uint64_t state; /* never 0 */
} Random;

/* Uniform in [0,1), 53 bits. */
static inline double nextUniform(Random* random) {
  uint64_t s = random->state;
  s ^= s >> 12;
  s ^= s << 25;
  s ^= s >> 27;
  random->state = s;
  return (double)((s * 0x2545f4914f6cdd1du) >> 11) * 0x1p-53;
}

/* The first numbers after a small seed are alike: they are thrown away. */
static inline void seedRandom(Random* random, uint64_t seed) {
  int i;
  random->state = seed * 0x9e3779b97f4a7c15u + 1u;
  if (random->state == 0) random->state = 1u;
  for (i = 0; i < 16; ++i) (void)nextUniform(random);
}

#endif

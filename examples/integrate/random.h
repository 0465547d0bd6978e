/* SPDX-License-Identifier: Apache-2.0
 *
 * Uniform random numbers: splitmix64 (Steele, Lea and Flood 2014).
 */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

typedef struct Random {
  uint64_t state;
} Random;

/* Uniform in [0,1), 53 bits. */
static inline double nextUniform(Random* random) {
  uint64_t z = random->state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

#endif

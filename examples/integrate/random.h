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

/* A bijection in which every bit of z reaches every bit of the result. */
static inline uint64_t mixBits(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/* Streams of neighbouring seeds start far from one another. */
static inline void seedRandom(Random* random, uint64_t seed) {
  random->state = mixBits(seed + 0x9e3779b97f4a7c15u);
}

/* Uniform in [0,1), 53 bits. */
static inline double nextUniform(Random* random) {
  random->state += 0x9e3779b97f4a7c15u;
  return (double)(mixBits(random->state) >> 11) / 9007199254740992.0;
}

#endif

// SPDX-License-Identifier: Apache-2.0
// Points of the first two dimensions of Sobol's sequence, scrambled after Owen: of any 2^k in a row
// from a multiple of 2^k on, there is one in each dyadic rectangle of area 2^-k, and each by itself
// is uniform. Pairs of further dimensions are the same sequence in another order (Burley 2020,
// Practical hash-based Owen scrambling).
#pragma once

#include <cstdint>

namespace awd {

/// The bits from the last to the first.
inline uint32_t reverseBits(uint32_t x) {
  x = __builtin_bswap32(x);
  x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
  x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
  return (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
}

/// A bijection in which a bit changes itself and higher ones alone: Owen's scrambling of a number
/// whose bits are reversed (Laine and Karras 2011, with the constants of Vegdahl 2021).
inline uint32_t scrambleReversed(uint32_t x, uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= seed >> 16 | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// The second dimension, bits reversed, of the point with this index: the index times Pascal's
/// triangle modulo 2.
inline uint32_t secondSobolReversed(uint32_t index) {
  index ^= index >> 16;
  index ^= (index & 0xff00ff00u) >> 8;
  index ^= (index & 0xf0f0f0f0u) >> 4;
  index ^= (index & 0xccccccccu) >> 2;
  return index ^ (index & 0xaaaaaaaau) >> 1;
}

struct SobolPoint {
  double x, y;  ///< in [0,1), multiples of 2^-32
};

/// The point of an index. order: shuffles indices, and seedX and seedY scramble the coordinates.
inline SobolPoint sobolPoint(uint32_t index, uint32_t order, uint32_t seedX, uint32_t seedY) {
  const uint32_t i = reverseBits(scrambleReversed(reverseBits(index), order));
  const uint32_t x = reverseBits(scrambleReversed(i, seedX));
  const uint32_t y = reverseBits(scrambleReversed(secondSobolReversed(i), seedY));
  return {x * 0x1p-32, y * 0x1p-32};
}

}  // namespace awd

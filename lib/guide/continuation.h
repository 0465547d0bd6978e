// SPDX-License-Identifier: Apache-2.0
// With how many rays a path goes on, by the radiance that is still to come (adjoint-driven roulette
// and splitting, Vorba and Krivanek 2016): a weight window about what the pixel is expected to
// have.
#pragma once

#include <algorithm>
#include <cstdint>

#include "util/error.h"

namespace awd {

/// Into how many rays a path may be split at a vertex; 0 asks for the default.
inline uint32_t settleSplit(uint32_t asked, const char* name) {
  constexpr uint32_t kMost = 64;
  constexpr uint32_t kDefault = 8;
  if (asked > kMost) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "%s is %u: at most %u are allowed", name, asked, kMost);
  }
  return asked ? asked : kDefault;
}

/// How many rays on average. throughput: luminance, before the vertex; reflected: the indirect
/// radiance that its patch reflects; expected: what the pixel has. With r = throughput reflected /
/// expected, which is what a path is worth in pixels, 1 ray for r between 1/3 and 1; below it
/// survivors carry 1/3, but one in ten goes on in any case; above it each of r rays carries 1.
inline float continuation(float throughput, float reflected, float expected, float mostSplit) {
  constexpr float kRoulette = 3.0f;
  constexpr float kLeast = 0.1f;
  const float worth = throughput * reflected / expected;
  if (worth > 1.0f) return std::min(worth, mostSplit);
  // Also of what is NaN.
  return kRoulette * worth > kLeast ? std::min(kRoulette * worth, 1.0f) : kLeast;
}

/// That number made whole by a uniform in [0,1): of this mean.
inline uint32_t roundedBy(double uniform, float mean) {
  if (!(mean > 0.0f)) return 0;  // nor of a mean that is NaN
  const auto whole = static_cast<uint32_t>(mean);
  return whole + (uniform < static_cast<double>(mean - static_cast<float>(whole)) ? 1 : 0);
}

}  // namespace awd

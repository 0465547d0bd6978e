// SPDX-License-Identifier: Apache-2.0
// What the exchange of fields and that of renders share.
#pragma once

#include "api/guard.h"

namespace awd {

/// Tells how many numbers there are; whether they are asked for.
inline bool tellSize(size_t sums, size_t maxima, uint64_t* numbers, size_t capacity,
                     size_t* sumsOut, size_t* maximaOut) {
  *need(sumsOut, "sums") = sums;
  *need(maximaOut, "maxima") = maxima;
  if (capacity == 0) return false;
  need(numbers, "numbers");
  if (capacity < sums + maxima) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "capacity is %zu: there are %zu sums and %zu maxima", capacity,
         sums, maxima);
  }
  return true;
}

inline void checkCount(size_t sums, size_t maxima, const uint64_t* numbers, size_t count) {
  need(numbers, "numbers");
  if (count != sums + maxima) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "count is %zu: %zu sums and %zu maxima are exchanged; do all processes have the same?",
         count, sums, maxima);
  }
}

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
//
// What several processes have found apart, as numbers to be combined one by one.
#ifndef AWD_CPP_SUMMANDS_HPP
#define AWD_CPP_SUMMANDS_HPP

#include <cstdint>
#include <vector>

#include "awd/cpp/error.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// The first `sums` numbers are to be added to those of the other processes, modulo 2^64; of each
/// of the others the largest is to be taken.
struct Summands {
  std::vector<std::uint64_t> numbers;
  std::size_t sums = 0;
};

namespace detail {

/// All that `fill`, a function (numbers, capacity, &sums, &maxima), has to tell.
template <class Fill>
Returns<Summands> summands(Fill&& fill) {
  Summands all;
  std::size_t maxima = 0;
  AWDResult result = fill(nullptr, 0, &all.sums, &maxima);
  if (result == AWD_SUCCESS) {
    all.numbers.resize(all.sums + maxima);
    result = fill(all.numbers.data(), all.numbers.size(), &all.sums, &maxima);
  }
  return outcome(result, all);
}

}  // namespace detail
}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif

// SPDX-License-Identifier: Apache-2.0
// How the numbers of a patch's statistics become words that processes add up, or take the largest
// of, and how they come back. Each is given all numbers in the same order.
//
// Sums of words are modulo 2^64, as those of a pass are: the bits are the same. That a sum of
// several processes has gone past 2^63, which ends its meaning, would not always show in them: so
// the upper halves of all sums are added up as well. With T_i the sum of the s_ir of processes r,
// sum_r (s_ir >> 32) is at most T_i >> 32 as long as nothing is lost, and 2^32 too large for each
// 2^64 that is, less one for each process: the sums of all i tell as much, for fewer than 2^32 sums
// times processes.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstring>

namespace awd {

/// Counts them.
struct ExchangeCounter {
  std::size_t sums = 0, maxima = 0;

  void count(const std::atomic<uint64_t>&) { ++sums; }
  void sum(const std::atomic<int64_t>&) { ++sums; }
  void overflow(const std::atomic<bool>&) { ++sums, ++maxima; }
  void maximum(const std::atomic<uint64_t>&) { ++maxima; }
};

struct ExchangeWriter {
  uint64_t* sums;
  uint64_t* maxima;
  uint64_t high = 0;

  void count(const std::atomic<uint64_t>& from) { *sums++ = from.load(); }
  void sum(const std::atomic<int64_t>& from) {
    const auto bits = static_cast<uint64_t>(from.load());
    *sums++ = bits;
    high += bits >> 32;
  }
  void overflow(const std::atomic<bool>& from) {
    *sums++ = high;
    *maxima++ = from.load() ? 1 : 0;
    high = 0;
  }
  void maximum(const std::atomic<uint64_t>& from) { *maxima++ = from.load(); }
};

/// Changes nothing, and finds out whether the maxima can be what they should be.
struct ExchangeChecker {
  const uint64_t* sums;
  const uint64_t* maxima;
  bool good = true;

  void count(const std::atomic<uint64_t>&) { ++sums; }
  void sum(const std::atomic<int64_t>&) { ++sums; }
  void overflow(const std::atomic<bool>&) {
    ++sums;
    good &= *maxima++ <= 1;
  }
  /// The bits of a double that is finite and not negative.
  void maximum(const std::atomic<uint64_t>&) { good &= *maxima++ < 0x7ff0000000000000u; }
};

struct ExchangeReader {
  const uint64_t* sums;
  const uint64_t* maxima;
  uint64_t high = 0;
  bool negative = false;

  void count(std::atomic<uint64_t>& to) { to.store(*sums++); }
  void sum(std::atomic<int64_t>& to) {
    const uint64_t bits = *sums++;
    to.store(static_cast<int64_t>(bits));
    high += bits >> 32;
    negative |= bits >> 63 != 0;
  }
  void overflow(std::atomic<bool>& to) {
    const bool lost = *sums++ > high;
    to.store(*maxima++ != 0 || negative || lost);
    high = 0;
    negative = false;
  }
  void maximum(std::atomic<uint64_t>& to) { to.store(*maxima++); }
};

}  // namespace awd

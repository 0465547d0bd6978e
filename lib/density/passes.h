// SPDX-License-Identifier: Apache-2.0
// The passes of a density as estimates of int f, and how they combine into one.
#pragma once

#include <memory_resource>
#include <vector>

#include "awd/density.h"
#include "density/model.h"
#include "density/statistics.h"

namespace awd {

// Sums of squares of doubles fit into a long double, not into a double.
struct Estimate {
  double integral = 0.0;
  double standardError = 0.0;
  uint64_t samples = 0;
  uint64_t passes = 0;
};

class Passes {
 public:
  /// Passes whose densities are kept for their cross-pass variances.
  static constexpr std::size_t kKept = 16;

  Passes(std::pmr::memory_resource* memory, AWDCombination combination);
  /// In the same memory, where a vector's own would be in that of the process.
  Passes(const Passes& other);
  Passes& operator=(const Passes& other) = default;
  Passes(Passes&& other) = default;
  Passes& operator=(Passes&& other) = default;
  ~Passes() = default;

  /// A finished pass; p: what it was drawn from.
  void finish(const PassSums& sums, const Model& p);
  /// Of the finished passes and the one at work.
  Estimate estimate(const PassSums& present) const;

  struct Pass {
    Model p;
    uint64_t samples;
    long double mean;
  };
  /// Those with a density kept, oldest first; empty when combining by count.
  const std::pmr::vector<Pass>& kept() const { return kept_; }
  std::size_t bytes() const;

  /// By count: all samples so far, their sum of f/p, and m_k times the variance of each pass.
  struct Totals {
    uint64_t samples = 0;
    uint64_t passes = 0;
    long double sum = 0.0L;
    long double variance = 0.0L;
  };
  /// What the last pass with samples says of the kept ones, itself included, to be loaded again.
  struct LastPass {
    explicit LastPass(std::pmr::memory_resource* memory) : secondMoments(memory) {}
    LastPass(const LastPass& other)
        : samples(other.samples),
          mean(other.mean),
          secondMoments(other.secondMoments, other.secondMoments.get_allocator()) {}
    LastPass& operator=(const LastPass& other) = default;
    LastPass(LastPass&& other) = default;
    LastPass& operator=(LastPass&& other) = default;
    ~LastPass() = default;
    uint64_t samples = 0;
    long double mean = 0.0L;
    std::pmr::vector<long double> secondMoments;  ///< mean of f^2 / (p_k p), oldest first
  };
  const Totals& totals() const { return totals_; }
  const LastPass& lastPass() const { return last_; }
  void load(const Totals& totals, std::pmr::vector<Pass> kept, LastPass last);

 private:
  LastPass lastPass(const PassSums& present) const;
  Estimate byCrossVariance(const PassSums& present) const;

  AWDCombination combination_;
  Totals totals_;
  std::pmr::vector<Pass> kept_;
  LastPass last_;
};

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// (A + E)_FF x = r by whichever way is the faster: directly where envelopes are short, by conjugate
// gradients on grids of many dimensions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "refit/envelope_cholesky.h"
#include "refit/quadratic.h"

namespace awd {

/// The unknowns that may move, and what is added to the diagonal of A.
struct FreeSet {
  explicit FreeSet(uint32_t n) : isFree(n, 0), extra(n, 0.0) {}
  std::vector<uint8_t> isFree;
  std::vector<double> extra;
};

class FreeSolver {
 public:
  /// The quadratic must outlive this.
  explicit FreeSolver(const Quadratic& quadratic) : quadratic_(quadratic) {}

  /// To be called after each change of the set, which must live until the next call. fraction is
  /// what the host is told of the progress.
  void prepare(const FreeSet& set, double fraction);

  /// Overwrites r by x, which is 0 where unknowns are not free.
  void solve(std::vector<double>& r);

 private:
  const Quadratic& quadratic_;
  std::optional<EnvelopeCholesky> cholesky_;
  const FreeSet* set_ = nullptr;
  double fraction_ = 0.0;
  bool direct_ = false;
};

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// What a pass's samples say of one coefficient.
#pragma once

#include "density/binned_sum.h"

namespace awd {

struct Tally {
  /// S1_j = sum f N_j / p; under the estimator `paper` the sum of f over the samples drawn from j.
  BinnedSum value;
  /// S0_j = sum N_j / p; unused under `paper`.
  BinnedSum weight;
  /// n_j = sum N_j in units of 2^-30: how many samples speak of j.
  int64_t alive = 0;

  static constexpr double kAliveUnit = 0x1p-30;

  void add(const Tally& other) {
    value.add(other.value);
    weight.add(other.weight);
    alive += other.alive;
  }
  double count() const { return static_cast<double>(alive) * kAliveUnit; }
};

}  // namespace awd

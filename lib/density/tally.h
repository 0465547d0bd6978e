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

  /// A sample at which N_j is n: of value |f|/p and weight 1/p, each with an exponent.
  void add(Scaled sampleValue, Scaled sampleWeight, double n) {
    value.add(sampleValue.value * n, sampleValue.exponent);
    weight.add(sampleWeight.value * n, sampleWeight.exponent);
    alive += static_cast<int64_t>(n * (1.0 / kAliveUnit));
  }
  void add(const Tally& other) {
    value.add(other.value);
    weight.add(other.weight);
    alive += other.alive;
  }
  double count() const { return static_cast<double>(alive) * kAliveUnit; }
};

}  // namespace awd

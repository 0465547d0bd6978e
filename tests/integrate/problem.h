// SPDX-License-Identifier: Apache-2.0
// Integrands as lambdas.
#pragma once

#include <functional>
#include <vector>

#include "integrate.h"

namespace awdtest {

struct Problem {
  std::function<double(const double*)> f;
  std::vector<double> lower, upper;
  uint64_t calls = 0;
};

struct Outcome : IntegrateResult {
  IntegrateStatus status = INTEGRATE_FAILED;
};

inline Outcome solve(AWDDevice device, Problem& problem, const IntegrateOptions& options) {
  Outcome outcome;
  const auto call = [](void* user, const double* x) {
    auto* self = static_cast<Problem*>(user);
    ++self->calls;
    return self->f(x);
  };
  outcome.status = integrate(device, call, &problem, static_cast<uint32_t>(problem.lower.size()),
                             problem.lower.data(), problem.upper.data(), &options, &outcome);
  return outcome;
}

inline IntegrateOptions budget(uint64_t evaluations, uint64_t seed = 1) {
  IntegrateOptions options = INTEGRATE_OPTIONS_INIT;
  options.evaluations = evaluations;
  options.seed = seed;
  return options;
}

}  // namespace awdtest

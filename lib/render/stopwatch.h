// SPDX-License-Identifier: Apache-2.0
// What a pass takes.
#pragma once

#include <ctime>

namespace awd {

/// CPU time of the process and wall time since its construction.
class Stopwatch {
 public:
  double cpuSeconds() const { return now(CLOCK_PROCESS_CPUTIME_ID) - cpu_; }
  double wallSeconds() const { return now(CLOCK_MONOTONIC) - wall_; }

 private:
  static double now(clockid_t clock) {
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double cpu_ = now(CLOCK_PROCESS_CPUTIME_ID);
  double wall_ = now(CLOCK_MONOTONIC);
};

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// Integrators behind one interface.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "integrands.h"

namespace bench {

struct Run {
  double value = 0.0;
  double error = 0.0;  ///< as the method reports it
};

struct Method {
  std::string name;
  bool random;  ///< else one run tells all
  /// At most about `evaluations` of them; peers may differ by a few. Called from several threads.
  std::function<Run(const Integrand&, uint64_t evaluations, uint64_t seed)> run;
};

constexpr const char* kOurs = "awd";
/// The peer of the goals: two configurations, of which the better counts.
constexpr const char* kVegas[] = {"vegas 5 x N/5", "vegas 20% + 80%"};

/// Each is empty if this program was built without the library.
std::vector<Method> awdMethods();
std::vector<Method> gslMethods();
std::vector<Method> cubatureMethods();

}  // namespace bench

// SPDX-License-Identifier: Apache-2.0
// Adaptive cubature of Genz and Malik by S. G. Johnson's libcubature: no randomness.
#include "methods.h"

#ifdef AWD_BENCH_CUBATURE
#include <cubature.h>

#include <stdexcept>

namespace bench {

std::vector<Method> cubatureMethods() {
  return {{"cubature", false, [](const Integrand& f, uint64_t evaluations, uint64_t) {
             const double lower[kMostDimensions] = {};
             const double upper[kMostDimensions] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
             const auto call = [](unsigned, const double* x, void* user, unsigned, double* value) {
               *value = (*static_cast<const Integrand*>(user))(x);
               return 0;
             };
             Run run;
             if (hcubature(1, call, const_cast<Integrand*>(&f),
                           static_cast<unsigned>(f.dimensions()), lower, upper, evaluations, 0.0,
                           0.0, ERROR_INDIVIDUAL, &run.value, &run.error) != 0) {
               throw std::runtime_error("cubature failed");
             }
             return run;
           }}};
}

}  // namespace bench
#else
namespace bench {
std::vector<Method> cubatureMethods() { return {}; }
}  // namespace bench
#endif

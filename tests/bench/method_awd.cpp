// SPDX-License-Identifier: Apache-2.0
// The integrator of examples/integrate.
#include <memory>
#include <stdexcept>

#include "integrate.h"
#include "methods.h"

namespace bench {

std::vector<Method> awdMethods() {
  AWDDevice handle = nullptr;
  if (awdNewDevice(nullptr, &handle) != AWD_SUCCESS) {
    throw std::runtime_error(awdGetLastErrorMessage());
  }
  const std::shared_ptr<AWDDeviceImpl> device(handle, awdReleaseDevice);
  return {{kOurs, true, [device](const Integrand& f, uint64_t evaluations, uint64_t seed) {
             const double lower[kMostDimensions] = {};
             const double upper[kMostDimensions] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
             IntegrateOptions options = INTEGRATE_OPTIONS_INIT;
             options.evaluations = evaluations;
             options.seed = seed;
             IntegrateResult result;
             const auto call = [](void* user, const double* x) {
               return (*static_cast<const Integrand*>(user))(x);
             };
             if (integrate(device.get(), call, const_cast<Integrand*>(&f),
                           static_cast<uint32_t>(f.dimensions()), lower, upper, &options,
                           &result) != INTEGRATE_DONE) {
               throw std::runtime_error(result.message);
             }
             return Run{result.value, result.error};
           }}};
}

}  // namespace bench

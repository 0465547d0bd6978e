// SPDX-License-Identifier: Apache-2.0
// A module put to the test without a device: for whoever writes one.
#pragma once

#include <functional>

#include "awd/device.h"

namespace awd {

/// Reports every check of every family of a module file, then throws the first failure as
/// Registry::load would. The module is closed again.
void checkModuleFile(const char* absolutePath,
                     const std::function<void(const AWDBasisCheck&)>& report);

}  // namespace awd

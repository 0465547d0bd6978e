// SPDX-License-Identifier: Apache-2.0
// The one device of this program, and the options that concern it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "awd/awd.hpp"
#include "progress_bar.h"

namespace command {

struct DeviceOptions {
  uint32_t threads = 0;
  /// Made absolute from the current folder.
  std::vector<std::string> basisPaths;
};

/// Warnings of the library become ours. bar may be null; it must outlive the device.
awd::Device openDevice(const DeviceOptions& options = {}, ProgressBar* bar = nullptr);

}  // namespace command

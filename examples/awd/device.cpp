// SPDX-License-Identifier: Apache-2.0
#include "device.h"

#include <filesystem>

#include "console.h"
#include "failure.h"

namespace command {
namespace {

void AWD_CALL onLog(void*, int32_t severity, const char* message) {
  if (severity >= AWD_LOG_WARNING) warn(message);
}

}  // namespace

Device openDevice(const DeviceOptions& options, ProgressBar* bar) {
  std::vector<std::string> absolute;
  for (const std::string& path : options.basisPaths) {
    absolute.push_back(std::filesystem::absolute(path).string());
  }
  std::vector<const char*> paths;
  paths.reserve(absolute.size());
  for (const std::string& path : absolute) paths.push_back(path.c_str());

  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = options.threads;
  desc.log = onLog;
  if (bar) desc.progress = ProgressBar::callback;
  desc.progressUser = bar;
  desc.basisPaths = paths.data();
  desc.basisPathCount = paths.size();
  Device device;
  check(awdNewDevice(&desc, device.out()));
  return device;
}

}  // namespace command

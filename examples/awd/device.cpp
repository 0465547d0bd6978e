// SPDX-License-Identifier: Apache-2.0
#include "device.h"

#include <filesystem>

#include "console.h"

namespace command {
namespace {

constexpr auto kLog = [](int32_t severity, const char* message) {
  if (severity >= AWD_LOG_WARNING) warn(message);
};

}  // namespace

awd::Device openDevice(const DeviceOptions& options, ProgressBar* bar) {
  std::vector<std::string> absolute;
  for (const std::string& path : options.basisPaths) {
    absolute.push_back(std::filesystem::absolute(path).string());
  }
  std::vector<const char*> paths;
  paths.reserve(absolute.size());
  for (const std::string& path : absolute) paths.push_back(path.c_str());

  awd::DeviceDesc desc;
  desc.threads = options.threads;
  desc.setLog(kLog);
  if (bar) desc.setProgress(*bar);
  desc.setBasisPaths(paths);
  return awd::Device::create(desc);
}

}  // namespace command

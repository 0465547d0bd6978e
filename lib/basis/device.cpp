// SPDX-License-Identifier: Apache-2.0
#include "basis/device.h"

namespace awd {

Device::Device(Ref<Context> context, std::vector<std::string> folders, bool ignoreEnvironment)
    : context_(std::move(context)), registry_(*context_, std::move(folders), ignoreEnvironment) {}

Ref<Device> Device::make(const AWDDeviceDesc& desc, std::vector<std::string> folders) {
  Ref<Context> context = Context::make(desc);
  std::pmr::memory_resource* memory = context->memory();
  return Ref<Device>::adopt(awd::make<Device>(memory, context, std::move(folders),
                                              (desc.flags & AWD_DEVICE_IGNORE_ENVIRONMENT) != 0));
}

void Device::destroy() noexcept {
  const Ref<Context> context = context_;  // the memory outlives what lies in it
  unmake(context->memory(), this);
}

}  // namespace awd

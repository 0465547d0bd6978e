// SPDX-License-Identifier: Apache-2.0
#include "bounded_device.h"

#include <algorithm>
#include <cstdlib>

#include "require.h"

namespace fuzz {

BoundedDevice& BoundedDevice::shared() {
  static BoundedDevice device;
  return device;
}

BoundedDevice::BoundedDevice() {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;
  desc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  desc.alloc = [](void* user, size_t size, size_t alignment) -> void* {
    auto& self = *static_cast<BoundedDevice*>(user);
    if (size > self.most_ - std::min(self.held_, self.most_)) return nullptr;
    const size_t least = std::max(alignment, sizeof(void*));
    void* block =
        std::aligned_alloc(least, (std::max<size_t>(size, 1) + least - 1) / least * least);
    if (block) self.held_ += size;
    return block;
  };
  desc.free = [](void* user, void* block, size_t size, size_t) {
    static_cast<BoundedDevice*>(user)->held_ -= size;
    std::free(block);
  };
  desc.allocUser = this;
  desc.progress = [](void* user, const AWDProgress*) -> int32_t {
    return --static_cast<BoundedDevice*>(user)->steps_ > 0;
  };
  desc.progressUser = this;
  require(awdNewDevice(&desc, &device_) == AWD_SUCCESS, "no device");
  size_t count = 0;
  require(awdGetBasisCount(device_, &count) == AWD_SUCCESS && count >= 8, "no bases");
}

void BoundedDevice::allow(std::size_t bytes, long steps) {
  most_ = held_ + std::min(bytes, ~held_);
  steps_ = steps;
}

Bounds::Bounds(std::size_t bytes, long steps) : before_(BoundedDevice::shared().held()) {
  BoundedDevice::shared().allow(bytes, steps);
}

Bounds::~Bounds() {
  require(BoundedDevice::shared().held() == before_, "memory was not given back");
  BoundedDevice::shared().allowAll();
}

}  // namespace fuzz

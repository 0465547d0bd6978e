// SPDX-License-Identifier: Apache-2.0
// The object behind AWDDevice: the context and the basis registry that its objects share.
#pragma once

#include <string>
#include <vector>

#include "basis/registry.h"
#include "util/context.h"

namespace awd {

class Device final : public RefCounted {
 public:
  /// desc has been checked; folders are its basisPaths.
  static Ref<Device> make(const AWDDeviceDesc& desc, std::vector<std::string> folders);

  Context& context() noexcept { return *context_; }
  Ref<Context> shareContext() const noexcept { return context_; }
  Registry& registry() noexcept { return registry_; }

 private:
  template <class T, class... Arguments>
  friend T* make(std::pmr::memory_resource* memory, Arguments&&... arguments);
  template <class T>
  friend void unmake(std::pmr::memory_resource* memory, T* object) noexcept;

  Device(Ref<Context> context, std::vector<std::string> folders, bool ignoreEnvironment);
  ~Device() override = default;
  void destroy() noexcept override;

  Ref<Context> context_;
  Registry registry_;
};

}  // namespace awd

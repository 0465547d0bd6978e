// SPDX-License-Identifier: Apache-2.0
// The host's allocator as a memory resource: everything we keep goes through one of these.
#pragma once

#include <memory_resource>

#include "awd/types.h"

namespace awd {

/// Calls the host's functions, or the C++ runtime's when `alloc` is null. Throws std::bad_alloc.
class HostMemory final : public std::pmr::memory_resource {
 public:
  HostMemory(AWDAllocFn alloc, AWDFreeFn free, void* user)
      : alloc_(alloc), free_(free), user_(user) {}

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* ptr, std::size_t bytes, std::size_t alignment) override;
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  AWDAllocFn alloc_;
  AWDFreeFn free_;
  void* user_;
};

}  // namespace awd

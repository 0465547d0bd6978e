// SPDX-License-Identifier: Apache-2.0
#include "util/memory.h"

#include <cstdint>
#include <new>

namespace awd {

void* HostMemory::do_allocate(std::size_t bytes, std::size_t alignment) {
  if (!alloc_) return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  void* ptr = alloc_(user_, bytes, alignment);
  if (!ptr) throw std::bad_alloc();
  if (reinterpret_cast<std::uintptr_t>(ptr) % alignment != 0) {
    free_(user_, ptr, bytes, alignment);
    throw std::bad_alloc();
  }
  return ptr;
}

void HostMemory::do_deallocate(void* ptr, std::size_t bytes, std::size_t alignment) {
  if (!alloc_) {
    std::pmr::new_delete_resource()->deallocate(ptr, bytes, alignment);
  } else {
    free_(user_, ptr, bytes, alignment);
  }
}

}  // namespace awd

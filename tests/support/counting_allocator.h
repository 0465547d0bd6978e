// SPDX-License-Identifier: Apache-2.0
// A host's allocator that watches what the library does with it.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>

#include "awd/awd.h"

namespace awdtest {

/// Counts, checks sizes on the way back, and can refuse from the n-th call on, or only that one.
class CountingAllocator {
 public:
  AWDDeviceDesc desc(uint32_t threads) {
    AWDDeviceDesc result = AWD_DEVICE_DESC_INIT;
    result.threads = threads;
    result.alloc = [](void* user, size_t size, size_t alignment) {
      return static_cast<CountingAllocator*>(user)->allocate(size, alignment);
    };
    result.free = [](void* user, void* ptr, size_t size, size_t alignment) {
      static_cast<CountingAllocator*>(user)->release(ptr, size, alignment);
    };
    result.allocUser = this;
    return result;
  }

  void refuse(size_t call, bool allLater) {
    refused_ = call;
    allLater_ = allLater;
  }
  size_t calls() const { return calls_; }
  size_t blocks() const { return blocks_.size(); }
  size_t bytes() const { return bytes_; }  ///< ever asked for
  size_t held() const { return held_; }    ///< of these, not given back

 private:
  struct Block {
    size_t size, alignment;
  };

  void* allocate(size_t size, size_t alignment) {
    const std::lock_guard<std::mutex> lock(mutex_);
    EXPECT_EQ(alignment & (alignment - 1), 0u);
    EXPECT_GT(alignment, 0u);
    ++calls_;
    if (refused_ && (allLater_ ? calls_ >= refused_ : calls_ == refused_)) return nullptr;
    const size_t least = std::max(alignment, sizeof(void*));
    void* ptr = std::aligned_alloc(least, (std::max<size_t>(size, 1) + least - 1) / least * least);
    blocks_[ptr] = {size, alignment};
    bytes_ += size;
    held_ += size;
    return ptr;
  }
  void release(void* ptr, size_t size, size_t alignment) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto block = blocks_.find(ptr);
    if (block == blocks_.end()) {
      ADD_FAILURE() << "freed what was not allocated, or twice";
      return;
    }
    EXPECT_EQ(block->second.size, size);
    EXPECT_EQ(block->second.alignment, alignment);
    held_ -= block->second.size;
    blocks_.erase(block);
    std::free(ptr);
  }

  std::mutex mutex_;
  std::map<void*, Block> blocks_;
  size_t calls_ = 0, bytes_ = 0, held_ = 0, refused_ = 0;
  bool allLater_ = false;
};
}  // namespace awdtest

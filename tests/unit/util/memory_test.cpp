// SPDX-License-Identifier: Apache-2.0
#include "util/memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <vector>

namespace {

/// A host's heap that knows what is out.
struct Heap {
  struct Block {
    void* ptr;
    std::size_t size, alignment;
  };
  std::vector<Block> blocks;
  std::size_t offset = 0;  ///< added to every address, to misalign it
  bool empty = false;
  bool wrong = false;

  static void* AWD_CALL alloc(void* user, std::size_t size, std::size_t alignment) {
    Heap& heap = *static_cast<Heap*>(user);
    if (heap.empty) return nullptr;
    char* ptr = static_cast<char*>(::operator new (size + 64, std::align_val_t{64})) + heap.offset;
    heap.blocks.push_back({ptr, size, alignment});
    return ptr;
  }
  static void AWD_CALL free(void* user, void* ptr, std::size_t size, std::size_t alignment) {
    Heap& heap = *static_cast<Heap*>(user);
    for (auto block = heap.blocks.begin(); block != heap.blocks.end(); ++block) {
      if (block->ptr != ptr) continue;
      heap.wrong |= block->size != size || block->alignment != alignment;
      ::operator delete (static_cast<char*>(ptr) - heap.offset, std::align_val_t{64});
      heap.blocks.erase(block);
      return;
    }
    heap.wrong = true;
  }
};

TEST(HostMemory, GoesThroughTheHostsFunctions) {
  Heap heap;
  awd::HostMemory memory(Heap::alloc, Heap::free, &heap);
  {
    std::pmr::vector<double> numbers(1000, 1.0, &memory);
    ASSERT_EQ(heap.blocks.size(), 1u);
    EXPECT_EQ(heap.blocks[0].size, 8000u);
    EXPECT_EQ(heap.blocks[0].alignment, alignof(double));
    numbers.push_back(2.0);
  }
  EXPECT_TRUE(heap.blocks.empty());
  EXPECT_FALSE(heap.wrong) << "size and alignment come back as they went";
}

TEST(HostMemory, NoMemoryIsBadAlloc) {
  Heap heap;
  heap.empty = true;
  awd::HostMemory memory(Heap::alloc, Heap::free, &heap);
  EXPECT_THROW((void)memory.allocate(16, 8), std::bad_alloc);
}

TEST(HostMemory, AMisalignedBlockIsGivenBack) {
  Heap heap;
  heap.offset = 8;
  awd::HostMemory memory(Heap::alloc, Heap::free, &heap);
  EXPECT_THROW((void)memory.allocate(32, 32), std::bad_alloc);
  EXPECT_TRUE(heap.blocks.empty());
  void* fits = memory.allocate(32, 8);
  memory.deallocate(fits, 32, 8);
  EXPECT_FALSE(heap.wrong);
}

TEST(HostMemory, WithoutAHostItIsTheRuntimes) {
  awd::HostMemory memory(nullptr, nullptr, nullptr);
  void* ptr = memory.allocate(100, 64);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(ptr) % 64, 0u);
  memory.deallocate(ptr, 100, 64);
}

TEST(HostMemory, EqualsItselfAlone) {
  awd::HostMemory a(nullptr, nullptr, nullptr), b(nullptr, nullptr, nullptr);
  EXPECT_TRUE(a.is_equal(a));
  EXPECT_FALSE(a.is_equal(b));
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Memory that runs out: at each allocation of each call of a host's life, once or for good, that of
// the host's allocator and that of the C++ heap. The call fails with a message, nothing is leaked,
// and the same call again goes on with the same bits.
#include <gtest/gtest.h>

#include <atomic>
#include <memory_resource>
#include <ostream>
#include <string>

#include "faults/life.h"
#include "faults/refused_heap.h"
#include "support/counting_allocator.h"
#include "support/soak.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

/// Of each call in ./run check: the first few allocations, then in growing steps.
size_t nextFault(size_t n) { return n + 1 + (wholeSoak() ? 0 : n * n / 20); }

/// What asks for memory that is nobody's: copies of containers that lie in the host's memory do, if
/// they aren't told where to lie.
class NobodysMemory final : public std::pmr::memory_resource {
 public:
  NobodysMemory() : before_(std::pmr::set_default_resource(this)) {}
  ~NobodysMemory() override { std::pmr::set_default_resource(before_); }
  NobodysMemory(const NobodysMemory&) = delete;
  NobodysMemory& operator=(const NobodysMemory&) = delete;
  size_t calls() const { return calls_; }

 private:
  void* do_allocate(size_t bytes, size_t alignment) override {
    ++calls_;
    return before_->allocate(bytes, alignment);
  }
  void do_deallocate(void* ptr, size_t bytes, size_t alignment) override {
    before_->deallocate(ptr, bytes, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  std::pmr::memory_resource* before_;
  std::atomic<size_t> calls_{0};
};

using Evidence = std::map<std::string, std::vector<char>>;

#ifdef AWD_TEST_REFIT
constexpr bool kRefits = true;
#else
constexpr bool kRefits = false;  // there is no refit module in this build
#endif

Evidence untroubled(uint32_t threads) {
  const TemporaryFolder folder;
  const NobodysMemory nobodys;
  CountingAllocator allocator;
  Evidence evidence;
  {
    Life life(allocator.desc(threads), folder.path(""), kRefits);
    for (const LifeStep& step : life.steps()) {
      const size_t before = nobodys.calls();
      EXPECT_EQ(step.call(), AWD_SUCCESS) << step.name << ": " << awdGetLastErrorMessage();
      EXPECT_EQ(nobodys.calls(), before) << step.name;
      if (step.after) step.after();
    }
    evidence = life.evidence();
  }
  EXPECT_EQ(allocator.blocks(), 0u);
  return evidence;
}

void expectSame(const Evidence& a, const Evidence& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, bytes] : a) EXPECT_TRUE(b.at(name) == bytes) << name << " differs";
}

struct Case {
  uint32_t threads;
  bool allLater;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.threads << (c.allLater ? " threads, from there on" : " threads, once");
}

class Memory : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Refused, Memory,
                         testing::Values(Case{1, false}, Case{1, true}, Case{2, false},
                                         Case{2, true}));

TEST_P(Memory, OfTheHostAtAnyCall) {
  const auto [threads, allLater] = GetParam();
  const Evidence expected = untroubled(threads);
  const TemporaryFolder folder;
  CountingAllocator allocator;
  size_t failures = 0;
  {
    Life life(allocator.desc(threads), folder.path(""), kRefits);
    for (const LifeStep& step : life.steps()) {
      AWDResult result = AWD_ERROR_UNKNOWN;
      for (size_t n = 1; result != AWD_SUCCESS; n = nextFault(n)) {
        allocator.refuse(allocator.calls() + n, allLater);
        result = step.call();
        if (result == AWD_SUCCESS) break;
        ++failures;
        ASSERT_EQ(result, AWD_ERROR_OUT_OF_MEMORY)
            << step.name << ", allocation " << n << ": " << awdGetLastErrorMessage();
        ASSERT_STRNE(awdGetLastErrorMessage(), "");
      }
      allocator.refuse(0, false);
      if (step.after) step.after();
    }
    expectSame(life.evidence(), expected);
  }
  EXPECT_EQ(allocator.blocks(), 0u) << "leaked";
  EXPECT_GT(failures, 300u);
  RecordProperty("failures", static_cast<int>(failures));
}

/// The same with the C++ heap, which what does not grow with the input comes from, and what
/// libraries below libawd take: exceptions of theirs come out as results, too.
class Heap : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(AllLater, Heap, testing::Bool());

TEST_P(Heap, RefusedAtAnyCall) {
  const Evidence expected = untroubled(1);
  const TemporaryFolder folder;
  CountingAllocator allocator;
  size_t failures = 0;
  {
    Life life(allocator.desc(1), folder.path(""), kRefits);
    const WatchedHeap heap;
    for (const LifeStep& step : life.steps()) {
      AWDResult result = AWD_ERROR_UNKNOWN;
      for (size_t n = 1;; n = nextFault(n)) {
        WatchedHeap::refuse(n, GetParam());
        result = step.call();
        const bool met = WatchedHeap::calls() >= n;
        WatchedHeap::refuse(0, false);
        if (result == AWD_SUCCESS || !met) break;
        ++failures;
        // Opening a file, OpenEXR makes of its lack of memory an error of the file (LIMITS.md).
        const bool isOpenExrs = std::string(step.name) == "awdWriteImageEXR";
        ASSERT_TRUE(result == AWD_ERROR_OUT_OF_MEMORY || (isOpenExrs && result == AWD_ERROR_IO))
            << step.name << ", call " << n << ": " << awdGetLastErrorMessage();
        ASSERT_STRNE(awdGetLastErrorMessage(), "");
      }
      ASSERT_EQ(result, AWD_SUCCESS) << step.name << ": " << awdGetLastErrorMessage();
      if (step.after) step.after();
    }
    expectSame(life.evidence(), expected);
  }
  EXPECT_EQ(allocator.blocks(), 0u) << "leaked";
  EXPECT_GT(failures, 60u);
  RecordProperty("failures", static_cast<int>(failures));
}

/// Names of folders, messages, a table of plugins: what libawd itself takes from the C++ heap.
TEST(HeapOfOurs, DoesNotGrowWithTheInput) {
  size_t bytes[2], hosts[2];
  const Life::Size sizes[2] = {{6, 0, 200}, {40, 12, 2000}};
  for (int large = 0; large < 2; ++large) {
    const TemporaryFolder folder;
    CountingAllocator allocator;
    Life life(allocator.desc(1), folder.path(""), kRefits, sizes[large]);
    const WatchedHeap heap;
    for (const LifeStep& step : life.steps()) {
      must(step.call());
      if (step.after) step.after();
    }
    bytes[large] = WatchedHeap::ownBytes();
    hosts[large] = allocator.bytes();
    EXPECT_LT(WatchedHeap::ownLargest(), 16384u);
  }
  EXPECT_GT(hosts[1], hosts[0] + 500000);
  EXPECT_LT(bytes[1], bytes[0] + 4096);
}

}  // namespace

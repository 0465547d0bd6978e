// SPDX-License-Identifier: Apache-2.0
#include "guide/patch_table.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace awd {
namespace {

std::atomic<int> alive{0};

struct Item {
  explicit Item(uint32_t n) : number(n) { ++alive; }
  ~Item() { --alive; }
  uint32_t number;
  std::atomic<int> touched{0};
};

Item* makeItem(uint32_t number) { return make<Item>(std::pmr::get_default_resource(), number); }

TEST(PatchTable, FindsWhatWasTouched) {
  {
    PatchTable<Item> table(std::pmr::get_default_resource());
    const uint32_t numbers[] = {0u, 1u, 255u, 256u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu};
    EXPECT_EQ(table.find(0), nullptr);
    for (const uint32_t n : numbers) {
      EXPECT_EQ(table.touch(n, [&] { return makeItem(n); }).number, n);
    }
    for (const uint32_t n : numbers) EXPECT_EQ(table.find(n)->number, n);
    EXPECT_EQ(table.find(2), nullptr);
    std::vector<uint32_t> order;
    table.forEach([&](uint32_t n, const Item&) { order.push_back(n); });
    EXPECT_EQ(order, std::vector<uint32_t>(std::begin(numbers), std::end(numbers)));
  }
  EXPECT_EQ(alive, 0);
}

TEST(PatchTable, ThreadsMeetInOneItem) {
  {
    PatchTable<Item> table(std::pmr::get_default_resource());
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&] {
        for (uint32_t n = 0; n < 5000; ++n) {
          ++table.touch(n * 65537u, [&] { return makeItem(n); }).touched;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    int count = 0;
    table.forEach([&](uint32_t, const Item& item) {
      EXPECT_EQ(item.touched, 4);
      ++count;
    });
    EXPECT_EQ(count, 5000);
    EXPECT_EQ(alive, 5000);  // those that lost a race are gone
  }
  EXPECT_EQ(alive, 0);
}

TEST(PatchTable, RemovesWhatIsGone) {
  alive = 0;
  {
    std::pmr::memory_resource* memory = std::pmr::get_default_resource();
    PatchTable<Item> table(memory);
    for (uint32_t n = 0; n < 1000; ++n) {
      table.touch(n * 12345u, [&] { return make<Item>(memory, n); });
    }
    table.removeIf([](const Item& item) { return item.number % 3 != 0; });
    EXPECT_EQ(alive, 334);
    for (uint32_t n = 0; n < 1000; ++n) {
      const Item* item = table.find(n * 12345u);
      ASSERT_EQ(item != nullptr, n % 3 == 0);
      if (item) {
        EXPECT_EQ(item->number, n);
      }
    }
  }
  EXPECT_EQ(alive, 0);
}

}  // namespace
}  // namespace awd

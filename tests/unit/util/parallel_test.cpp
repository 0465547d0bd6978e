// SPDX-License-Identifier: Apache-2.0
#include "util/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "util/error.h"

namespace {

using awd::Parallel;
std::pmr::memory_resource* const kHeap = std::pmr::new_delete_resource();

class Threads : public testing::TestWithParam<uint32_t> {};

TEST_P(Threads, EveryIndexOnce) {
  Parallel parallel(kHeap, GetParam(), nullptr, nullptr);
  for (std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
    std::vector<std::atomic<int>> calls(count);
    parallel.forEach(count, [&](std::size_t i) { ++calls[i]; });
    for (const auto& n : calls) EXPECT_EQ(n, 1);
  }
}

TEST_P(Threads, LoopsNest) {
  Parallel parallel(kHeap, GetParam(), nullptr, nullptr);
  std::atomic<int> calls{0};
  parallel.forEach(20, [&](std::size_t) { parallel.forEach(20, [&](std::size_t) { ++calls; }); });
  EXPECT_EQ(calls, 400);
}

TEST_P(Threads, AnExceptionArrivesAfterTheLoop) {
  Parallel parallel(kHeap, GetParam(), nullptr, nullptr);
  std::atomic<int> running{0};
  try {
    parallel.forEach(1000, [&](std::size_t i) {
      ++running;
      const bool bad = i == 500;
      if (bad) {
        --running;
        throw std::runtime_error("at 500");
      }
      --running;
    });
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "at 500");
  }
  EXPECT_EQ(running, 0);
  // The loop can be used again.
  std::atomic<int> calls{0};
  parallel.forEach(10, [&](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 10);
}

TEST_P(Threads, WithinRunsOnceAndPassesExceptionsOn) {
  Parallel parallel(kHeap, GetParam(), nullptr, nullptr);
  int calls = 0;
  parallel.within([&] { ++calls; });
  EXPECT_EQ(calls, 1);
  EXPECT_THROW(parallel.within([] { throw std::runtime_error("x"); }), std::runtime_error);
}

TEST_P(Threads, NoMoreThreadsThanAskedFor) {
  Parallel parallel(kHeap, GetParam(), nullptr, nullptr);
  std::atomic<unsigned> now{0}, most{0};
  parallel.forEach(200, [&](std::size_t) {
    const unsigned n = ++now;
    unsigned seen = most;
    while (n > seen && !most.compare_exchange_weak(seen, n)) {
    }
    std::this_thread::yield();
    --now;
  });
  EXPECT_LE(most, parallel.threads());
}

INSTANTIATE_TEST_SUITE_P(Parallel, Threads, testing::Values(0u, 1u, 2u, 5u));

TEST(Parallel, KnowsItsThreads) {
  EXPECT_EQ(Parallel(kHeap, 3, nullptr, nullptr).threads(), 3u);
  EXPECT_GE(Parallel(kHeap, 0, nullptr, nullptr).threads(), 1u);
}

TEST(Parallel, OneThreadIsTheCallersInOrder) {
  Parallel parallel(kHeap, 1, nullptr, nullptr);
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> order;
  parallel.forEach(100, [&](std::size_t i) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    order.push_back(i);
  });
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(Parallel, OfSeveralExceptionsTheLowestIndexWins) {
  Parallel parallel(kHeap, 1, nullptr, nullptr);
  std::size_t calls = 0;
  try {
    parallel.forEach(100, [&](std::size_t i) {
      ++calls;
      throw std::runtime_error(std::to_string(i));
    });
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "0");
  }
  EXPECT_EQ(calls, 1u) << "indices not yet begun are skipped";
}

/// A host's scheduler, honest or not.
struct Host {
  int loops = 0;
  std::size_t skip = SIZE_MAX;    ///< index that it forgets
  std::size_t repeat = SIZE_MAX;  ///< index that it runs twice
  std::size_t beyond = 0;         ///< index that it adds

  static void AWD_CALL run(void* user, std::size_t count, AWDTaskFn task, void* data) {
    Host& host = *static_cast<Host*>(user);
    ++host.loops;
    std::thread back([&] {
      for (std::size_t i = count; i-- > count / 2;) {
        if (i != host.skip) task(data, i);
        if (i == host.repeat) task(data, i);
      }
      if (host.beyond > 0) task(data, host.beyond);
    });
    for (std::size_t i = 0; i < count / 2; ++i) task(data, i);
    back.join();
  }
};

TEST(HostLoop, RunsEverything) {
  Host host;
  Parallel parallel(kHeap, 4, Host::run, &host);
  std::vector<std::atomic<int>> calls(100);
  parallel.forEach(calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const auto& n : calls) EXPECT_EQ(n, 1);
  EXPECT_EQ(host.loops, 1);
}

TEST(HostLoop, ExceptionsDoNotPassThroughTheHost) {
  Host host;
  Parallel parallel(kHeap, 4, Host::run, &host);
  EXPECT_THROW(parallel.forEach(100,
                                [](std::size_t i) {
                                  if (i == 70) throw std::runtime_error("x");
                                }),
               std::runtime_error);
}

/// No index is run twice, and none that there is not, whatever the host does.
void expectComplaint(Host& host, const char* text) {
  Parallel parallel(kHeap, 4, Host::run, &host);
  std::vector<std::atomic<int>> calls(100);
  try {
    parallel.forEach(100, [&](std::size_t i) { ++calls.at(i); });
    FAIL() << "no error";
  } catch (const awd::Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_INVALID_OPERATION);
    EXPECT_STREQ(error.what(), text);
  }
  for (std::size_t i = 0; i < calls.size(); ++i) EXPECT_EQ(calls[i], i != host.skip);
}

TEST(HostLoop, OneThatSkipsAnIndexIsCaught) {
  Host host;
  host.skip = 60;
  expectComplaint(host, "the host's parallelFor left out index 60: it must run each of 100 once");
}

TEST(HostLoop, OneThatRepeatsAnIndexIsCaught) {
  Host host;
  host.repeat = 60;
  expectComplaint(host, "the host's parallelFor repeated index 60: it must run each of 100 once");
}

TEST(HostLoop, OneThatGoesTooFarIsCaught) {
  for (const std::size_t beyond : {std::size_t{100}, SIZE_MAX}) {
    Host host;
    host.beyond = beyond;
    const std::string text = "the host's parallelFor went on to index " + std::to_string(beyond) +
                             ": it must run each of 100 once";
    expectComplaint(host, text.c_str());
  }
}

TEST(HostLoop, OneThatSkipsAndRepeatsIsCaught) {
  Host host;
  host.skip = 60;
  host.repeat = 70;  // as many calls as there should be
  expectComplaint(host, "the host's parallelFor repeated index 70: it must run each of 100 once");
}

}  // namespace

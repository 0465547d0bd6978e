// SPDX-License-Identifier: Apache-2.0
// Threads that end: between calls, cancelled within one, and from within a callback; devices at
// work at once.
#include <gtest/gtest.h>
#include <pthread.h>

#include <csignal>
#include <thread>

#include "faults/caller_back.h"
#include "faults/life.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

/// A call in a thread that has been told to end before it.
struct DoomedCall {
  const LifeStep* step = nullptr;
  AWDResult result = AWD_ERROR_UNKNOWN;
  std::string message;
  bool returned = false, survived = false;

  void run() {
    pthread_t thread = {};
    ASSERT_EQ(pthread_create(
                  &thread, nullptr,
                  [](void* self) -> void* {
                    static_cast<DoomedCall*>(self)->live();
                    return nullptr;
                  },
                  this),
              0);
    void* ending = nullptr;
    pthread_join(thread, &ending);
    EXPECT_TRUE(returned) << step->name;
    EXPECT_FALSE(survived);
    EXPECT_EQ(ending, PTHREAD_CANCELED) << step->name;
  }

 private:
  void live() {
    pthread_cancel(pthread_self());
    result = step->call();
    if (result != AWD_SUCCESS) message = awdGetLastErrorMessage();
    returned = true;
    pthread_testcancel();
    survived = true;
  }
};

/// Every call of a host's life in a thread of its own, which is cancelled while in it.
TEST(Threads, ThatAreCancelledEndAfterTheCall) {
  const TemporaryFolder folder;
  CountingAllocator allocator;
  std::map<std::string, std::vector<char>> evidence[2];
  for (int doomed = 0; doomed < 2; ++doomed) {
    Life life(allocator.desc(1), folder.path(""), false);
    for (const LifeStep& step : life.steps()) {
      if (doomed) {
        DoomedCall call;
        call.step = &step;
        call.run();
        ASSERT_EQ(call.result, AWD_SUCCESS) << step.name << ": " << call.message;
      } else {
        must(step.call());
      }
      if (step.after) step.after();
    }
    evidence[doomed] = life.evidence();
  }
  EXPECT_TRUE(evidence[0] == evidence[1]);
  EXPECT_EQ(allocator.blocks(), 0u);
}

class ThreadsThatLeave : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, ThreadsThatLeave, testing::Values(1u, 2u));

/// There is no way back through what is at work in other threads: the process ends at once, rather
/// than waiting for ever or going on with what is half done.
TEST_P(ThreadsThatLeave, FromWithinACallbackEndTheProcess) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        CallerBack host;
        Begun begun(host, GetParam());
        host.onCall("pass", 2, [] { pthread_exit(nullptr); });
        awdRenderPass(begun.render, 3, nullptr);
        std::_Exit(0);
      },
      testing::KilledBySignal(SIGABRT), "");
}

/// Alone, and two devices of other numbers of threads at once.
TEST(Threads, OfTwoDevicesAtOnceGiveTheSameBits) {
  const auto bits = [](uint32_t threads, const std::string& folder) {
    CountingAllocator allocator;
    Life life(allocator.desc(threads), folder, false, {24, 2, 200});
    for (const LifeStep& step : life.steps()) {
      must(step.call());
      if (step.after) step.after();
    }
    return life.evidence();
  };
  const TemporaryFolder folders[3];
  const auto alone = bits(1, folders[2].path(""));
  std::map<std::string, std::vector<char>> together[2];
  std::thread one([&] { together[0] = bits(1, folders[0].path("")); });
  std::thread three([&] { together[1] = bits(3, folders[1].path("")); });
  one.join();
  three.join();
  for (const auto& evidence : together) {
    for (const auto& [name, bytes] : alone) EXPECT_TRUE(evidence.at(name) == bytes) << name;
  }
}

}  // namespace

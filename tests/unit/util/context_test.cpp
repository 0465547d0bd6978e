// SPDX-License-Identifier: Apache-2.0
#include "util/context.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "util/error.h"

namespace {

using namespace awd;

TEST(Context, LogsToTheHostOrNowhere) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  Context::make(desc)->log(AWD_LOG_ERROR, "nobody hears");
  std::vector<std::string> lines;
  desc.log = [](void* user, int32_t severity, const char* text) {
    static_cast<std::vector<std::string>*>(user)->push_back(std::to_string(severity) + text);
  };
  desc.logUser = &lines;
  const Ref<Context> context = Context::make(desc);
  context->log(AWD_LOG_WARNING, "%d of %s", 3, "four");
  context->log(AWD_LOG_INFO, "%s", std::string(5000, 'x').c_str());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "13 of four");
  EXPECT_LT(lines[1].size(), 5000u);
}

TEST(Context, LivesInTheHostsMemory) {
  std::size_t blocks = 0;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.alloc = [](void* user, std::size_t size, std::size_t alignment) {
    ++*static_cast<std::size_t*>(user);
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  };
  desc.free = [](void* user, void* ptr, std::size_t, std::size_t) {
    --*static_cast<std::size_t*>(user);
    std::free(ptr);
  };
  desc.allocUser = &blocks;
  {
    const Ref<Context> context = Context::make(desc);
    EXPECT_EQ(blocks, 1u);
    void* more = context->memory()->allocate(100, 8);
    EXPECT_EQ(blocks, 2u);
    context->memory()->deallocate(more, 100, 8);
  }
  EXPECT_EQ(blocks, 0u);
}

TEST(Context, MakeGivesBackWhatAConstructorLeft) {
  struct Throwing {
    Throwing() { throw 1; }
  };
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  const Ref<Context> context = Context::make(desc);
  EXPECT_THROW(make<Throwing>(context->memory()), int);  // the leak checker sees the rest
}

/// A host that keeps the fractions it was told, and says stop at one of them.
struct Watcher {
  std::vector<double> fractions;
  std::size_t stopAt = SIZE_MAX;
  const void* object = nullptr;
  std::atomic<int> inside{0};
  bool overlapped = false;
  bool wrong = false;

  static int32_t AWD_CALL watch(void* user, const AWDProgress* progress) {
    Watcher& watcher = *static_cast<Watcher*>(user);
    if (++watcher.inside > 1) watcher.overlapped = true;
    watcher.wrong |= std::string(progress->operation) != "pass" ||
                     progress->object != watcher.object ||
                     progress->structSize != sizeof(AWDProgress);
    watcher.fractions.push_back(progress->fraction);
    const bool goOn = watcher.fractions.size() != watcher.stopAt;
    --watcher.inside;
    return goOn;
  }
};

class ProgressTest : public testing::Test {
 protected:
  Ref<Context> context() {
    AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
    desc.progress = Watcher::watch;
    desc.progressUser = &watcher_;
    return Context::make(desc);
  }
  Watcher watcher_;
};

TEST_F(ProgressTest, TellsEveryStep) {
  const Ref<Context> c = context();
  watcher_.object = &watcher_;
  Progress progress(*c, "pass", &watcher_, 4);
  for (int i = 0; i < 4; ++i) progress.step();
  EXPECT_EQ(watcher_.fractions, (std::vector<double>{0.25, 0.5, 0.75, 1.0}));
  EXPECT_FALSE(watcher_.wrong);
  EXPECT_FALSE(progress.cancelled());
  progress.throwIfCancelled();
}

TEST_F(ProgressTest, CancelsOnce) {
  const Ref<Context> c = context();
  watcher_.stopAt = 2;
  Progress progress(*c, "pass", nullptr, 10);
  progress.step();
  EXPECT_FALSE(progress.cancelled());
  progress.step();
  EXPECT_TRUE(progress.cancelled());
  progress.step();  // the host changes its mind too late
  EXPECT_TRUE(progress.cancelled());
  try {
    progress.throwIfCancelled();
    FAIL() << "not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_CANCELLED);
    EXPECT_STREQ(error.what(), "pass: cancelled by the progress callback");
  }
}

TEST_F(ProgressTest, NeverFallsAndNeverOverlaps) {
  const Ref<Context> c = context();
  constexpr int kThreads = 4, kSteps = 5000;
  Progress progress(*c, "pass", nullptr, kThreads * kSteps);
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < kSteps; ++i) progress.step();
    });
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_FALSE(watcher_.fractions.empty());
  for (std::size_t i = 1; i < watcher_.fractions.size(); ++i) {
    EXPECT_GE(watcher_.fractions[i], watcher_.fractions[i - 1]);
  }
  EXPECT_GT(watcher_.fractions.front(), 0.0);
  EXPECT_EQ(watcher_.fractions.back(), 1.0);
  EXPECT_FALSE(watcher_.overlapped);
}

/// Another thread takes the last step while the host is told of the one before.
TEST(Progress, TellsOfTheEndWhoeverComesToIt) {
  struct Host {
    Progress* progress = nullptr;
    std::vector<double> fractions;
  } host;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.progressUser = &host;
  desc.progress = [](void* user, const AWDProgress* told) -> int32_t {
    Host& h = *static_cast<Host*>(user);
    h.fractions.push_back(told->fraction);
    if (h.fractions.size() == 1) std::thread([&h] { h.progress->step(); }).join();
    return 1;
  };
  const Ref<Context> context = Context::make(desc);
  Progress progress(*context, "pass", nullptr, 2);
  host.progress = &progress;
  progress.step();
  EXPECT_EQ(host.fractions, (std::vector<double>{0.5, 1.0}));
}

TEST(Progress, WithoutAHostNothingIsCancelled) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  const Ref<Context> context = Context::make(desc);
  Progress progress(*context, "pass", nullptr, 0);
  progress.step();
  EXPECT_FALSE(progress.cancelled());
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
#include "util/ref.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace {

using awd::Ref;

class Counted final : public awd::RefCounted {
 public:
  explicit Counted(int& destroyed) : destroyed_(destroyed) {}

 private:
  void destroy() noexcept override {
    ++destroyed_;
    delete this;
  }
  int& destroyed_;
};

TEST(Ref, TheLastOwnerDestroys) {
  int destroyed = 0;
  {
    Ref<Counted> a = Ref<Counted>::adopt(new Counted(destroyed));
    {
      const Ref<Counted> b = a, c = Ref<Counted>::share(a.get());
      EXPECT_EQ(b.get(), c.get());
      a = Ref<Counted>();
      EXPECT_FALSE(a);
      EXPECT_EQ(destroyed, 0);
    }
    EXPECT_EQ(destroyed, 1);
  }
  EXPECT_EQ(destroyed, 1);
}

TEST(Ref, MovesAndDetachesWithoutCounting) {
  int destroyed = 0;
  Ref<Counted> a = Ref<Counted>::adopt(new Counted(destroyed));
  Ref<Counted> b = std::move(a);
  EXPECT_FALSE(a);  // NOLINT: moved from is empty
  Counted* plain = b.detach();
  EXPECT_FALSE(b);
  EXPECT_EQ(destroyed, 0);
  plain->release();
  EXPECT_EQ(destroyed, 1);
}

TEST(Ref, AssigningToItselfIsHarmless) {
  int destroyed = 0;
  Ref<Counted> a = Ref<Counted>::adopt(new Counted(destroyed));
  const Ref<Counted>& same = a;
  a = same;
  EXPECT_TRUE(a);
  EXPECT_EQ(destroyed, 0);
}

TEST(Ref, NothingIsSharedAsNothing) { EXPECT_FALSE(Ref<Counted>::share(nullptr)); }

TEST(Ref, CountsFromManyThreads) {
  int destroyed = 0;
  {
    const Ref<Counted> a = Ref<Counted>::adopt(new Counted(destroyed));
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([copy = a] {
        for (int i = 0; i < 10000; ++i) Ref<Counted> another = copy;
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(destroyed, 0);
  }
  EXPECT_EQ(destroyed, 1);
}

}  // namespace

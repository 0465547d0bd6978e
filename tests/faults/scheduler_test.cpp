// SPDX-License-Identifier: Apache-2.0
// A host whose parallelFor does not do what it must: every loop either comes to the bits of an
// honest one or fails, changes nothing and says what the host has done.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <thread>

#include "faults/caller_back.h"
#include "support/expect.h"
#include "support/random.h"
#include "support/soak.h"

namespace {

using namespace awdtest;

/// Calls indices in any order from several threads; leaves some out, repeats some, adds some.
class WildScheduler {
 public:
  explicit WildScheduler(uint64_t seed) : random_(seed) {}

  AWDDeviceDesc desc() {
    AWDDeviceDesc result = AWD_DEVICE_DESC_INIT;
    result.parallelFor = [](void* user, size_t count, AWDTaskFn task, void* data) {
      static_cast<WildScheduler*>(user)->run(count, task, data);
    };
    result.parallelForUser = this;
    return result;
  }
  bool loose = false;  ///< before, it is honest
  /// Whether the last loop ran each index once.
  bool wasHonest() const { return honest_; }

 private:
  size_t any(size_t limit) { return random_.bits() % limit; }

  size_t beyond(size_t count) {
    const size_t some[] = {count, count + 1, size_t{1} << 32, ~size_t{0}, random_.bits()};
    return std::max(count, some[any(5)]);
  }

  void run(size_t count, AWDTaskFn task, void* data) {
    std::vector<size_t> every(count);
    std::iota(every.begin(), every.end(), size_t{0});
    std::vector<size_t> indices = every;
    for (size_t faults = loose ? any(3) : 0; faults > 0 && !indices.empty(); --faults) {
      const size_t at = any(indices.size());
      const size_t kind = any(3);
      if (kind == 0) indices.erase(indices.begin() + static_cast<std::ptrdiff_t>(at));
      if (kind == 1) indices.push_back(indices[at]);
      if (kind == 2) indices.push_back(beyond(count));
    }
    honest_ = std::is_permutation(every.begin(), every.end(), indices.begin(), indices.end());
    for (size_t i = indices.size(); i > 1; --i) std::swap(indices[i - 1], indices[any(i)]);

    const size_t threads = 1 + any(3);
    std::vector<std::thread> helpers;
    for (size_t t = 0; t < threads; ++t) {
      helpers.emplace_back([&indices, t, threads, task, data] {
        for (size_t i = t; i < indices.size(); i += threads) task(data, indices[i]);
      });
    }
    for (std::thread& helper : helpers) helper.join();
  }

  Random random_;
  bool honest_ = true;
};

/// Repeats the call until the scheduler was honest; each failure before leaves all as it was.
size_t failures(const WildScheduler& wild, const Begun& begun,
                const std::function<AWDResult()>& call) {
  const Outcome before = outcomeOf(begun.render);
  for (size_t failed = 0;; ++failed) {
    const AWDResult result = call();
    if (wild.wasHonest()) {
      EXPECT_EQ(result, AWD_SUCCESS) << awdGetLastErrorMessage();
      return failed;
    }
    expectFailure(result, AWD_ERROR_INVALID_OPERATION, {"the host's parallelFor", "once"});
    expectSameOutcome(outcomeOf(begun.render), before);
  }
}

TEST(Scheduler, AWildOneIsToldOfAndChangesNothing) {
  WildScheduler wild(17);
  CallerBack quiet;
  Begun begun(wild.desc(), 40), undisturbed(quiet, 1, 40);
  wild.loose = true;
  size_t failed = 0;
  for (size_t round = soakSize(4, 200); round > 0; --round) {
    failed += failures(wild, begun, [&] { return awdAdaptField(begun.field, nullptr); });
    must(awdAdaptField(undisturbed.field, nullptr));
    failed += failures(wild, begun, [&] { return awdRenderPass(begun.render, 1, nullptr); });
    must(awdRenderPass(undisturbed.render, 1, nullptr));
    expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
  }
  EXPECT_GT(failed, 3u);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Processes that fork: the parent goes on, and the child may use what was not at work.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "faults/caller_back.h"
#include "faults/life.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

/// What became of a child: 0 if it did what it should.
int inAChild(const std::function<bool()>& act) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(120);  // a child that hangs is killed, and its parent told
    bool good = false;
    try {
      good = act();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "in the child: %s\n", error.what());
    }
    _exit(good ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

class Forks : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, Forks, testing::Values(1u, 3u));

TEST_P(Forks, TheParentGoesOnAndTheChildToo) {
  CallerBack host, quiet;
  Begun begun(host, GetParam()), undisturbed(quiet, GetParam());
  must(awdAdaptField(undisturbed.field, nullptr));
  must(awdRenderPass(undisturbed.render, 3, nullptr));
  const std::vector<float> expected = readFilm(undisturbed.render).radiance;

  const auto goOn = [&] {
    must(awdAdaptField(begun.field, nullptr));
    must(awdRenderPass(begun.render, 3, nullptr));
    return readFilm(begun.render).radiance == expected;
  };
  EXPECT_EQ(inAChild(goOn), 0) << "with what its parent made";
  EXPECT_TRUE(goOn());
}

std::map<std::string, std::vector<char>> lifeOf(uint32_t threads) {
  const TemporaryFolder folder;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = threads;
  Life life(desc, folder.path(""), false);
  for (const LifeStep& step : life.steps()) {
    must(step.call());
    if (step.after) step.after();
  }
  return life.evidence();
}

/// In a process of its own, in which no thread has been started yet.
TEST(Fork, BeforeThreadsAreStartedTheChildLivesOnItsOwn) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        const auto expected = lifeOf(1);
        const int status = inAChild([&] { return lifeOf(3) == expected; });
        std::_Exit(status == 0 && lifeOf(3) == expected ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

/// Embree works with oneTBB, whose locks nobody in the child may ever leave: rather an error than a
/// call that never returns.
TEST(Fork, AfterThreadsAreStartedTheChildCommitsNoScene) {
  CallerBack host;
  Begun begun(host, 3);
  const auto scene = [&](uint32_t threads) {
    const Device device = newDevice(threads);
    const Scene open = lampRoom().upload(device);
    return awdCommitScene(open);
  };
  EXPECT_EQ(inAChild([&] {
              return scene(3) == AWD_ERROR_INVALID_OPERATION &&
                     std::string(awdGetLastErrorMessage()).find("fork") != std::string::npos &&
                     scene(1) == AWD_ERROR_INVALID_OPERATION;
            }),
            0);
  EXPECT_EQ(scene(3), AWD_SUCCESS);
}

/// In a pass, on whichever thread reports.
TEST_P(Forks, InACallbackTheChildEndsAndTheParentGoesOn) {
  CallerBack host, quiet;
  Begun begun(host, GetParam()), undisturbed(quiet, GetParam());
  int status = -1;
  host.onCall("pass", 2, [&] { status = inAChild([] { return true; }); });
  must(awdRenderPass(begun.render, 3, nullptr));
  EXPECT_EQ(status, 0);
  must(awdRenderPass(undisturbed.render, 3, nullptr));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

}  // namespace

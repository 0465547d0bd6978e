// SPDX-License-Identifier: Apache-2.0
// Cancelled at every progress call of every function that has them: nothing is changed, and the
// same call again comes to the bits of one that was never cancelled.
#include <gtest/gtest.h>

#include <array>

#include "faults/caller_back.h"
#include "support/expect.h"
#include "support/soak.h"

namespace {

using namespace awdtest;

class Cancelled : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, Cancelled, testing::Values(1u, 3u));

/// Cancels `call` at its first progress call, then at its second, and so on until it comes to its
/// end; in ./run check some of them are left out. `check` looks after each. With several threads a
/// call may come to its end though it was to be cancelled: which thread reports is not foreseen.
size_t cancelEach(CallerBack& host, const char* operation, const std::function<AWDResult()>& call,
                  const std::function<void()>& check) {
  size_t cancelled = 0;
  for (size_t k = 1;; k += soakSize(1 + static_cast<long>(k) / 4, 1)) {
    host.onCall(operation, k, nullptr, true);
    const AWDResult result = call();
    if (!host.acted) {
      EXPECT_EQ(result, AWD_SUCCESS) << awdGetLastErrorMessage();
      return cancelled;
    }
    expectFailure(result, AWD_ERROR_CANCELLED, {operation});
    ++cancelled;
    check();
  }
}

TEST_P(Cancelled, InEachOperation) {
  CallerBack host, quiet;
  Begun begun(host, GetParam(), 64), undisturbed(quiet, GetParam(), 64);
  const auto same = [&](const Outcome& before) {
    return [&begun, before] { expectSameOutcome(outcomeOf(begun.render), before); };
  };
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  EXPECT_GE(cancelEach(
                host, "commit", [&] { return awdCommitScene(begun.scene); },
                [&] { must(awdGetSceneInfo(begun.scene, &info)); }),
            5u);

  Outcome before = outcomeOf(undisturbed.render);
  EXPECT_GE(cancelEach(
                host, "adapt", [&] { return awdAdaptField(begun.field, nullptr); }, same(before)),
            1u);
  must(awdAdaptField(undisturbed.field, nullptr));

  before = outcomeOf(undisturbed.render);
  expectSameOutcome(outcomeOf(begun.render), before);
  EXPECT_GE(
      cancelEach(
          host, "pass", [&] { return awdRenderPass(begun.render, 2, nullptr); }, same(before)),
      GetParam() == 1 ? 5u : 1u);
  must(awdRenderPass(undisturbed.render, 2, nullptr));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

/// One tile of so many samples takes minutes: nobody waits for its end.
TEST_P(Cancelled, WithinATile) {
  CallerBack host, quiet;
  Begun begun(host, GetParam(), 16), undisturbed(quiet, GetParam(), 16);
  host.onCall("pass", 3, nullptr, true);
  expectFailure(awdRenderPass(begun.render, 1u << 22, nullptr), AWD_ERROR_CANCELLED, {"pass"});
  EXPECT_EQ(host.calls, 3u);
  EXPECT_NEAR(host.farthest, 3.0 * 4096 / (256.0 * (1u << 22)), 1e-12);
  must(awdAdaptField(begun.field, nullptr));
  must(awdAdaptField(undisturbed.field, nullptr));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

/// A field that is wrong by thirty powers of ten would have every ray split, and those again.
TEST_P(Cancelled, WithinAPathThatSplits) {
  CallerBack host;
  const AWDDeviceDesc deviceDesc = host.desc(GetParam());
  const Device device = newDevice(&deviceDesc);
  const Scene scene = lampRoom().commit(device);
  Field field;
  must(awdNewSceneField(scene, nullptr, field.out()));
  must(awdSetFieldScale(field, 1e30));
  const float normals[][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const float* normal : normals) {
    uint32_t patch = 0;
    must(awdFindPatch(field, std::array<float, 3>{1, 1, 1}.data(), normal, &patch));
    for (const double u : {0.1, 0.4, 0.6, 0.9}) {
      AWDDirectionSample sample = {};
      must(awdSampleField(field, patch, normal, std::array<double, 3>{u, 1.0 - u, 0.5}.data(),
                          &sample));
      must(awdRecordField(field, patch, &sample, 1e30));
    }
  }
  must(awdAdaptField(field, nullptr));
  const AWDCamera camera = lampRoomCamera(4);
  const Render render = newRender(scene, renderDesc(camera, AWD_GUIDE_ADAPTIVE, 3), field);
  AWDPassStatistics first = AWD_PASS_STATISTICS_INIT;
  must(awdRenderPass(render, 8, &first));  // from the second pass on a pixel's brightness is known
  AWDPassStatistics second = AWD_PASS_STATISTICS_INIT;
  must(awdRenderPass(render, 2, &second));
  EXPECT_GT(second.rays, 4 * first.rays) << "nothing is split";
  EXPECT_LT(second.rays, uint64_t{4 * 4 * 2} * 100000);
  host.onCall("pass", 1, nullptr, true);
  expectFailure(awdRenderPass(render, 1u << 20, nullptr), AWD_ERROR_CANCELLED, {"pass"});
  EXPECT_LT(host.farthest, 1e-4);
}

/// Passes that were finished stay, and a schedule that is resumed comes to the same end.
TEST_P(Cancelled, InASchedule) {
  CallerBack host, quiet;
  Begun begun(host, GetParam(), 32), undisturbed(quiet, GetParam(), 32);
  const uint32_t passes[] = {2, 2, 3};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = passes;
  schedule.passCount = 3;
  schedule.resume = 1;
  for (const char* operation : {"adapt", "pass"}) {
    cancelEach(
        host, operation, [&] { return awdRenderPasses(begun.render, &schedule); }, [] {});
  }
  must(awdRenderPasses(undisturbed.render, &schedule));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

TEST_P(Cancelled, InAPartOfAPass) {
  CallerBack host, quiet;
  Begun begun(host, GetParam(), 64), undisturbed(quiet, GetParam(), 64);
  const uint32_t passes[] = {2, 2};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = passes;
  schedule.passCount = 2;
  uint32_t samples = 0;
  size_t sums = 0, maxima = 0;
  EXPECT_GE(
      cancelEach(
          host, "pass", [&] { return awdRenderPassPart(begun.render, &schedule, 0, 1, &samples); },
          [&] {
            expectFailure(awdExportPass(begun.render, nullptr, 0, &sums, &maxima),
                          AWD_ERROR_INVALID_OPERATION);
          }),
      1u);
  must(awdExportPass(begun.render, nullptr, 0, &sums, &maxima));
  std::vector<uint64_t> numbers(sums + maxima);
  must(awdExportPass(begun.render, numbers.data(), numbers.size(), &sums, &maxima));
  must(awdImportPass(begun.render, numbers.data(), numbers.size(), nullptr));
  schedule.resume = 1;
  must(awdRenderPasses(undisturbed.render, &schedule));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

#ifdef AWD_TEST_REFIT
/// No other density takes long enough to be cancelled.
TEST_P(Cancelled, InARefit) {
  CallerBack host;
  const AWDDeviceDesc deviceDesc = host.desc(GetParam());
  const Device device = newDevice(&deviceDesc);
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 2;
  desc.estimator = AWD_ESTIMATOR_REFIT;
  AWDDensity density = nullptr;
  must(awdNewDensity(device, &desc, &density));
  std::vector<double> points, values;
  for (int i = 0; i < 400; ++i) {
    points.insert(points.end(), {(i % 20 + 0.5) / 20, (i / 20 + 0.5) / 20});
    values.push_back(1.0 / (0.05 + points[points.size() - 2] * points.back()));
  }
  must(awdRecordDensity(density, values.size(), points.data(), nullptr, nullptr, values.data()));
  const auto bytesOf = [&density] {
    size_t size = 0;
    must(awdSaveDensity(density, nullptr, 0, &size));
    std::vector<char> bytes(size);
    must(awdSaveDensity(density, bytes.data(), size, &size));
    return bytes;
  };
  const std::vector<char> before = bytesOf();
  AWDDensity twin = nullptr;
  must(awdLoadDensity(device, before.data(), before.size(), &twin));
  EXPECT_GE(cancelEach(
                host, "adapt", [&] { return awdAdaptDensity(density, nullptr); },
                [&] { EXPECT_TRUE(bytesOf() == before); }),
            1u);
  host.onCall("none", 0, nullptr);
  must(awdAdaptDensity(twin, nullptr));
  const std::vector<char> after = bytesOf();
  awdReleaseDensity(density);
  density = twin;
  EXPECT_TRUE(bytesOf() == after);
  awdReleaseDensity(density);
}
#endif

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Progress, cancellation and the log.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>

#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

/// The host's callbacks: notes what it hears, and says stop at a call of its choice.
struct Host {
  struct Call {
    std::string operation;
    const void* object;
    double fraction;
  };
  std::vector<Call> calls;
  std::atomic<bool> busy{false};
  size_t stopAt = 0;  // 1 for the first call; 0: never
  std::vector<std::string> log;

  AWDDeviceDesc desc(uint32_t threads) {
    AWDDeviceDesc result = AWD_DEVICE_DESC_INIT;
    result.threads = threads;
    result.progress = [](void* user, const AWDProgress* progress) -> int32_t {
      Host& host = *static_cast<Host*>(user);
      EXPECT_FALSE(host.busy.exchange(true)) << "two reports at once";
      EXPECT_GE(progress->structSize, sizeof(AWDProgress));
      host.calls.push_back({progress->operation, progress->object, progress->fraction});
      const bool goOn = host.calls.size() != host.stopAt;
      host.busy = false;
      return goOn;
    };
    result.progressUser = this;
    result.log = [](void* user, int32_t, const char* text) {
      static_cast<Host*>(user)->log.push_back(text);
    };
    result.logUser = this;
    return result;
  }
  void expect(const char* operation, const void* object) const {
    double before = 0.0;
    for (const Call& call : calls) {
      EXPECT_EQ(call.operation, operation);
      EXPECT_EQ(call.object, object);
      EXPECT_GE(call.fraction, before);
      EXPECT_LE(call.fraction, 1.0);
      before = call.fraction;
    }
  }
};

std::vector<std::vector<double>> densitiesOf(AWDField field) {
  size_t count = 0;
  must(awdGetFieldPatches(field, nullptr, 0, &count));
  std::vector<uint32_t> patches(count);
  must(awdGetFieldPatches(field, patches.data(), count, &count));
  std::vector<std::vector<double>> result;
  for (const uint32_t patch : patches) {
    AWDPatchInfo info = AWD_PATCH_INFO_INIT;
    must(awdGetPatchInfo(field, patch, &info));
    std::vector<double> c(size_t{info.axisCount} * info.axisCount);
    must(awdGetPatchCoefficients(field, patch, c.data(), c.size()));
    c.push_back(static_cast<double>(patch));
    c.push_back(static_cast<double>(info.samples));
    result.push_back(c);
  }
  return result;
}

/// A render with a field of the test's own after a first pass and adapt.
struct Begun {
  explicit Begun(Host& host, uint32_t threads) {
    const AWDDeviceDesc deviceDesc = host.desc(threads);
    device = newDevice(&deviceDesc);
    scene = lampRoom().commit(device);
    field = newField(device);
    const AWDCamera view = lampRoomCamera(48);
    render = newRender(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 3), field);
    must(awdRenderPass(render, 2, nullptr));
    must(awdAdaptField(field, nullptr));
    host.calls.clear();
  }
  Device device;
  Scene scene;
  Field field;
  Render render;
};

class Cancel : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, Cancel, testing::Values(1u, 3u));

TEST_P(Cancel, AtAnyCallOfAPassNothingChanges) {
  Host host;
  Begun undisturbed(host, GetParam());
  must(awdRenderPass(undisturbed.render, 3, nullptr));
  host.expect("pass", static_cast<AWDRender>(undisturbed.render));
  ASSERT_GE(host.calls.size(), 3u);
  if (GetParam() == 1) {
    EXPECT_EQ(host.calls.back().fraction, 1.0);
  }
  const size_t calls = host.calls.size();
  const Film finished = readFilm(undisturbed.render);
  const auto recorded = densitiesOf(undisturbed.field);
  must(awdAdaptField(undisturbed.field, nullptr));
  const auto adapted = densitiesOf(undisturbed.field);

  // With several threads a call may find nobody free to report: the last is then not foreseen.
  for (const size_t stopAt : {size_t{1}, calls / 2, GetParam() == 1 ? calls : calls / 3}) {
    SCOPED_TRACE(stopAt);
    Host stopper;
    Begun begun(stopper, GetParam());
    const Film before = readFilm(begun.render);
    const auto learned = densitiesOf(begun.field);
    stopper.stopAt = stopAt;
    AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
    expectFailure(awdRenderPass(begun.render, 3, &figures), AWD_ERROR_CANCELLED, {"pass"});
    const Film after = readFilm(begun.render);
    EXPECT_EQ(after.radiance, before.radiance);
    EXPECT_EQ(after.variance, before.variance);
    EXPECT_EQ(after.samplesPerPixel, before.samplesPerPixel);
    EXPECT_EQ(densitiesOf(begun.field), learned);
    uint32_t passes = 0;
    must(awdGetPassCount(begun.render, &passes));
    EXPECT_EQ(passes, 1u);

    stopper.stopAt = 0;
    must(awdRenderPass(begun.render, 3, &figures));
    const Film again = readFilm(begun.render);
    EXPECT_EQ(again.radiance, finished.radiance);
    EXPECT_EQ(again.variance, finished.variance);
    EXPECT_EQ(densitiesOf(begun.field), recorded);
    must(awdAdaptField(begun.field, nullptr));
    EXPECT_EQ(densitiesOf(begun.field), adapted);
  }
}

/// The field that a render makes for itself is as safe.
TEST_P(Cancel, OfSeveralPassesTheFinishedOnesStay) {
  Host host;
  const AWDDeviceDesc deviceDesc = host.desc(GetParam());
  const Device device = newDevice(&deviceDesc);
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(48);
  const Render render = newRender(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 3));
  host.calls.clear();
  must(awdRenderPass(render, 2, nullptr));
  const Film first = readFilm(render);
  host.stopAt = host.calls.size() + 2;
  const uint32_t passes[] = {2, 2};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = passes;
  schedule.passCount = 2;
  expectFailure(awdRenderPasses(render, &schedule), AWD_ERROR_CANCELLED);
  EXPECT_EQ(readFilm(render).radiance, first.radiance);
  EXPECT_EQ(readFilm(render).samplesPerPixel, 2u);
}

TEST_P(Cancel, OfAdaptNothingChanges) {
  Host host;
  Begun undisturbed(host, GetParam());
  must(awdRenderPass(undisturbed.render, 3, nullptr));
  host.calls.clear();
  const auto before = densitiesOf(undisturbed.field);
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  must(awdAdaptField(undisturbed.field, &figures));
  host.expect("adapt", static_cast<AWDField>(undisturbed.field));
  ASSERT_FALSE(host.calls.empty()) << "adapt reported nothing";
  const auto after = densitiesOf(undisturbed.field);
  Host stopper;
  Begun begun(stopper, GetParam());
  must(awdRenderPass(begun.render, 3, nullptr));
  stopper.stopAt = stopper.calls.size() + 1;
  expectFailure(awdAdaptField(begun.field, nullptr), AWD_ERROR_CANCELLED, {"adapt"});
  EXPECT_EQ(densitiesOf(begun.field), before);
  must(awdAdaptField(begun.field, nullptr));
  EXPECT_EQ(densitiesOf(begun.field), after);
}

TEST_P(Cancel, OfCommitTheSceneStaysUncommitted) {
  Host host;
  const AWDDeviceDesc deviceDesc = host.desc(GetParam());
  const Device device = newDevice(&deviceDesc);
  const Scene scene = lampRoom().upload(device);
  must(awdCommitScene(scene));
  host.expect("commit", static_cast<AWDScene>(scene));
  ASSERT_FALSE(host.calls.empty()) << "commit reported nothing";
  const Scene other = lampRoom().upload(device);
  host.stopAt = host.calls.size() + 1;
  expectFailure(awdCommitScene(other), AWD_ERROR_CANCELLED, {"commit"});
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  expectFailure(awdGetSceneInfo(other, &info), AWD_ERROR_INVALID_OPERATION);
  must(awdCommitScene(other));
}

TEST_P(Cancel, TheLogIsSilentOnSuccess) {
  Host host;
  Begun begun(host, GetParam());
  must(awdRenderPass(begun.render, 3, nullptr));
  Image image;
  must(awdNewFilmImage(begun.render, image.out()));
  EXPECT_EQ(host.log, std::vector<std::string>());
}

/// What two descriptors get to see, as a file.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) {
    std::fflush(nullptr);
    for (int i = 0; i < 2; ++i) {
      saved_[i] = dup(i + 1);
      dup2(fileno(file_), i + 1);
    }
  }
  /// Ends it; all that was written.
  std::string text() {
    std::fflush(nullptr);
    for (int i = 0; i < 2; ++i) {
      dup2(saved_[i], i + 1);
      close(saved_[i]);
    }
    std::rewind(file_);
    std::string result;
    for (int c; (c = std::fgetc(file_)) != EOF;) result.push_back(static_cast<char>(c));
    std::fclose(file_);
    return result;
  }

 private:
  FILE* file_;
  int saved_[2];
};

/// Nothing goes to stdout or stderr, be it from us or from a library below us: more threads than
/// the machine has, several devices, a scene without light, errors.
TEST(Silence, NothingIsPrinted) {
  Capture capture;
  {
    const Device small = newDevice(1u), two = newDevice(2u), large = newDevice(64u);
    for (const Device* device : {&two, &large, &small}) {
      const Scene scene = lampRoom().commit(*device);
      const AWDCamera view = lampRoomCamera(16);
      renderFilm(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 1), {1, 2});
      Scene dark;
      must(awdNewScene(*device, dark.out()));
      must(awdCommitScene(dark));
      AWDImage image;
      EXPECT_NE(awdReadImage(*device, "/nonexistent.exr", &image), AWD_SUCCESS);
      AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
      desc.basis = "nonesuch";
      AWDField field;
      EXPECT_NE(awdNewField(*device, &desc, &field), AWD_SUCCESS);
    }
  }
  EXPECT_EQ(capture.text(), "");
}

}  // namespace

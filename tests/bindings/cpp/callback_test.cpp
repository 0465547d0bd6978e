// SPDX-License-Identifier: Apache-2.0
// Exceptions of callbacks pass by C and leave the call that was at work.
#include <atomic>
#include <thread>

#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

struct Stop {
  const void* object;
};

/// Throws a Stop at the n-th report of an operation; 0: never.
struct Progress {
  std::string operation;
  std::atomic<int> left{0};

  void operator()(const AWDProgress& progress) {
    if (progress.operation == operation && left > 0 && --left == 0) throw Stop{progress.object};
  }
};

awd::Device listenTo(Progress& progress, uint32_t threads = 1) {
  awd::DeviceDesc desc;
  desc.threads = threads;
  desc.setProgress(progress);
  return awd::Device::create(desc);
}

template <class Call>
void expectStop(Call&& call, const void* object) {
  try {
    call();
    FAIL() << "nothing was thrown";
  } catch (const Stop& stop) {
    EXPECT_EQ(stop.object, object);
  }
}

TEST(Callbacks, ThrowOutOfACommit) {
  Progress progress;
  awd::Scene scene = uploadRoom(listenTo(progress));
  progress.operation = "commit";
  progress.left = 1;
  expectStop([&] { scene.commit(); }, scene.get());
  EXPECT_THROW(scene.info(), awd::Error);  // it was cancelled
  scene.commit();
  EXPECT_EQ(scene.info().triangles, 4u);
}

class CallbackThreads : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Callbacks, CallbackThreads, testing::Values(1u, 3u));

TEST_P(CallbackThreads, ThrowOutOfPassesAndAdapts) {
  Progress progress;
  const awd::Scene scene = makeRoom(listenTo(progress, GetParam()));
  const awd::Camera camera = roomCamera(64, 64);
  awd::Render render = awd::Render::create(scene, awd::RenderDesc(camera));
  awd::Field field = render.field();
  awd::Schedule schedule;
  schedule.totalSamples = 8;

  progress.operation = "pass";
  progress.left = 2;
  expectStop([&] { render.pass(1); }, render.get());
  progress.left = 1;
  expectStop([&] { render.passes(schedule); }, render.get());
  EXPECT_EQ(render.passCount(), 0u);

  // Adapts between passes report of the field.
  progress.operation = "adapt";
  progress.left = 1;
  expectStop([&] { render.passes(schedule); }, field.get());
  EXPECT_GE(render.passCount(), 1u);
  progress.left = 1;
  expectStop([&] { field.adapt(); }, field.get());
  field.adapt();
  render.passes(schedule);
}

TEST(Callbacks, ThrowOutOfTheirOwnCall) {
  // Two operations of one device at once, each stopped by its own exception.
  Progress none;
  const awd::Camera camera = roomCamera(32, 32);
  std::vector<awd::Render> renders;
  const auto stopAll = [](const AWDProgress& progress) {
    if (std::string(progress.operation) == "pass") throw Stop{progress.object};
  };
  awd::DeviceDesc desc;
  desc.threads = 2;
  desc.setProgress(stopAll);
  const awd::Device device = awd::Device::create(desc);
  for (int i = 0; i < 4; ++i) {
    renders.push_back(awd::Render::create(makeRoom(device), awd::RenderDesc(camera)));
  }
  std::vector<std::thread> threads;
  for (awd::Render& render : renders) {
    threads.emplace_back([&render] {
      for (int i = 0; i < 20; ++i) expectStop([&] { render.pass(1); }, render.get());
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(Callbacks, OfTheLogThrowToo) {
  int messages = 0;
  const auto onLog = [&](int32_t, const char*) {
    ++messages;
    throw messages;
  };
  awd::DeviceDesc desc;
  desc.setLog(onLog);
  awd::Scene empty = awd::Scene::create(awd::Device::create(desc));
  EXPECT_THROW(empty.commit(), int);
  EXPECT_EQ(messages, 1);  // nothing more is heard of a call that is lost
  EXPECT_THROW(empty.commit(), int);
  EXPECT_EQ(empty.info().triangles, 0u);  // the warning came when all was done
}

TEST(Callbacks, OfChecksThrowToo) {
  const awd::Device device = awd::Device::create();
  const std::vector<AWDBasisInfo> bases = device.bases();
  ASSERT_FALSE(bases.empty());
  int checks = 0;
  const auto onCheck = [&](const AWDBasisCheck&) {
    if (++checks == 3) throw std::string("enough");
  };
  EXPECT_THROW(awd::checkBasisModule(bases[0].file, onCheck), std::string);
  EXPECT_EQ(checks, 3);
}

TEST(Callbacks, CancelWhatWasCalledInC) {
  Progress progress;
  awd::Scene scene = uploadRoom(listenTo(progress));
  progress.operation = "commit";
  progress.left = 1;
  EXPECT_EQ(awdCommitScene(scene.get()), AWD_ERROR_CANCELLED);
  scene.commit();
}

TEST(Callbacks, OfTheLogAreLostInC) {
  const auto onLog = [](int32_t, const char*) { throw 1; };
  awd::DeviceDesc desc;
  desc.setLog(onLog);
  awd::Scene empty = awd::Scene::create(awd::Device::create(desc));
  // At the same time another thread is in a call of C++, which has nothing to do with it.
  awd::Scene other = uploadRoom(oneThread());
  std::atomic<bool> stop{false};
  std::thread thread([&] {
    while (!stop) EXPECT_NO_THROW(other.commit());
  });
  for (int i = 0; i < 20; ++i) EXPECT_EQ(awdCommitScene(empty.get()), AWD_SUCCESS);
  stop = true;
  thread.join();
}

TEST(Callbacks, MayCallTheLibrary) {
  awd::Field* other = nullptr;
  size_t told = 0;
  const auto onProgress = [&](const AWDProgress& progress) {
    if (progress.fraction < 1.0 || !other) return true;
    told = other->adapt().structSize;
    awd::Image::create(awd::Device(), 1, 1);  // fails
    return true;
  };
  awd::DeviceDesc desc;
  desc.threads = 1;
  desc.setProgress(onProgress);
  awd::Scene scene = uploadRoom(awd::Device::create(desc));
  awd::Field field = awd::Field::create(oneThread());
  other = &field;
  EXPECT_THROW(scene.commit(), awd::Error);
  EXPECT_EQ(told, sizeof(AWDFieldStatistics));
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// The host's allocator: all of it comes back, and running out of it is an error like any other.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>

#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

/// Counts, checks sizes on the way back, and can refuse from the n-th call on, or only that one.
class CountingAllocator {
 public:
  AWDDeviceDesc desc(uint32_t threads) {
    AWDDeviceDesc result = AWD_DEVICE_DESC_INIT;
    result.threads = threads;
    result.alloc = [](void* user, size_t size, size_t alignment) {
      return static_cast<CountingAllocator*>(user)->allocate(size, alignment);
    };
    result.free = [](void* user, void* ptr, size_t size, size_t alignment) {
      static_cast<CountingAllocator*>(user)->release(ptr, size, alignment);
    };
    result.allocUser = this;
    return result;
  }

  void refuse(size_t call, bool allLater) {
    refused_ = call;
    allLater_ = allLater;
  }
  size_t calls() const { return calls_; }
  size_t blocks() const { return blocks_.size(); }
  size_t bytes() const { return bytes_; }

 private:
  struct Block {
    size_t size, alignment;
  };

  void* allocate(size_t size, size_t alignment) {
    const std::lock_guard<std::mutex> lock(mutex_);
    EXPECT_EQ(alignment & (alignment - 1), 0u);
    EXPECT_GT(alignment, 0u);
    ++calls_;
    if (refused_ && (allLater_ ? calls_ >= refused_ : calls_ == refused_)) return nullptr;
    const size_t least = std::max(alignment, sizeof(void*));
    void* ptr = std::aligned_alloc(least, (std::max<size_t>(size, 1) + least - 1) / least * least);
    blocks_[ptr] = {size, alignment};
    bytes_ += size;
    return ptr;
  }
  void release(void* ptr, size_t size, size_t alignment) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto block = blocks_.find(ptr);
    if (block == blocks_.end()) {
      ADD_FAILURE() << "freed what was not allocated, or twice";
      return;
    }
    EXPECT_EQ(block->second.size, size);
    EXPECT_EQ(block->second.alignment, alignment);
    blocks_.erase(block);
    std::free(ptr);
  }

  std::mutex mutex_;
  std::map<void*, Block> blocks_;
  size_t calls_ = 0, bytes_ = 0, refused_ = 0;
  bool allLater_ = false;
};

/// All that a host does in a short life; the first error ends it.
AWDResult live(const AWDDeviceDesc& deviceDesc) {
  AWDDevice device = nullptr;
  AWDScene scene = nullptr;
  AWDRender render = nullptr;
  AWDField field = nullptr;
  AWDImage image = nullptr;
  const auto step = [&](AWDResult result, const void* output) {
    if (result != AWD_SUCCESS) {
      EXPECT_EQ(output, nullptr);
    }
    return result;
  };
  const auto run = [&]() -> AWDResult {
    const SceneBuilder room = lampRoom();
    const AWDMeshDesc mesh = room.mesh();
    const AWDCamera view = lampRoomCamera(9);
    const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_ADAPTIVE, 1);
    const AWDRay ray = {{2, 1, 3}, 0.0f, {0, 0, -1}, 100.0f};
    AWDHit hit;
    std::vector<float> film(9 * 9 * 3);
    const uint32_t passes[] = {1, 2};
    AWDSchedule schedule = AWD_SCHEDULE_INIT;
    schedule.samplesPerPass = passes;
    schedule.passCount = 2;
    AWDResult r;
    if ((r = step(awdNewDevice(&deviceDesc, &device), device))) return r;
    if ((r = step(awdNewScene(device, &scene), scene))) return r;
    for (const Rgb light : {Rgb{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {9, 9, 9}}) {
      const AWDMaterialDesc material = {
          sizeof material, {0.5f, 0.5f, 0.5f}, {light[0], light[1], light[2]}};
      if ((r = awdAddMaterial(scene, &material, nullptr))) return r;
    }
    if ((r = awdAddMesh(scene, &mesh, nullptr))) return r;
    if ((r = awdCommitScene(scene))) return r;
    if ((r = awdIntersect(scene, &ray, 1, &hit))) return r;
    if ((r = step(awdNewRender(scene, nullptr, &desc, &render), render))) return r;
    if ((r = awdRenderPasses(render, &schedule))) return r;
    if ((r = awdReadFilm(render, AWD_FILM_VARIANCE, film.data(), 0, 0))) return r;
    if ((r = step(awdGetRenderField(render, &field), field))) return r;
    if ((r = awdAdaptField(field, nullptr))) return r;
    if ((r = step(awdNewFilmImage(render, &image), image))) return r;
    return AWD_SUCCESS;
  };
  const AWDResult result = run();
  awdReleaseDevice(device);  // parents first: children keep them alive
  awdReleaseScene(scene);
  awdReleaseRender(render);
  awdReleaseField(field);
  awdReleaseImage(image);
  return result;
}

class Allocator : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, Allocator, testing::Values(1u, 2u));

TEST_P(Allocator, EverythingComesBack) {
  CountingAllocator allocator;
  must(live(allocator.desc(GetParam())));
  EXPECT_EQ(allocator.blocks(), 0u);
  EXPECT_GT(allocator.calls(), 10u);
  EXPECT_GT(allocator.bytes(), 9u * 9 * 3 * sizeof(float));
}

/// One refusal, or no memory from then on: at each of the first calls, then in growing steps.
TEST_P(Allocator, RefusalIsOutOfMemory) {
  CountingAllocator counter;
  must(live(counter.desc(GetParam())));
  for (const bool allLater : {false, true}) {
    size_t failures = 0, steps = 0;
    for (size_t n = 1; n <= counter.calls(); n += 1 + n / 40, ++steps) {
      SCOPED_TRACE(n);
      CountingAllocator allocator;
      allocator.refuse(n, allLater);
      const AWDResult result = live(allocator.desc(GetParam()));
      if (result != AWD_SUCCESS) {
        ++failures;
        EXPECT_EQ(result, AWD_ERROR_OUT_OF_MEMORY) << awdGetLastErrorMessage();
        EXPECT_STRNE(awdGetLastErrorMessage(), "");
      }
      EXPECT_EQ(allocator.blocks(), 0u) << "leaked";
    }
    EXPECT_GT(failures, steps / 2);
  }
}

}  // namespace

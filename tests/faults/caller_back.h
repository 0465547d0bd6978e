// SPDX-License-Identifier: Apache-2.0
// A host whose progress callback calls the library.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "support/counting_allocator.h"
#include "support/films.h"
#include "support/outcome.h"
#include "support/scenes.h"

namespace awdtest {

struct CallerBack {
  /// What it does at its at-th call of an operation of that name, 1 for the first; once.
  std::string operation;
  size_t at = 1;
  std::function<void()> act;
  bool stop = false;             ///< and then cancels
  std::atomic<size_t> calls{0};  ///< of that operation
  std::atomic<bool> acted{false};
  std::atomic<double> farthest{0.0};  ///< that the operation has told
  CountingAllocator allocator;

  void onCall(const char* name, size_t call, std::function<void()> what, bool stops = false) {
    operation = name;
    at = call;
    act = std::move(what);
    stop = stops;
    calls = 0;
    acted = false;
  }
  AWDDeviceDesc desc(uint32_t threads) {
    AWDDeviceDesc result = allocator.desc(threads);
    result.progress = [](void* user, const AWDProgress* progress) -> int32_t {
      CallerBack& self = *static_cast<CallerBack*>(user);
      if (progress->operation != self.operation) return 1;
      self.farthest = progress->fraction;
      if (++self.calls != self.at) return 1;
      if (self.acted.exchange(true)) return 1;
      if (self.act) self.act();
      return self.stop ? 0 : 1;
    };
    result.progressUser = this;
    return result;
  }
};

/// A render with a field that has learned a little.
struct Begun {
  Begun(CallerBack& host, uint32_t threads, uint32_t size = 40) : Begun(host.desc(threads), size) {}
  Begun(const AWDDeviceDesc& desc, uint32_t size) : camera(lampRoomCamera(size)) {
    device = newDevice(&desc);
    scene = lampRoom().commit(device);
    must(awdNewSceneField(scene, nullptr, field.out()));
    render = newRender(scene, renderDesc(camera, AWD_GUIDE_ADAPTIVE, 3), field);
    must(awdRenderPass(render, 2, nullptr));
  }
  AWDCamera camera;
  Device device;
  Scene scene;
  Field field;
  Render render;
};

}  // namespace awdtest

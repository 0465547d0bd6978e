// SPDX-License-Identifier: Apache-2.0
// Scenes of `awd-bench scale`: the same light and the same view, of as many triangles or lights as
// are asked for.
#pragma once

#include <atomic>
#include <cstddef>

#include "render_shots.h"

namespace bench::scale {

/// A device that knows how much the library has allocated: not what Embree has, which allocates by
/// itself.
class CountedDevice {
 public:
  CountedDevice(uint32_t threads, Cancelled cancelled);

  const awd::Device& device() const { return device_; }
  std::size_t bytes() const { return bytes_; }

 private:
  std::atomic<std::size_t> bytes_{0};
  Cancelled cancelled_;
  awd::Device device_;
};

struct CommittedScene {
  awd::Scene scene;
  AWDCamera camera = AWD_CAMERA_INIT;
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  double commitSeconds = 0.0;  ///< CPU time
  double bytes = 0.0;          ///< of the library alone, its copy of the buffers included
};

/// examples/scenes/two-rooms, each triangle but those of lamps cut into pieces x pieces equal ones.
CommittedScene cutRooms(const CountedDevice& device, uint32_t pieces, uint32_t width);

/// A closed room with side x side lamps below its ceiling, which shine at it: of one power in all.
CommittedScene lampGrid(const CountedDevice& device, uint32_t side, uint32_t width);

}  // namespace bench::scale

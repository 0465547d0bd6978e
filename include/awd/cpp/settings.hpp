// SPDX-License-Identifier: Apache-2.0
//
// The C interface's structs of settings, which begin with all defaults. Their fields are those of
// C; what they point to must live until the call that takes them has ended.
#ifndef AWD_CPP_SETTINGS_HPP
#define AWD_CPP_SETTINGS_HPP

#include "awd/cpp/callbacks.hpp"
#include "awd/cpp/view.hpp"
#include "awd/density.h"
#include "awd/device.h"
#include "awd/field.h"
#include "awd/image.h"
#include "awd/render.h"
#include "awd/scene.h"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Callables are referred to, not copied: they must outlive the device and all that is made of it.
/// What they throw leaves the call that was at work, which is cancelled if it can be; it is lost
/// from calls made in C, and from log messages of the library's own threads.
struct DeviceDesc : AWDDeviceDesc {
  DeviceDesc() noexcept : AWDDeviceDesc(AWD_DEVICE_DESC_INIT) {}

  /// callable(int32_t severity, const char* message), from any thread.
  template <class Callable>
  void setLog(Callable& callable) noexcept {
    log = detail::onLog<Callable>;
    logUser = detail::userOf(callable);
  }
  /// callable(const AWDProgress&), from any thread; false cancels, void goes on.
  template <class Callable>
  void setProgress(Callable& callable) noexcept {
    progress = detail::onProgress<Callable>;
    progressUser = detail::userOf(callable);
  }
  void setBasisPaths(View<const char* const> paths) noexcept {
    basisPaths = paths.data();
    basisPathCount = paths.size();
  }
};

struct MaterialDesc : AWDMaterialDesc {
  MaterialDesc() noexcept : AWDMaterialDesc(AWD_MATERIAL_DESC_INIT) {}
};

/// Buffers are those of awd/cpp/buffer.hpp.
struct MeshDesc : AWDMeshDesc {
  MeshDesc() noexcept : AWDMeshDesc(AWD_MESH_DESC_INIT) {}
};

struct Camera : AWDCamera {
  Camera() noexcept : AWDCamera(AWD_CAMERA_INIT) {}
};

struct FieldDesc : AWDFieldDesc {
  FieldDesc() noexcept : AWDFieldDesc(AWD_FIELD_DESC_INIT) {}

  void setLights(View<const float> powers) noexcept {
    lightPowers = powers.data();
    lightCount = static_cast<std::uint32_t>(powers.size());
  }
};

struct DensityDesc : AWDDensityDesc {
  DensityDesc() noexcept : AWDDensityDesc(AWD_DENSITY_DESC_INIT) {}
  explicit DensityDesc(std::uint32_t d) noexcept : DensityDesc() { dimensions = d; }

  void setAxes(View<const AWDDensityAxis> all) noexcept {
    axes = all.data();
    dimensions = static_cast<std::uint32_t>(all.size());
  }
};

struct RenderDesc : AWDRenderDesc {
  RenderDesc() noexcept : AWDRenderDesc(AWD_RENDER_DESC_INIT) {}
  explicit RenderDesc(const AWDCamera& view) noexcept : RenderDesc() { camera = &view; }
  explicit RenderDesc(const AWDCamera&& view) = delete;
};

struct Schedule : AWDSchedule {
  Schedule() noexcept : AWDSchedule(AWD_SCHEDULE_INIT) {}

  void setPasses(View<const std::uint32_t> samples) noexcept {
    samplesPerPass = samples.data();
    passCount = static_cast<std::uint32_t>(samples.size());
  }
};

struct PNGDesc : AWDPNGDesc {
  PNGDesc() noexcept : AWDPNGDesc(AWD_PNG_DESC_INIT) {}
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif

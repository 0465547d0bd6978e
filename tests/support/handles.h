// SPDX-License-Identifier: Apache-2.0
// Owners of the C interface's handles, for tests that see the library from outside.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "awd/awd.h"

namespace awdtest {

/// Throws with the library's own message, which GoogleTest then shows, unless the call worked.
inline void must(AWDResult result) {
  if (result == AWD_SUCCESS) return;
  throw std::runtime_error(std::string(awdGetResultString(result)) + ": " +
                           awdGetLastErrorMessage());
}

/// One reference, released when the owner goes.
template <class T, void (*release)(T)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(T handle) : handle_(handle) {}
  Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Handle() { release(handle_); }

  operator T() const { return handle_; }  // as the C functions take it
  /// Where a New function may put its result; what was here before is released.
  T* out() {
    release(std::exchange(handle_, nullptr));
    return &handle_;
  }

 private:
  T handle_ = nullptr;
};

using Device = Handle<AWDDevice, awdReleaseDevice>;
using Scene = Handle<AWDScene, awdReleaseScene>;
using Field = Handle<AWDField, awdReleaseField>;
using Render = Handle<AWDRender, awdReleaseRender>;
using Image = Handle<AWDImage, awdReleaseImage>;

inline Device newDevice(const AWDDeviceDesc* desc = nullptr) {
  Device device;
  must(awdNewDevice(desc, device.out()));
  return device;
}

inline Device newDevice(uint32_t threads) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = threads;
  return newDevice(&desc);
}

inline Field newField(AWDDevice device, const AWDFieldDesc* desc = nullptr) {
  Field field;
  must(awdNewField(device, desc, field.out()));
  return field;
}

}  // namespace awdtest

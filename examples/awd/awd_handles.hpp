// SPDX-License-Identifier: Apache-2.0
// Owners of the library's handles.
#pragma once

#include <utility>

#include "awd/awd.h"

namespace command {

/// Owns one reference of a handle and gives it back.
template <class Type, void (*release)(Type)>
class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Handle() { release(handle_); }

  Type get() const { return handle_; }
  /// For a function that hands out a handle; only while there is none.
  Type* out() { return &handle_; }

 private:
  Type handle_ = nullptr;
};

// Functions of C are noexcept here, which a template argument of C++17 may drop.
using Device = Handle<AWDDevice, awdReleaseDevice>;
using Scene = Handle<AWDScene, awdReleaseScene>;
using Field = Handle<AWDField, awdReleaseField>;
using Render = Handle<AWDRender, awdReleaseRender>;
using Image = Handle<AWDImage, awdReleaseImage>;

}  // namespace command

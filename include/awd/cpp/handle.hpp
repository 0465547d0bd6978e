// SPDX-License-Identifier: Apache-2.0
//
// Owners of the C interface's handles.
#ifndef AWD_CPP_HANDLE_HPP
#define AWD_CPP_HANDLE_HPP

#include <utility>

#include "awd/cpp/error.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Owns one reference of a C handle, or nothing. Object: the class that derives from this.
template <class Object, class Handle, void(AWD_CALL* retain)(Handle), void(AWD_CALL* drop)(Handle)>
class Owner {
 public:
  Owner() noexcept = default;
  Owner(const Owner& other) noexcept : handle_(other.handle_) { retain(handle_); }
  Owner(Owner&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Owner& operator=(Owner other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Owner() { drop(handle_); }

  /// Takes over a reference that C code gave the caller.
  static Object adopt(Handle handle) noexcept {
    Object object;
    object.handle_ = handle;
    return object;
  }
  /// Adds a reference to one that someone else keeps.
  static Object share(Handle handle) noexcept {
    retain(handle);
    return Object::adopt(handle);
  }

  /// For calls in C; stays owned by this.
  Handle get() const noexcept { return handle_; }
  /// Leaves this empty, and the reference to the caller.
  [[nodiscard]] Handle release() noexcept { return std::exchange(handle_, nullptr); }
  explicit operator bool() const noexcept { return handle_ != nullptr; }

  /// Whether both stand for the same thing.
  friend bool operator==(const Object& a, const Object& b) noexcept { return a.get() == b.get(); }
  friend bool operator!=(const Object& a, const Object& b) noexcept { return a.get() != b.get(); }

 protected:
  /// For a function that hands out a reference; only while there is none.
  Handle* out() noexcept { return &handle_; }

 private:
  Handle handle_ = nullptr;
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif

// SPDX-License-Identifier: Apache-2.0
// Intrusive reference counts: the objects behind the handles of the C interface.
#pragma once

#include <atomic>
#include <memory_resource>
#include <utility>

namespace awd {

class RefCounted {
 public:
  RefCounted(const RefCounted&) = delete;
  RefCounted& operator=(const RefCounted&) = delete;

  void retain() noexcept { count_.fetch_add(1, std::memory_order_relaxed); }
  void release() noexcept {
    if (count_.fetch_sub(1, std::memory_order_acq_rel) == 1) destroy();
  }

  /// Whether a call that calls the host back is at work on it.
  bool isAtWork() const noexcept { return atWork_.load(std::memory_order_relaxed); }
  /// False if one is already.
  bool beginWork() noexcept { return !atWork_.exchange(true, std::memory_order_acquire); }
  void endWork() noexcept { atWork_.store(false, std::memory_order_release); }

 protected:
  RefCounted() = default;
  virtual ~RefCounted() = default;

 private:
  /// Destructs and gives the memory back to where it came from.
  virtual void destroy() noexcept = 0;

  std::atomic<long> count_{1};
  std::atomic<bool> atWork_{false};
};

/// Owns one reference.
template <class T>
class Ref {
 public:
  Ref() = default;
  /// Takes over a reference that the caller owns.
  static Ref adopt(T* object) noexcept { return Ref(object); }
  /// Adds a reference.
  static Ref share(T* object) noexcept {
    if (object) object->retain();
    return Ref(object);
  }
  Ref(const Ref& other) noexcept : object_(other.object_) {
    if (object_) object_->retain();
  }
  Ref(Ref&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Ref& operator=(Ref other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Ref() {
    if (object_) object_->release();
  }

  T* get() const noexcept { return object_; }
  T* operator->() const noexcept { return object_; }
  T& operator*() const noexcept { return *object_; }
  explicit operator bool() const noexcept { return object_ != nullptr; }
  /// Hands the reference to the caller.
  T* detach() noexcept { return std::exchange(object_, nullptr); }

 private:
  explicit Ref(T* object) noexcept : object_(object) {}
  T* object_ = nullptr;
};

}  // namespace awd

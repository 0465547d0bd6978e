// SPDX-License-Identifier: Apache-2.0
// What every object of a device shares: memory, threads and callbacks. Outlives them all.
#pragma once

#include <atomic>
#include <memory>

#include "awd/device.h"
#include "util/memory.h"
#include "util/parallel.h"
#include "util/ref.h"

namespace awd {

class Context final : public RefCounted {
 public:
  /// `desc` has been checked.
  static Ref<Context> make(const AWDDeviceDesc& desc);

  std::pmr::memory_resource* memory() noexcept { return &memory_; }
  Parallel& parallel() noexcept { return parallel_; }

  /// Sends one line to the host's log, if there is one.
  [[gnu::format(printf, 3, 4)]] void log(int32_t severity, const char* format, ...) noexcept;

  AWDProgressFn progressFn() const noexcept { return progress_; }
  void* progressUser() const noexcept { return progressUser_; }

 private:
  explicit Context(const AWDDeviceDesc& desc);
  void destroy() noexcept override;

  HostMemory memory_;
  Parallel parallel_;
  AWDLogFn log_;
  void* logUser_;
  AWDProgressFn progress_;
  void* progressUser_;
};

/// Progress of one long operation, fed from any thread: reports steps done, never from two threads
/// at once and never falling, and remembers that the host said stop.
class Progress {
 public:
  /// object: the handle that the host knows.
  Progress(Context& context, const char* operation, const void* object, std::size_t steps);

  /// So many steps are done.
  void step(std::size_t steps = 1) noexcept;
  /// That much is done, 0 to 1. Whoever finds another thread reporting leaves it to that one, so
  /// that not every step is told of, but the last is.
  void report(double fraction) noexcept;
  /// Whether work should end; cheap.
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
  /// Throws AWD_ERROR_CANCELLED if the host said stop.
  void throwIfCancelled() const;

 private:
  Context& context_;
  const char* operation_;
  const void* object_;
  std::size_t steps_;
  std::atomic<double> farthest_{0.0};
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> cancelled_{false};
  std::atomic<bool> reporting_{false};
};

/// Allocates and constructs an object of a context; its destroy() must call unmake.
template <class T, class... Arguments>
T* make(std::pmr::memory_resource* memory, Arguments&&... arguments) {
  void* place = memory->allocate(sizeof(T), alignof(T));
  try {
    return new (place) T(std::forward<Arguments>(arguments)...);
  } catch (...) {
    memory->deallocate(place, sizeof(T), alignof(T));
    throw;
  }
}

template <class T>
void unmake(std::pmr::memory_resource* memory, T* object) noexcept {
  object->~T();
  memory->deallocate(object, sizeof(T), alignof(T));
}

/// Destroys what make() made.
template <class T>
struct Unmake {
  std::pmr::memory_resource* memory;
  void operator()(T* object) const noexcept { unmake(memory, object); }
};
template <class T>
using Owned = std::unique_ptr<T, Unmake<T>>;

template <class T, class... Arguments>
Owned<T> makeOwned(std::pmr::memory_resource* memory, Arguments&&... arguments) {
  return Owned<T>(make<T>(memory, std::forward<Arguments>(arguments)...), {memory});
}

}  // namespace awd

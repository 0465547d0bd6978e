// SPDX-License-Identifier: Apache-2.0
// The parallel loop: on oneTBB, on std::thread, or on the host's scheduler.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <memory_resource>
#include <type_traits>

#include "awd/types.h"

namespace awd {

class Parallel {
 public:
  /// threads 0: as many as this process may use. Touches nothing process-wide.
  Parallel(std::pmr::memory_resource* memory, uint32_t threads, AWDParallelForFn hostFor,
           void* hostUser);
  ~Parallel();

  unsigned threads() const noexcept { return threads_; }

  /// Calls body(i) once for each i in [0, count), in any order on any threads, and returns when
  /// all have ended. The first exception (of the lowest index among those thrown) is rethrown
  /// here; indices not yet begun are then skipped.
  template <class Body>
  void forEach(std::size_t count, Body&& body) {
    using Plain = std::remove_reference_t<Body>;
    run(
        count, [](void* data, std::size_t i) { (*static_cast<Plain*>(data))(i); }, &body);
  }

  /// Runs body() so that a library that schedules on oneTBB, as Embree does, stays within our
  /// threads.
  template <class Body>
  void within(Body&& body) {
    using Plain = std::remove_reference_t<Body>;
    enter([](void* data, std::size_t) { (*static_cast<Plain*>(data))(); }, &body);
  }

 private:
  using Task = void (*)(void* data, std::size_t index);
  void run(std::size_t count, Task task, void* data);
  void enter(Task task, void* data);

  struct Arena;
  std::pmr::memory_resource* memory_;
  unsigned threads_;
  AWDParallelForFn hostFor_;
  void* hostUser_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
#include "util/context.h"

#include <cstdarg>
#include <cstdio>

#include "util/error.h"
#include "util/uncancelled.h"

namespace awd {

Context::Context(const AWDDeviceDesc& desc)
    : memory_(desc.alloc, desc.free, desc.allocUser),
      parallel_(&memory_, desc.threads, desc.parallelFor, desc.parallelForUser),
      log_(desc.log),
      logUser_(desc.logUser),
      progress_(desc.progress),
      progressUser_(desc.progressUser) {}

Ref<Context> Context::make(const AWDDeviceDesc& desc) {
  HostMemory memory(desc.alloc, desc.free, desc.allocUser);
  void* place = memory.allocate(sizeof(Context), alignof(Context));
  try {
    return Ref<Context>::adopt(new (place) Context(desc));
  } catch (...) {
    memory.deallocate(place, sizeof(Context), alignof(Context));
    throw;
  }
}

void Context::destroy() noexcept {
  HostMemory memory = memory_;  // ours lies in the memory that goes
  unmake(&memory, this);
}

void Context::log(int32_t severity, const char* format, ...) noexcept {
  if (!log_) return;
  const Uncancelled uncancelled;  // what the host does with the text may take long
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  makeOneLine(text);
  log_(logUser_, severity, text);
}

Progress::Progress(Context& context, const char* operation, const void* object, std::size_t steps)
    : context_(context), operation_(operation), object_(object), steps_(steps) {}

void Progress::step(std::size_t steps) noexcept {
  const std::size_t done = done_.fetch_add(steps, std::memory_order_relaxed) + steps;
  report(static_cast<double>(done) / static_cast<double>(steps_));
}

void Progress::report(double fraction) noexcept {
  if (!context_.progressFn()) return;
  double farthest = farthest_.load(std::memory_order_relaxed);
  while (fraction > farthest &&
         !farthest_.compare_exchange_weak(farthest, fraction, std::memory_order_relaxed)) {
  }
  // Each exchange sees what was done before the former one: whoever finds another thread reporting
  // leaves it to that one to find that there is more to tell.
  while (!reporting_.exchange(true, std::memory_order_acq_rel)) {
    const double told = farthest_.load(std::memory_order_relaxed);
    const AWDProgress progress = {sizeof(AWDProgress), operation_, object_, told};
    if (context_.progressFn()(context_.progressUser(), &progress) == 0) {
      cancelled_.store(true, std::memory_order_relaxed);
    }
    reporting_.exchange(false, std::memory_order_acq_rel);
    if (cancelled() || farthest_.load(std::memory_order_relaxed) == told) return;
  }
}

void Progress::throwIfCancelled() const {
  if (cancelled()) {
    fail(AWD_ERROR_CANCELLED, "%s: cancelled by the progress callback", operation_);
  }
}

}  // namespace awd

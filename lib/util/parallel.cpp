// SPDX-License-Identifier: Apache-2.0
#include "util/parallel.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory_resource>
#include <mutex>
#include <thread>
#include <vector>

#ifdef AWD_TBB
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include "util/error.h"

namespace awd {

namespace {

unsigned usableThreads() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
  return std::max(1u, std::thread::hardware_concurrency());
}

/// A loop that any number of threads may help with; exceptions wait for its end.
class Loop {
 public:
  using Task = void (*)(void*, std::size_t);
  Loop(Task task, void* data) : task_(task), data_(data) {}

  void once(std::size_t index) noexcept {
    if (failed_.load(std::memory_order_relaxed)) return;
    try {
      task_(data_, index);
    } catch (...) {
      failed_.store(true, std::memory_order_relaxed);
      const std::lock_guard<std::mutex> lock(mutex_);
      if (index < index_) {
        index_ = index;
        error_ = std::current_exception();
      }
    }
  }

  void rethrow() {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  Task task_;
  void* data_;
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::size_t index_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr error_;
};

/// A loop on the host's scheduler, which may call anything: no index is run that there is not, and
/// none twice.
class HostLoop {
 public:
  HostLoop(std::pmr::memory_resource* memory, std::size_t count, Loop& loop)
      : loop_(loop), begun_(count, Flags::allocator_type(memory)) {}

  void once(std::size_t index) noexcept {
    if (index >= begun_.size()) {
      beyond_.store(index, std::memory_order_relaxed);
      goesOn_.store(true, std::memory_order_relaxed);
    } else if (begun_[index].exchange(true, std::memory_order_relaxed)) {
      twice_.store(index, std::memory_order_relaxed);
    } else {
      loop_.once(index);
    }
  }

  /// Throws unless each was called once.
  void check() const {
    const auto complain = [&](const char* what, std::size_t index) {
      fail(AWD_ERROR_INVALID_OPERATION,
           "the host's parallelFor %s index %zu: it must run each of %zu once", what, index,
           begun_.size());
    };
    if (goesOn_) complain("went on to", beyond_);
    if (twice_ != kNone) complain("repeated", twice_);
    const auto left = std::find(begun_.begin(), begun_.end(), false);
    if (left != begun_.end()) complain("left out", left - begun_.begin());
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  using Flags = std::pmr::vector<std::atomic<bool>>;
  Loop& loop_;
  Flags begun_;
  std::atomic<bool> goesOn_{false};
  std::atomic<std::size_t> beyond_{0}, twice_{kNone};
};

/// The process in which oneTBB's threads were started for us. In one that was forked from it they
/// are not, though oneTBB believes it, and may have left its locks taken for ever.
std::atomic<pid_t> homeOfThreads{0};

bool threadsAreElsewhere() {
  const pid_t home = homeOfThreads.load(std::memory_order_relaxed);
  return home != 0 && home != getpid();
}

/// False if they can't be started, since they are elsewhere.
bool startThreads() {
  if (threadsAreElsewhere()) return false;
  homeOfThreads.store(getpid(), std::memory_order_relaxed);
  return true;
}

#ifndef AWD_TBB
/// The caller and threads - 1 helpers take indices in turn.
void runOnThreads(unsigned threads, std::size_t count, Loop& loop) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) loop.once(i);
  };
  std::vector<std::thread> helpers;
  try {
    helpers.reserve(threads);
    while (helpers.size() + 1 < std::min<std::size_t>(threads, count)) helpers.emplace_back(work);
  } catch (...) {
    // Fewer helpers than wished for: the loop is done by those there are.
  }
  work();
  for (std::thread& helper : helpers) helper.join();
}
#endif

}  // namespace

#ifdef AWD_TBB
struct Parallel::Arena {
  // Beyond the threads that oneTBB has it would run no more of them, but print a warning.
  explicit Arena(unsigned threads)
      : arena(std::min(static_cast<int>(threads), tbb::info::default_concurrency())) {}
  tbb::task_arena arena;
};
#else
struct Parallel::Arena {
  explicit Arena(unsigned) {}
};
#endif

Parallel::Parallel(std::pmr::memory_resource* memory, uint32_t threads, AWDParallelForFn hostFor,
                   void* hostUser)
    : memory_(memory),
      threads_(threads ? threads : usableThreads()),
      hostFor_(hostFor),
      hostUser_(hostUser),
      arena_(std::make_unique<Arena>(threads_)) {}

Parallel::~Parallel() {
#ifdef AWD_TBB
  if (threadsAreElsewhere()) static_cast<void>(arena_.release());  // nor are there locks to end it
#endif
}

void Parallel::run(std::size_t count, Task task, void* data) {
  Loop loop(task, data);
  if (hostFor_) {
    HostLoop hosted(memory_, count, loop);
    hostFor_(
        hostUser_, count, [](void* self, std::size_t i) { static_cast<HostLoop*>(self)->once(i); },
        &hosted);
    hosted.check();
  } else if (threads_ == 1) {
    for (std::size_t i = 0; i < count; ++i) loop.once(i);
  } else {
#ifdef AWD_TBB
    if (startThreads()) {
      arena_->arena.execute([&] {
        tbb::parallel_for(
            std::size_t{0}, count, [&](std::size_t i) { loop.once(i); }, tbb::simple_partitioner());
      });
    } else {
      for (std::size_t i = 0; i < count; ++i) loop.once(i);
    }
#else
    runOnThreads(threads_, count, loop);
#endif
  }
  loop.rethrow();
}

void Parallel::enter(Task task, void* data) {
#ifdef AWD_TBB
  const bool alone = threads_ == 1;
#else
  const bool alone = false;  // whoever schedules on oneTBB starts its threads
#endif
  if (alone ? threadsAreElsewhere() : !startThreads()) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "this process was forked after the library's threads had been started, which are not in "
         "it: commit scenes before, or call exec");
  }
#ifdef AWD_TBB
  Loop loop(task, data);
  arena_->arena.execute([&] { loop.once(0); });
  loop.rethrow();
#else
  task(data, 0);
#endif
}

}  // namespace awd

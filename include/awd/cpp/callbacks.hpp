// SPDX-License-Identifier: Apache-2.0
//
// Callbacks of any callable type, and the way of their exceptions around C: what one throws is
// kept, cancels the operation if it can be cancelled, and leaves the call that was at work.
#ifndef AWD_CPP_CALLBACKS_HPP
#define AWD_CPP_CALLBACKS_HPP

#include <cstdint>
#include <exception>
#include <mutex>
#include <type_traits>
#include <utility>

#include "awd/cpp/error.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {
namespace detail {

#ifdef AWD_NO_EXCEPTIONS

/// A call that may call back.
class Call {
 public:
  explicit Call(const void* = nullptr, const void* = nullptr) noexcept {}
  void rethrow() const noexcept {}
};

/// Runs a callback: nonzero to go on.
template <class Body>
std::int32_t callBack(const void*, Body&& body) noexcept {
  return body();
}

#else

/// A call that may call back, from beginning to end. Progress tells of which object it is, at which
/// any thread may work; a log message belongs to the call of its thread.
class Call {
 public:
  explicit Call(const void* object = nullptr, const void* other = nullptr)
      : objects_{object, other} {
    const std::lock_guard<std::mutex> lock(mutex());
    next_ = std::exchange(latest(), this);
  }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  ~Call() {
    const std::lock_guard<std::mutex> lock(mutex());
    Call** link = &latest();
    while (*link != this) link = &(*link)->next_;
    *link = next_;
  }

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

  /// Whether a callback of the call of `object`, or of this thread's if that is null, has thrown.
  static bool hasThrown(const void* object) noexcept {
    const std::lock_guard<std::mutex> lock(mutex());
    const Call* call = find(object);
    return call && call->thrown_;
  }
  /// Keeps the exception at work for that call. There is none if the host called in C, nor of log
  /// messages from threads of the library's own.
  static void keepException(const void* object) noexcept {
    const std::lock_guard<std::mutex> lock(mutex());
    Call* call = find(object);
    if (call && !call->thrown_) call->thrown_ = std::current_exception();
  }

 private:
  static std::mutex& mutex() noexcept {
    static std::mutex instance;
    return instance;
  }
  static Call*& latest() noexcept {
    static Call* instance = nullptr;
    return instance;
  }
  static const void* thisThread() noexcept {
    thread_local const char place = 0;
    return &place;
  }
  static Call* find(const void* object) noexcept {
    for (Call* call = latest(); call; call = call->next_) {
      if (object ? call->objects_[0] == object || call->objects_[1] == object
                 : call->thread_ == thisThread()) {
        return call;
      }
    }
    return nullptr;
  }

  const void* objects_[2];
  const void* thread_ = thisThread();
  std::exception_ptr thrown_;
  Call* next_ = nullptr;
};

/// Runs a callback: nonzero to go on. Nothing is called any more after one has thrown.
template <class Body>
std::int32_t callBack(const void* object, Body&& body) noexcept {
  if (Call::hasThrown(object)) return 0;
  try {
    return body();
  } catch (...) {
    Call::keepException(object);
    return 0;
  }
}

#endif

/// What the call came to, unless a callback has thrown.
template <class... Value>
auto outcome(const Call& call, AWDResult result, Value&... value) {
  call.rethrow();
  return outcome(result, value...);
}

/// The pointer to be a callback's `user`.
template <class Callable>
void* userOf(Callable& callable) noexcept {
  static_assert(!std::is_function_v<Callable>, "give an object, such as a lambda");
  return const_cast<std::remove_const_t<Callable>*>(&callable);
}

template <class Callable>
void AWD_CALL onLog(void* user, std::int32_t severity, const char* message) noexcept {
  callBack(nullptr, [&] {
    (*static_cast<Callable*>(user))(severity, message);
    return 1;
  });
}

template <class Callable>
std::int32_t AWD_CALL onProgress(void* user, const AWDProgress* progress) noexcept {
  return callBack(progress->object, [&]() -> std::int32_t {
    Callable& callable = *static_cast<Callable*>(user);
    if constexpr (std::is_void_v<decltype(callable(*progress))>) {
      callable(*progress);
      return 1;
    } else {
      return callable(*progress) ? 1 : 0;
    }
  });
}

template <class Callable>
void AWD_CALL onBasisCheck(void* user, const AWDBasisCheck* check) noexcept {
  callBack(user, [&] {
    (*static_cast<Callable*>(user))(*check);
    return 1;
  });
}

}  // namespace detail
}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif

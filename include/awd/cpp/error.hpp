// SPDX-License-Identifier: Apache-2.0
//
// How calls fail: by an exception, or by what they return.
#ifndef AWD_CPP_ERROR_HPP
#define AWD_CPP_ERROR_HPP

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "awd/device.h"
#include "awd/types.h"

#if !defined(__cpp_exceptions) && !defined(AWD_NO_EXCEPTIONS)
#define AWD_NO_EXCEPTIONS
#endif

// Both kinds can be in one program: their functions have different names to the linker.
#ifdef AWD_NO_EXCEPTIONS
#define AWD_CPP_MODE returning
#else
#define AWD_CPP_MODE throwing
#endif

namespace awd {
inline namespace AWD_CPP_MODE {

/// Why a call failed: a result code, and the library's message.
class Error : public std::runtime_error {
 public:
  Error(AWDResult code, const std::string& message) : std::runtime_error(message), code_(code) {}
  /// Of this thread's last call, which failed.
  explicit Error(AWDResult code) : Error(code, awdGetLastErrorMessage()) {}

  AWDResult code() const noexcept { return code_; }

 private:
  AWDResult code_;
};

#ifdef AWD_NO_EXCEPTIONS

/// A value, or why there is none. Asking for the one that is not there ends the program.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const noexcept { return content_.index() == 0; }
  T& value() & { return *must(std::get_if<0>(&content_)); }
  const T& value() const& { return *must(std::get_if<0>(&content_)); }
  T&& value() && { return std::move(*must(std::get_if<0>(&content_))); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return *must(std::get_if<1>(&content_)); }

 private:
  template <class Content>
  static Content* must(Content* content) noexcept {
    if (!content) std::terminate();
    return content;
  }
  std::variant<T, Error> content_;
};

/// Of a call that has nothing to return.
template <>
class [[nodiscard]] Result<void> : public Result<std::monostate> {
 public:
  Result() : Result<std::monostate>(std::monostate()) {}
  Result(Error error) : Result<std::monostate>(std::move(error)) {}
};

/// What a call returns that can fail.
template <class T>
using Returns = Result<T>;

#else

/// What a call returns that can fail: it throws an Error if it does.
template <class T>
using Returns = T;

#endif

namespace detail {

template <class T>
Returns<T> failure(Error error) {
#ifdef AWD_NO_EXCEPTIONS
  return error;
#else
  throw error;
#endif
}

inline Returns<void> outcome(AWDResult result) {
  if (result != AWD_SUCCESS) return failure<void>(Error(result));
  return Returns<void>();
}

/// `value` if the call that wrote it worked. A reference, so that it doesn't matter whether the
/// call or this argument is evaluated first.
template <class T>
Returns<T> outcome(AWDResult result, T& value) {
  if (result != AWD_SUCCESS) return failure<T>(Error(result));
  return std::move(value);
}

/// Of views that don't fit each other, which C could not know.
template <class T>
Returns<T> wrongSize(const char* view, std::size_t size, std::size_t wanted) {
  return failure<T>(Error(AWD_ERROR_INVALID_ARGUMENT,
                          std::string(view) + " has " + std::to_string(size) +
                              " elements: the other arguments want " + std::to_string(wanted)));
}

}  // namespace detail
}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif

// SPDX-License-Identifier: Apache-2.0
// The border to C: exceptions become results with a message; arguments are checked on the way in.
#pragma once

#include <cstring>
#include <new>
#include <stdexcept>

#include "awd/types.h"
#include "util/error.h"

namespace awd {

/// Keeps "function: text" as this thread's last message. Allocates nothing.
void setLastError(const char* function, const char* text) noexcept;

/// Runs body() for the C function of that name and turns what it throws into a result.
template <class Body>
AWDResult guard(const char* function, Body&& body) noexcept {
  try {
    body();
    return AWD_SUCCESS;
  } catch (const Error& error) {
    setLastError(function, error.what());
    return error.code();
  } catch (const std::bad_alloc&) {
    setLastError(function, "out of memory");
    return AWD_ERROR_OUT_OF_MEMORY;
  } catch (const std::length_error&) {
    setLastError(function, "out of memory: more was asked for than can be addressed");
    return AWD_ERROR_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    setLastError(function, error.what());
    return AWD_ERROR_UNKNOWN;
  } catch (...) {
    setLastError(function, "unknown exception");
    return AWD_ERROR_UNKNOWN;
  }
}

/// A handle, pointer or array that must not be NULL.
template <class T>
T* need(T* pointer, const char* argument) {
  if (!pointer) fail(AWD_ERROR_INVALID_ARGUMENT, "%s is NULL", argument);
  return pointer;
}

/// An output pointer: must not be NULL, and is NULL in content until the call has succeeded.
template <class Handle>
void clearOutput(Handle* output, const char* argument) {
  *need(output, argument) = nullptr;
}

/// No struct of ours will ever be longer; a larger structSize was never initialised.
constexpr size_t kLongestStruct = 4096;

/// The structSize of a host's struct. Structs of all versions are made of whole words.
inline size_t sizeOfStruct(const void* host, const char* argument, const char* initMacro) {
  size_t size;
  std::memcpy(&size, need(host, argument), sizeof size);
  if (size < sizeof(size_t) || size > kLongestStruct || size % alignof(size_t) != 0) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "%s->structSize is %zu: initialise the struct with %s",
         argument, size, initMacro);
  }
  return size;
}

/// A copy of a host's struct as this library knows it: fields that the host's version lacks are 0,
/// and fields that this library lacks must be.
template <class T>
T readStruct(const T* host, const char* argument, const char* initMacro) {
  const size_t size = sizeOfStruct(host, argument, initMacro);
  const char* bytes = reinterpret_cast<const char*>(host);
  for (size_t i = sizeof(T); i < size; ++i) {
    if (bytes[i] != 0) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "%s uses a field at byte %zu that this version of the library does not know", argument,
           i);
    }
  }
  T known = {};
  std::memcpy(static_cast<void*>(&known), bytes, size < sizeof(T) ? size : sizeof(T));
  known.structSize = sizeof(T);
  return known;
}

/// Fills a host's struct with as much of `value` as its version has room for.
template <class T>
void writeStruct(T* host, T value, const char* argument, const char* initMacro) {
  const size_t size = sizeOfStruct(host, argument, initMacro);
  value.structSize = size;
  char* bytes = reinterpret_cast<char*>(host);
  std::memcpy(bytes, static_cast<const void*>(&value), size < sizeof(T) ? size : sizeof(T));
  if (size > sizeof(T)) std::memset(bytes + sizeof(T), 0, size - sizeof(T));
}

}  // namespace awd

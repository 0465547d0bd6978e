// SPDX-License-Identifier: Apache-2.0
// What saving and loading share.
#pragma once

#include <algorithm>
#include <memory_resource>
#include <vector>

#include "api/guard.h"
#include "basis/device.h"
#include "density/finders.h"
#include "density/refit_solvers.h"

namespace awd {

/// Hands bytes to the host if they fit.
inline void giveBytes(const std::pmr::vector<char>& from, void* bytes, size_t capacity,
                      size_t* size) {
  *size = from.size();
  if (capacity == 0) return;
  need(bytes, "bytes");
  if (capacity < from.size()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "capacity is %zu: there are %zu bytes", capacity, from.size());
  }
  std::copy(from.begin(), from.end(), static_cast<char*>(bytes));
}

inline const AWDBasisFamily& findFamily(void* device, const char* name) {
  return static_cast<Device*>(device)->registry().find(name);
}

inline const AWDRefitSolver& findSolver(void* device, const char* name) {
  const bool ignoreEnvironment = static_cast<Device*>(device)->registry().ignoresEnvironment();
  return findRefitSolver(refitFolders(ignoreEnvironment), name);
}

inline Finders findersOf(Device& device) { return {&device, findFamily, findSolver}; }

}  // namespace awd

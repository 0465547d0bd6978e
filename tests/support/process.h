// SPDX-License-Identifier: Apache-2.0
// What this process holds, as the kernel counts it.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>

namespace awdtest {

inline size_t entriesOf(const char* folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}
inline size_t threadsHeld() { return entriesOf("/proc/self/task"); }
/// One more than there are: the folder is open while it is read.
inline size_t filesHeld() { return entriesOf("/proc/self/fd"); }

/// Bytes of memory that are really there.
inline size_t memoryHeld() {
  size_t size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

/// Sanitizers keep what is freed for a while, and look for leaks themselves.
inline bool memoryIsWatched() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return true;
#endif
#endif
  return false;
}

}  // namespace awdtest

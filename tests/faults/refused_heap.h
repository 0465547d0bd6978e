// SPDX-License-Identifier: Apache-2.0
// The C++ heap of this program, which libawd shares: watched, and refused where a test says so.
#pragma once

#include <cstddef>
#include <string>

namespace awdtest {

/// While one lives the calls of operator new from libraries are watched: those of this program's
/// own code, which has tests and callbacks in it, are not.
class WatchedHeap {
 public:
  WatchedHeap();
  ~WatchedHeap();
  WatchedHeap(const WatchedHeap&) = delete;
  WatchedHeap& operator=(const WatchedHeap&) = delete;

  /// Refuses the call-th call from now on, and all later ones if that is wished; 0: none.
  static void refuse(size_t call, bool allLater);
  static size_t calls();
  /// Of libawd itself, and of the C++ runtime on its behalf: bytes in all, and of the largest
  /// block.
  static size_t ownBytes();
  static size_t ownLargest();
};

}  // namespace awdtest

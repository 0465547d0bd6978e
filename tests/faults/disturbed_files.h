// SPDX-License-Identifier: Apache-2.0
// What libawd asks of the system to write a file: watched, and made to fail where a test says so.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace awdtest {

/// While one lives, calls of write, fsync and rename by this thread are noted. They are those of
/// this program, which comes before libc in the order in which symbols are looked for.
class DisturbedFiles {
 public:
  DisturbedFiles();
  ~DisturbedFiles();
  DisturbedFiles(const DisturbedFiles&) = delete;
  DisturbedFiles& operator=(const DisturbedFiles&) = delete;

  /// The call-th call fails with that errno; 0: none.
  static void failAt(size_t call, int error);
  /// Every write takes this many bytes at most, and every second write and sync is interrupted.
  static void hamper(size_t most);
  /// In turn: "write", "fsync", "fsync folder" or "rename".
  static const std::vector<std::string>& calls();
};

}  // namespace awdtest

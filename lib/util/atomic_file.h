// SPDX-License-Identifier: Apache-2.0
// A file that is there whole or not at all: written beside its place, synced, renamed into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "util/uncancelled.h"

namespace awd {

class AtomicFile {
 public:
  /// Opens a temporary file in the folder of `path`. AWD_ERROR_IO, with path and reason, if that
  /// can't be done; likewise everything below.
  explicit AtomicFile(const char* path);
  /// Removes the temporary file unless it was committed.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t bytes);
  uint64_t position() const { return position_; }
  void seek(uint64_t position);
  /// Syncs, closes, renames, and syncs the folder.
  void commit();
  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void failed(const char* action) const;

  Uncancelled uncancelled_;
  std::string path_, temporary_;
  int descriptor_ = -1;
  uint64_t position_ = 0;
};

}  // namespace awd

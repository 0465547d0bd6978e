// SPDX-License-Identifier: Apache-2.0
// A folder for the files of a process, gone when that ends.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "support/temporary_folder.h"
#include "target.h"

namespace fuzz {

inline std::string scratchPath(const char* name) {
  static const awdtest::TemporaryFolder folder;
  return folder.path(name);
}

inline void writeScratch(const std::string& path, const Input& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

inline Input readScratch(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace fuzz

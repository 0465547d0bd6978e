// SPDX-License-Identifier: Apache-2.0
// Whether a name is that of a file.
#pragma once

#include <filesystem>
#include <system_error>

/// A pipe or device, which may never end, is none; nor is a name that the system doesn't take, for
/// which std::filesystem would throw.
inline bool isRegularFile(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

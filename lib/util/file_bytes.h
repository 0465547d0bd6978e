// SPDX-License-Identifier: Apache-2.0
// A whole file in memory.
#pragma once

#include <memory_resource>
#include <vector>

namespace awd {

/// AWD_ERROR_IO, with path and reason, if the file can't be read or is no regular one (a pipe could
/// block for ever).
std::pmr::vector<char> readFile(std::pmr::memory_resource* memory, const char* path);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// Where the library itself lies.
#pragma once

#include <string>

namespace awd {

/// Absolute folder of the file that this code was loaded from, libawd.so or a program that it is
/// linked into; "" if the system does not tell. Symbolic links are resolved, and a relative path
/// that the library was opened by never meets a current folder that has changed since.
std::string libraryFolder();

}  // namespace awd

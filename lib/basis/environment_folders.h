// SPDX-License-Identifier: Apache-2.0
// Folders of modules that the user names in the environment.
#pragma once

#include <string>
#include <vector>

namespace awd {

/// The entries of such a variable, separated by ':'; none when the process is privileged.
std::vector<std::string> environmentFolders(const char* variable);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// Small OpenEXR files of every kind, for whoever may not include OpenEXR's headers.
#pragma once

#include <string>
#include <vector>

namespace awdtest {

/// The files' contents; each is written to `path` on the way.
std::vector<std::string> exrSeeds(const std::string& path);

}  // namespace awdtest

// SPDX-License-Identifier: Apache-2.0
// Which files may be loaded because they lie where modules are looked for.
#pragma once

#include <string>

namespace awd {

/// Why code must not be taken from `file`, an absolute path, unless the host itself named it; "" if
/// it may be. Links are followed: neither the file nor the folder where it really lies may be one
/// that anybody may write to.
std::string distrust(const std::string& file);

}  // namespace awd

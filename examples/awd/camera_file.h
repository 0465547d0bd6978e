// SPDX-License-Identifier: Apache-2.0
// Cameras as JSON: eye, look_dir, up, tan_half_fov_x, width, height.
#pragma once

#include <string>

#include "awd/awd.h"

namespace command {

/// Throws a Failure that names file and key if one of the keys is missing, of the wrong type, out
/// of range or degenerate. Other keys are ignored.
AWDCamera readCameraFile(const std::string& path);

}  // namespace command

// SPDX-License-Identifier: Apache-2.0
// A render from anywhere, looked at.
#pragma once

#include "awd/awd.h"

namespace fuzz {

/// Film, error and figures make sense.
void lookAt(AWDRender render);

}  // namespace fuzz

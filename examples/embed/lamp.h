// SPDX-License-Identifier: Apache-2.0
// A scene of the host's, rendered by libawd into pixels of the host's.
#pragma once

#include "awd/awd.hpp"
#include "host.h"

namespace host {

/// A floor under a lamp.
Picture renderLamp(const awd::Device& device, uint32_t width, uint32_t height);

}  // namespace host

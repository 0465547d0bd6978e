// SPDX-License-Identifier: Apache-2.0
// A field from its description: with what it needs from the device.
#pragma once

#include "basis/device.h"
#include "guide/field.h"

namespace awd {

Ref<Field> makeField(Device& device, const AWDFieldDesc& desc);

}  // namespace awd

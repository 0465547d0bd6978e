// SPDX-License-Identifier: Apache-2.0
// A field from anywhere, used as hosts use fields.
#pragma once

#include "bounded_device.h"
#include "support/handles.h"
#include "target.h"

namespace fuzz {

/// Records a few samples in patches of the library's or the host's, and aborts if what the field
/// says of them makes no sense.
void recordField(AWDField field, int samples, uint64_t seed);

Input savedField(AWDField field);

/// Samples, records, adapts, merges, saves and loads.
void useField(const Bounds& bounds, AWDField field);

}  // namespace fuzz

// SPDX-License-Identifier: Apache-2.0
// The statistics of a pass as bytes, within the frame of whoever writes them.
#pragma once

#include "density/statistics.h"
#include "util/bytes.h"

namespace awd {

/// Exactly, to the last bit of its mantissa.
void put(ByteWriter& writer, long double number);
long double getLong(ByteReader& reader);

void put(ByteWriter& writer, const DensityStatistics& statistics);
/// Into statistics of the sizes that the bytes must have.
void get(ByteReader& reader, DensityStatistics& statistics);

}  // namespace awd

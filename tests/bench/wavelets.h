// SPDX-License-Identifier: Apache-2.0
// What dropping wavelet details below their standard error saves, and what it costs.
#pragma once

#include <vector>

#include "awd/awd.h"
#include "row.h"

namespace bench {

/// A row for each basis whose supports nest and each of five functions of two variables: trees that
/// have learned from so many samples, with all details and without those that are noise.
std::vector<Row> measureWavelets(AWDDevice device, std::size_t samples);

}  // namespace bench

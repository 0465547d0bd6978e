// SPDX-License-Identifier: Apache-2.0
// What no input may do to a density: cases, each with what is to come of it. Through the C
// interface.
#pragma once

#include <vector>

#include "support/extreme.h"

namespace awdtest {

/// All of those below.
const std::vector<Extreme>& densityExtremes();

std::vector<Extreme> sampleExtremes();
std::vector<Extreme> shapeExtremes();

}  // namespace awdtest

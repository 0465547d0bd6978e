// SPDX-License-Identifier: Apache-2.0
// What no scene and no film may do to a render: cases, each with what is to come of it. Through the
// C interface.
#pragma once

#include <vector>

#include "support/extreme.h"

namespace awdtest {

const std::vector<Extreme>& sceneExtremes();

// The list, in the order of its parts.
std::vector<Extreme> radianceExtremes();
std::vector<Extreme> lightExtremes();
std::vector<Extreme> sizeExtremes();
std::vector<Extreme> countExtremes();

}  // namespace awdtest

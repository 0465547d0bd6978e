// SPDX-License-Identifier: Apache-2.0
// An order of the unknowns that keeps the entries of A near its diagonal.
#pragma once

#include <cstdint>
#include <vector>

#include "refit/quadratic.h"

namespace awd {

/// Reverse Cuthill-McKee; the unknowns of each connected part follow each other.
std::vector<uint32_t> reverseCuthillMcKee(const Quadratic& quadratic);

}  // namespace awd

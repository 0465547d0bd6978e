// SPDX-License-Identifier: Apache-2.0
// Promises of the library that end the program if they are broken.
#pragma once

#include <initializer_list>

#include "awd/awd.h"

namespace fuzz {

/// Aborts with `what` and the library's last message unless it holds.
void require(bool holds, const char* what);

/// The result is success, or one of those and has a message. Returns whether it is success.
bool oneOf(AWDResult result, std::initializer_list<AWDResult> failures, const char* what);

/// Finite and not negative.
bool isDensity(double value);

}  // namespace fuzz

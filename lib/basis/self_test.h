// SPDX-License-Identifier: Apache-2.0
// Is a family what it says it is? Asked of every family before its name becomes visible: wrong
// mathematics in a plugin would bias every estimate without a sign.
#pragma once

#include <vector>

#include "awd/basis.h"
#include "basis/check.h"

namespace awd {

/// All checks that could be made, in order; those that stand on a failed one are left out. The
/// lowest levels are tested in full, those above in places. `family` has passed checkModule.
/// Not toTheEnd: nothing after the first failure.
std::vector<Check> selfTest(const AWDBasisFamily& family, bool toTheEnd = true);

/// The first check that failed, or null.
const Check* firstFailure(const std::vector<Check>& checks);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// What `awd-bench trade` compares: the methods of `awd-bench guide`, and several of them at once as
// "haar+quasi".
#pragma once

#include <string>
#include <vector>

#include "guide_scenes.h"

namespace bench::trade {

/// The baseline first; then bases, levels, estimators, schedules and shares of cosine sampling.
const std::vector<std::string>& defaultMethods();

/// Throws, with the names that there are, if a part of the name is none of them.
guide::Contender contender(const std::string& name);

}  // namespace bench::trade

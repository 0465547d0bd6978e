// SPDX-License-Identifier: Apache-2.0
// What `awd-bench guide` compares. A new method is a line in guide_methods.cpp.
#pragma once

#include <string>
#include <vector>

#include "render_shots.h"

namespace bench::guide {

struct Method {
  const char* name;
  const char* what;                ///< a line about it
  void (*change)(Settings& with);  ///< from the defaults
};

const std::vector<Method>& methods();

/// Throws, with the names that there are, if it is none of them.
const Method& methodNamed(const std::string& name);

}  // namespace bench::guide

// SPDX-License-Identifier: Apache-2.0
// What `awd-bench rival` guides a host by. A new method is a line in rival_methods.cpp or, of Open
// PGL, in rival_openpgl.cpp.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host_tracer.h"

namespace bench::rival {

struct Method {
  std::string name;
  std::string what;  ///< a line about it
  /// A guide that knows nothing yet; NULL: unguided.
  std::function<std::unique_ptr<host::Guide>(AWDDevice device, const host::Scene& scene)> make;
};

const std::vector<Method>& methods();

/// Throws, with the names that there are, if it is none of them.
const Method& methodNamed(const std::string& name);

/// Those of Open PGL; only where AWD_BENCH_OPENPGL is defined.
std::vector<Method> openPglMethods();

}  // namespace bench::rival

// SPDX-License-Identifier: Apache-2.0
// Finding what was asked for by name.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

/// Throws, with the names that there are, if it is none of them.
template <class Method>
const Method& named(const std::vector<Method>& methods, const std::string& name) {
  std::string message = "no method " + name + "; there are";
  for (const Method& method : methods) {
    if (method.name == name) return method;
    message.append(" ").append(method.name);
  }
  throw std::runtime_error(message);
}

}  // namespace bench

// SPDX-License-Identifier: Apache-2.0
#include "failure.h"

namespace command {

std::string inQuotes(const std::string& text) { return '"' + text + '"'; }

}  // namespace command

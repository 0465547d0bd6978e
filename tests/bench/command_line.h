// SPDX-License-Identifier: Apache-2.0
// What the program was called with, for the files that it writes.
#pragma once

#include <string>

namespace bench {

/// Once, at the start.
void setCommandLine(int argumentCount, const char* const* arguments);

/// "awd-bench NAME ...", as a shell would take it.
const std::string& commandLine();

}  // namespace bench

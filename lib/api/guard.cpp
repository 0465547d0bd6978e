// SPDX-License-Identifier: Apache-2.0
#include "api/guard.h"

#include <cstdio>

#include "awd/device.h"

namespace awd {

namespace {
thread_local char lastError[1280] = "";
}

void setLastError(const char* function, const char* text) noexcept {
  std::snprintf(lastError, sizeof lastError, "%s: %s", function, text);
  makeOneLine(lastError);
}

}  // namespace awd

extern "C" const char* AWD_CALL awdGetLastErrorMessage(void) noexcept { return awd::lastError; }

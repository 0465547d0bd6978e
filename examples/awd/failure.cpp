// SPDX-License-Identifier: Apache-2.0
#include "failure.h"

namespace command {

void check(AWDResult result, const std::string& what) {
  if (result == AWD_SUCCESS) return;
  const std::string message = awdGetLastErrorMessage();
  throw Failure(what.empty() ? message : what + ": " + message);
}

std::string inQuotes(const std::string& text) { return '"' + text + '"'; }

}  // namespace command

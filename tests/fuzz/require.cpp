// SPDX-License-Identifier: Apache-2.0
#include "require.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fuzz {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s; last message: %s\n", what, awdGetLastErrorMessage());
  std::abort();
}

bool oneOf(AWDResult result, std::initializer_list<AWDResult> failures, const char* what) {
  if (result == AWD_SUCCESS) return true;
  if (std::find(failures.begin(), failures.end(), result) == failures.end()) {
    std::fprintf(stderr, "%s: %s\n", what, awdGetResultString(result));
    require(false, "not one of the results that it may have");
  }
  const char* reason = std::strstr(awdGetLastErrorMessage(), ": ");
  require(reason != nullptr && reason[2] != '\0', "failed without a reason");
  return false;
}

bool isDensity(double value) { return std::isfinite(value) && value >= 0.0; }

}  // namespace fuzz

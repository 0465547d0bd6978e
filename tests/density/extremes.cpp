// SPDX-License-Identifier: Apache-2.0
#include "density/extremes.h"

namespace awdtest {

const std::vector<Extreme>& densityExtremes() {
  static const std::vector<Extreme> all = [] {
    std::vector<Extreme> cases = sampleExtremes();
    const std::vector<Extreme> more = shapeExtremes();
    cases.insert(cases.end(), more.begin(), more.end());
    return cases;
  }();
  return all;
}

}  // namespace awdtest

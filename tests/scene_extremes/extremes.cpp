// SPDX-License-Identifier: Apache-2.0
#include "scene_extremes/extremes.h"

namespace awdtest {

const std::vector<Extreme>& sceneExtremes() {
  static const std::vector<Extreme> all = [] {
    std::vector<Extreme> cases;
    for (const auto part : {radianceExtremes, lightExtremes, sizeExtremes, countExtremes}) {
      const std::vector<Extreme> more = part();
      cases.insert(cases.end(), more.begin(), more.end());
    }
    return cases;
  }();
  return all;
}

}  // namespace awdtest

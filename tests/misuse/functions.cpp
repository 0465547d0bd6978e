// SPDX-License-Identifier: Apache-2.0
#include "misuse/functions.h"

namespace awdmisuse {

const std::vector<Function>& allFunctions() {
  static const std::vector<Function> kAll = [] {
    std::vector<Function> all;
    addDeviceFunctions(all);
    addFieldFunctions(all);
    addSceneFunctions(all);
    addRenderFunctions(all);
    addImageFunctions(all);
    return all;
  }();
  return kAll;
}

}  // namespace awdmisuse

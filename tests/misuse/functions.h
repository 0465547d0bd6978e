// SPDX-License-Identifier: Apache-2.0
// The table of functions, by header.
#pragma once

#include <vector>

#include "misuse/caller.h"

namespace awdmisuse {

/// What a field may be made of; NULL in good calls too.
const AWDFieldDesc* fieldDesc(Caller& c);

void addDeviceFunctions(std::vector<Function>& all);  ///< and densities
void addFieldFunctions(std::vector<Function>& all);   ///< and lights
void addSceneFunctions(std::vector<Function>& all);
void addRenderFunctions(std::vector<Function>& all);
void addImageFunctions(std::vector<Function>& all);

}  // namespace awdmisuse

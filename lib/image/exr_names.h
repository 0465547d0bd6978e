// SPDX-License-Identifier: Apache-2.0
// The attribute names of OpenEXR that can't be lines of metadata.
#pragma once

#include <string_view>

namespace awd {

/// Whether OpenEXR gives attributes of this name a meaning other than that of free text, so that a
/// file with such a string would mislead its readers.
bool isReservedAttribute(std::string_view name);

}  // namespace awd

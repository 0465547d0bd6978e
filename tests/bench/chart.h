// SPDX-License-Identifier: Apache-2.0
// Plots as inline SVG whose colours and fonts are those of the page that it stands in: classes
// chart-*, which the report's style sheet knows. Needs no drawing library.
#pragma once

#include <string>

#include "plot.h"

namespace bench {

/// An <svg> element. On logarithmic axes values that aren't positive are left out, as are those
/// that aren't finite on any.
std::string chartSvg(const Plot& plot);

}  // namespace bench

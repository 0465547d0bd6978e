// SPDX-License-Identifier: Apache-2.0
// The figures of `awd-bench refit`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plot.h"
#include "row.h"

namespace bench::refit {

/// What is done with a plot; name: "refit-...".
using TakePlot = std::function<void(const Plot& plot, const std::string& name)>;

/// Of each part that there are rows of.
void plotDensities(const std::vector<Row>& rows, const TakePlot& take);

/// Error against CPU time for each scene.
void plotScenes(const std::vector<Row>& rows, const TakePlot& take);

}  // namespace bench::refit

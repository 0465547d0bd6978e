// SPDX-License-Identifier: Apache-2.0
// The figures of `awd-bench refit`.
#pragma once

#include <string>
#include <vector>

#include "row.h"

namespace bench::refit {

/// Of each part that there are rows of: FOLDER/refit-....svg and .png.
void plotDensities(const std::vector<Row>& rows, const std::string& folder);

/// Error against CPU time for each scene: FOLDER/refit-render-....svg and .png.
void plotScenes(const std::vector<Row>& rows, const std::string& folder);

}  // namespace bench::refit

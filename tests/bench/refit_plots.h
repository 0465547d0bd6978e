// SPDX-License-Identifier: Apache-2.0
// The figures of `awd-bench refit`.
#pragma once

#include <vector>

#include "report.h"
#include "row.h"

namespace bench::refit {

/// Of each part that there are rows of.
void plotDensities(const std::vector<Row>& rows, ReportSection& section);

/// Error against CPU time for each scene.
void plotScenes(const std::vector<Row>& rows, ReportSection& section);

}  // namespace bench::refit

// SPDX-License-Identifier: Apache-2.0
// What `awd-bench density` says in the report.
#pragma once

#include <vector>

#include "density_report.h"
#include "report.h"

namespace bench {

ReportSection densitySection(const std::vector<Table>& tables);

}  // namespace bench

// SPDX-License-Identifier: Apache-2.0
// What `awd-bench guide` and `awd-bench rival` say in the report.
#pragma once

#include <string>
#include <vector>

#include "report.h"
#include "row.h"

namespace bench::guide {

/// From the rows of guide_report.h. name: of the command; baseline: a method.
ReportSection sectionOf(const std::string& name, const std::string& baseline,
                        const std::vector<Row>& rows);

}  // namespace bench::guide

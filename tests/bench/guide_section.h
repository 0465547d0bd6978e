// SPDX-License-Identifier: Apache-2.0
// What `awd-bench guide` and `awd-bench rival` say in the report.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report.h"
#include "row.h"

namespace bench::guide {

/// Images of one scene by all methods, and the reference.
struct Inset {
  std::string scene;
  uint32_t samples = 0;  ///< a pixel
  std::vector<ReportImage> images;
};

/// From the rows of guide_report.h. name: of the command; baseline: a method.
ReportSection sectionOf(const std::string& name, const std::string& baseline,
                        const std::vector<Row>& rows, const std::vector<Inset>& insets);

}  // namespace bench::guide

// SPDX-License-Identifier: Apache-2.0
// Rows of `awd-bench scale` as a section of the report.
#pragma once

#include <string>
#include <vector>

#include "row.h"

namespace bench::scale {

/// What grows, in the order in which it is measured.
struct Part {
  const char* name;   ///< of the rows
  const char* label;  ///< of the axis
  const char* what;
};
const std::vector<Part>& parts();

/// DIR/sections/scale.html, and with it DIR/index.html. command: the line that measured the rows.
void writeSection(const std::vector<Row>& rows, const std::string& command,
                  const std::string& folder);

}  // namespace bench::scale

// SPDX-License-Identifier: Apache-2.0
// The files that `awd-bench trade` writes: trade.json, trade.csv and its section of the report.
#pragma once

#include <string>
#include <vector>

#include "trade_plane.h"

namespace bench::trade {

struct Findings {
  Row head;  ///< the command line, seeds, threads
  std::vector<ScenePlane> planes;
  std::vector<Row> qualities;  ///< of measureQualities
};

void print(const Findings& findings);

void write(const Findings& findings, const std::string& folder);

}  // namespace bench::trade

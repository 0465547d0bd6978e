// SPDX-License-Identifier: Apache-2.0
// Table 1 and figures 3, 5 and 6 in the report, with the paper's own numbers beside ours.
#pragma once

#include <string>
#include <vector>

#include "paper.h"

namespace bench::paper {

/// A number of samples a pixel; values by seed.
struct CurvePoint {
  uint32_t samples = 0;
  std::vector<double> l1, cpuSeconds;
};

struct QualityOf {
  std::string scene;
  std::vector<std::vector<CurvePoint>> curves;  ///< one a method, in the order of methods()
  std::vector<command::RgbImage> images;        ///< likewise: of seed 1, at the table's samples
  command::RgbImage reference;
  double referenceRelMse = 0.0;
};

void addRows(const QualityOf& quality, std::vector<Row>& rows);
void writeQuality(const std::vector<QualityOf>& all, Study& study);

}  // namespace bench::paper

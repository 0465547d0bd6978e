// SPDX-License-Identifier: Apache-2.0
// The densities that extreme cases are tried with.
#pragma once

#include <string>
#include <vector>

#include "density/densities.h"
#include "support/findings.h"

namespace awdtest {

/// Without a floor under the coefficients.
constexpr double kNoFloor = -1.0;

/// One for all cases: a device tests each family when it is first asked for.
AWDDevice extremeDevice();

struct Kind {
  std::string name;
  Axes axes;
  AWDDensityDesc desc;

  uint32_t dimensions() const { return static_cast<uint32_t>(axes.size()); }
};

/// Every family as a grid, the nested ones as a tree too.
std::vector<Kind> kinds(uint32_t dimensions, AWDDensityAxis like = {}, uint64_t most = 256);

/// Is it a density still? Integral, points, and that pdfs are those of the points.
void expectSane(Findings& found, AWDDensity density, const std::string& name);

Function bumpOf(const Kind& kind, double scale = 1.0);

}  // namespace awdtest

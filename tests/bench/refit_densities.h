// SPDX-License-Identifier: Apache-2.0
// The comparison on densities: which cells there are, and what each measures.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "refit_trial.h"
#include "row.h"

namespace bench::refit {

/// What a cell belongs to.
enum class Part {
  kShrinkage,  ///< quasi and refit over kappa
  kFirst,      ///< one pass from the uniform density, at a fixed level
  kAdaptive,   ///< four passes that choose their levels
  kTime        ///< one pass, over the number of coefficients
};
constexpr Part kParts[] = {Part::kShrinkage, Part::kFirst, Part::kAdaptive, Part::kTime};

const char* nameOf(Part part);

/// Called before each cell with those done and all; false: stop here.
using Watch = std::function<bool(std::size_t done, std::size_t all)>;

struct PartOptions {
  bool quick = false;
  std::vector<int> dimensions{1, 2, 3, 4};  ///< other cells are left out
};

/// A row for each method and cell, up to where `watch` said to stop. Seeds and methods take turns
/// within a cell.
std::vector<Row> measurePart(AWDDevice device, const std::vector<Method>& methods, Part part,
                             const PartOptions& options, const Watch& watch);

}  // namespace bench::refit

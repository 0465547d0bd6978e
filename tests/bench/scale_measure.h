// SPDX-License-Identifier: Apache-2.0
// What a ray and a path cost, of guided and unguided renders that take turns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "row.h"
#include "scale_scenes.h"

namespace bench::scale {

struct Method {
  const char* name;
  const char* what;
  void (*change)(Settings& settings);
};

/// The unguided one first, which the others are compared with.
const std::vector<Method>& methods();

/// What one point of a series renders.
struct Point {
  std::string part;  ///< of the report: what grows
  double x;          ///< how much of it, where that is known beforehand; else 0
  const CommittedScene* scene;
  uint32_t samples;           ///< a pixel
  uint32_t threads = 1;       ///< of the scene's device
  uint32_t patchSamples = 0;  ///< of the field; 0: the default
};

/// A row for each method: CPU time a ray and a path, medians and quartiles over the repetitions,
/// and its ratio to that of the unguided method in the same repetition. None: cancelled.
std::optional<std::vector<Row>> measure(const Point& point, int repetitions, Cancelled cancelled);

}  // namespace bench::scale

// SPDX-License-Identifier: Apache-2.0
// Sequences of wild calls, each run in a process of its own: a crash is an outcome like any other.
#pragma once

#include <string>
#include <vector>

#include "misuse/caller.h"

namespace awdmisuse {

struct Step {
  size_t function;  ///< in allFunctions()
  uint64_t seed;    ///< of its arguments
};

struct Outcome {
  std::string complaint;  ///< "" if all was well
  std::string calls;      ///< as C-like lines, up to the one that went wrong
};

std::vector<Step> randomSteps(uint64_t seed, size_t count);

/// Runs the steps in a child of this process that begins with the world as it is, does the
/// reference operations, and releases everything.
Outcome runSteps(World& world, const std::vector<Step>& steps,
                 const std::vector<double>& reference);

/// As few of the steps as still go wrong.
std::vector<Step> shrink(World& world, std::vector<Step> steps,
                         const std::vector<double>& reference);

}  // namespace awdmisuse

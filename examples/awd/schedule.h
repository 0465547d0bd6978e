// SPDX-License-Identifier: Apache-2.0
// How the samples are spread over passes, from --passes, --spp and --samples.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace command {

/// All empty: the preset's.
struct Schedule {
  std::vector<uint32_t> samplesPerPass;
  uint32_t totalSamples = 0;
  double seconds = 0.0;  ///< 0: no limit
  double error = 0.0;    ///< likewise
};

/// spp: "N1,...,NK"; a single number holds for all passes. Throws a UsageError if the options
/// contradict each other.
Schedule makeSchedule(std::optional<uint32_t> passes, const std::optional<std::string>& spp,
                      std::optional<uint32_t> samples);

}  // namespace command

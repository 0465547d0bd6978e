// SPDX-License-Identifier: Apache-2.0
// Whether the promises of AWDQuality are kept: what each takes on a scene, and how far the image is
// from the truth.
#pragma once

#include <string>
#include <vector>

#include "guide_scenes.h"

namespace bench::trade {

/// In the order of AWD_QUALITY_..., which begin with 1.
const std::vector<std::string>& qualityNames();

/// A row for each scene, quality (by name) and seed, which is also printed. False: cancelled; rows
/// that were done by then are there.
bool measureQualities(const guide::Options& options, const std::vector<std::string>& qualities,
                      Cancelled cancelled, std::vector<Row>& rows);

}  // namespace bench::trade

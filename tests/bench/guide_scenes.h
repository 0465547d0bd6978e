// SPDX-License-Identifier: Apache-2.0
// The renders of `awd-bench guide`.
#pragma once

#include <string>
#include <vector>

#include "guide_methods.h"
#include "guide_report.h"

namespace bench::guide {

struct Options {
  std::string moreScenes;         ///< a folder of folders with a scene file each, or ""
  std::vector<std::string> only;  ///< scenes by name; none: all
  std::vector<std::string> names{"cosine", "adaptive"};  ///< of methods, the baseline first
  std::vector<uint32_t> samples{32, 64, 128, 256, 512};  ///< a pixel
  int seeds = 5;
  uint32_t threads = 1;
  uint32_t width = 128;    ///< of images without such files as follow
  std::string references;  ///< a folder with SCENE-*.exr; scenes without any are left out. "": none
  uint32_t referenceSamples = 8192;  ///< of those made without them, a pixel
  std::string folder;                ///< for the report and the references made, or ""
};

/// Renders, and reports each row as soon as it has its last seed. False: cancelled; what was done
/// by then is reported too.
bool measureScenes(const Options& options, Report& report, Cancelled cancelled);

}  // namespace bench::guide

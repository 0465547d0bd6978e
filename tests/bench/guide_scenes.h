// SPDX-License-Identifier: Apache-2.0
// The renders of `awd-bench guide` and `awd-bench rival`.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "guide_report.h"

namespace bench::guide {

struct Options {
  std::string moreScenes;         ///< a folder of folders with a scene file each, or ""
  std::vector<std::string> only;  ///< scenes by name; none: all
  std::vector<uint32_t> samples{32, 64, 128, 256, 512};  ///< a pixel
  int seeds = 5;
  uint32_t threads = 1;
  uint32_t width = 128;    ///< of images without such files as follow
  std::string references;  ///< a folder with SCENE-*.exr; scenes without any are left out. "": none
  uint32_t referenceSamples = 8192;  ///< of those made without them, a pixel
  std::string folder;                ///< for the report and the references made, or ""
};

/// One of those that are compared.
struct Contender {
  std::string name;
  /// One image, from nothing learned on. False: cancelled.
  std::function<bool(const awd::Device& device, const LoadedScene& loaded, uint32_t samples,
                     uint64_t seed, Shot& shot)>
      shoot;
};

/// The scenes that are asked for: files by name. Throws if there is none of a name.
std::map<std::string, std::string> chosenScenes(const Options& options);

/// One of them, with its reference. None: left out for want of one, which is said, or cancelled.
std::optional<LoadedScene> loadChosen(const awd::Device& device, const Options& options,
                                      const std::string& name, const std::string& file);

/// Renders, the baseline first, and reports each row as soon as it has its last seed. False:
/// cancelled; what was done by then is reported too.
bool measureScenes(const Options& options, const std::vector<Contender>& contenders, Report& report,
                   Cancelled cancelled);

}  // namespace bench::guide

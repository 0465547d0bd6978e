// SPDX-License-Identifier: Apache-2.0
// The comparison in the renderer: error against CPU time on scenes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "refit_trial.h"
#include "render_shots.h"
#include "row.h"

namespace bench::refit {

struct SceneOptions {
  bool quick = false;
  std::string moreScenes;  ///< a folder of folders with a scene file each, or ""
  std::string folder;      ///< where references are kept
  std::vector<uint32_t> samples{16, 64, 256};  ///< a pixel
  uint32_t referenceSamples = 8192;            ///< a pixel
  int seeds = 5;
};

/// Called before each image with those done and all; false: stop here.
using SceneWatch = std::function<bool(std::size_t done, std::size_t all)>;

/// A row for each scene, basis, method and number of samples, up to where `watch` said to stop.
/// Errors are those against a reference: the one beside the scene, else one made by unguided
/// paths and kept in the folder.
std::vector<Row> measureScenes(const std::vector<Method>& methods, SceneOptions options,
                               const SceneWatch& watch, Cancelled cancelled);

}  // namespace bench::refit

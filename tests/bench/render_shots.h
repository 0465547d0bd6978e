// SPDX-License-Identifier: Apache-2.0
// Scenes rendered under settings that are compared: what came out, and what it cost.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "awd/awd.hpp"
#include "render_reference.h"
#include "row.h"

namespace bench {

/// Whether to give up what is being rendered.
using Cancelled = bool (*)();

/// Knows the cubic B-splines of examples/cubic-bspline, too, which are not shipped.
awd::Device newRenderDevice(uint32_t threads, Cancelled cancelled);

/// Our scenes, and those in the folders of `moreScenes` unless that is "": scene files by the
/// names of their folders.
std::map<std::string, std::string> sceneFiles(const std::string& moreScenes);

struct LoadedScene {
  std::string name, file;
  awd::Scene scene;
  AWDCamera camera = AWD_CAMERA_INIT;
  Reference reference;
};

/// Without a reference yet. The height follows from the camera's aspect.
LoadedScene loadScene(const awd::Device& device, const std::string& name, const std::string& file,
                      uint32_t width);

/// Sets the reference: the one beside the scene, else one made by unguided paths and kept in the
/// folder. False: cancelled while it was made.
bool takeReference(const awd::Device& device, const std::string& folder, uint32_t samples,
                   LoadedScene& loaded);

/// All that a host may ask for. Camera, seed and number of samples are set by who renders.
struct Settings {
  AWDFieldDesc field = AWD_FIELD_DESC_INIT;
  AWDRenderDesc render = AWD_RENDER_DESC_INIT;
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  uint32_t equalPasses = 0;  ///< at most, with the rest in the last; 0: the library divides
};

/// Errors against the reference; its own variance is taken off the squared ones.
struct Shot {
  double relMse, relMseTrimmed, l1;
  double cpuSeconds, rays;
  double patches, coefficients, bytes;  ///< NaN: not known
  command::RgbImage image = {};         ///< empty: not kept
};

/// One image, from an empty field on. False: cancelled.
bool shoot(const LoadedScene& loaded, Settings settings, uint32_t samples, uint64_t seed,
           Shot& shot);

using Figure = double (*)(const Shot& shot);

double efficiency(const Shot& shot);           ///< 1 / (trimmed relMSE x CPU seconds)
double untrimmedEfficiency(const Shot& shot);  ///< 1 / (relMSE x CPU seconds)
double l1Efficiency(const Shot& shot);         ///< 1 / (L1^2 x CPU seconds)
double rayRate(const Shot& shot);              ///< rays a CPU second

/// Median and quartiles.
Spread spreadOf(const std::vector<Shot>& shots, Figure figure);

/// Of figure / figure in `base`, seed by seed as far as both have the seed: median and its 95 %
/// interval by bootstrap. None without seeds, or where a figure is not above 0: the variance of
/// the reference may be as large as an error.
std::optional<Spread> ratioOf(const std::vector<Shot>& shots, const std::vector<Shot>& base,
                              Figure figure);

}  // namespace bench

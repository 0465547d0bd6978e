// SPDX-License-Identifier: Apache-2.0
#include "guide_methods.h"

#include "named.h"

namespace bench::guide {

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"cosine", "unguided, indirect rays by the cosine",
       [](Settings& with) { with.render.guide = AWD_GUIDE_COSINE; }},
      {"uniform", "unguided, indirect rays uniform over the hemisphere",
       [](Settings& with) { with.render.guide = AWD_GUIDE_UNIFORM; }},
      {"paper", "guided, Pietrek and Peter 1999 to the letter",
       [](Settings& with) { with.field.preset = with.render.preset = AWD_PRESET_PAPER; }},
      {"adaptive", "guided, all defaults", [](Settings&) {}},

      {"cosine-four-shadow-rays", "cosine, four shadow rays a vertex",
       [](Settings& with) {
         with.render.guide = AWD_GUIDE_COSINE;
         with.render.shadowRays = 4;
       }},
      {"four-shadow-rays", "adaptive, four shadow rays a vertex",
       [](Settings& with) { with.render.shadowRays = 4; }},
      {"all-lights", "adaptive, a shadow ray to each of up to 8 lights",
       [](Settings& with) { with.render.maxLights = 8; }},

      {"haar", "adaptive with this basis", [](Settings& with) { with.field.basis = "haar"; }},
      {"quadratic-bspline", "adaptive with this basis",
       [](Settings& with) { with.field.basis = "quadratic-bspline"; }},
      {"cubic-bspline", "adaptive with this basis, of examples/cubic-bspline",
       [](Settings& with) { with.field.basis = "cubic-bspline"; }},
      {"f2", "adaptive with this basis", [](Settings& with) { with.field.basis = "f2"; }},
      {"m2", "adaptive with this basis", [](Settings& with) { with.field.basis = "m2"; }},
      {"m3", "adaptive with this basis", [](Settings& with) { with.field.basis = "m3"; }},

      {"mixture", "adaptive with this estimator",
       [](Settings& with) { with.field.estimator = AWD_ESTIMATOR_MIXTURE; }},
      {"ratio", "adaptive with this estimator",
       [](Settings& with) { with.field.estimator = AWD_ESTIMATOR_RATIO; }},
      {"quasi", "adaptive with this estimator",
       [](Settings& with) { with.field.estimator = AWD_ESTIMATOR_QUASI; }},
      {"refit", "adaptive with this estimator, if there is a refit module",
       [](Settings& with) { with.field.estimator = AWD_ESTIMATOR_REFIT; }},

      {"spherical", "adaptive with this map of the hemisphere",
       [](Settings& with) { with.field.map = AWD_MAP_SPHERICAL; }},
      {"cylindrical", "adaptive with this map of the hemisphere",
       [](Settings& with) { with.field.map = AWD_MAP_CYLINDRICAL; }},
      {"cosine-map", "adaptive with this map of the hemisphere",
       [](Settings& with) { with.field.map = AWD_MAP_COSINE; }},
      {"level-2", "adaptive, densities of 4 x 4 cells",
       [](Settings& with) { with.field.maxLevel = AWD_LEVEL(2); }},
      {"level-3", "adaptive, densities of 8 x 8 cells, none refined",
       [](Settings& with) { with.field.maxLevel = AWD_LEVEL(3); }},
      {"level-4", "adaptive, densities of 16 x 16 cells from the start",
       [](Settings& with) { with.field.startLevel = AWD_LEVEL(4); }},
      {"root-mean-square", "adaptive, densities as sqrt(E[f^2]) instead of E[f]",
       [](Settings& with) { with.field.target = AWD_TARGET_RMS; }},
      {"alpha-0.03", "adaptive, this share of cosine sampling in every density",
       [](Settings& with) { with.field.alpha = 0.03; }},
      {"alpha-0.3", "adaptive, this share of cosine sampling in every density",
       [](Settings& with) { with.field.alpha = 0.3; }},
      {"planar-patches", "adaptive, a patch for each planar piece of the scene",
       [](Settings& with) { with.field.patches = AWD_PATCHES_HOST; }},
      {"patches-of-500", "adaptive, patches split at so many samples",
       [](Settings& with) { with.field.patchSamples = 500; }},
      {"patches-of-8000", "adaptive, patches split at so many samples",
       [](Settings& with) { with.field.patchSamples = 8000; }},

      {"direct-area", "adaptive, light found by shadow rays alone",
       [](Settings& with) { with.render.direct = AWD_DIRECT_AREA; }},
      {"roulette-albedo", "adaptive, paths live by albedo",
       [](Settings& with) { with.render.roulette = AWD_ROULETTE_ALBEDO; }},
      {"roulette-throughput", "adaptive, paths live by throughput times albedo",
       [](Settings& with) { with.render.roulette = AWD_ROULETTE_THROUGHPUT; }},
      {"no-splitting", "adaptive, roulette alone",
       [](Settings& with) { with.render.maxSplit = 1; }},
      {"lights-by-power", "adaptive, shadow rays go to lights by their power",
       [](Settings& with) { with.render.lights = AWD_LIGHTS_POWER; }},
      {"direct-none", "adaptive, light found by indirect rays alone",
       [](Settings& with) { with.render.direct = AWD_DIRECT_NONE; }},
      {"random-points", "adaptive, paths from independent numbers",
       [](Settings& with) { with.render.points = AWD_POINTS_RANDOM; }},
      {"cosine-random-points", "cosine, paths from independent numbers",
       [](Settings& with) {
         with.render.guide = AWD_GUIDE_COSINE;
         with.render.points = AWD_POINTS_RANDOM;
       }},
      {"two-passes", "adaptive, two passes of equal length",
       [](Settings& with) { with.equalPasses = 2; }},
      {"eight-passes", "adaptive, eight passes of equal length",
       [](Settings& with) { with.equalPasses = 8; }},
      {"by-count", "adaptive, every sample counts the same in the image",
       [](Settings& with) { with.render.combination = AWD_COMBINE_COUNT; }},
  };
  return all;
}

const Method& methodNamed(const std::string& name) { return named(methods(), name); }

}  // namespace bench::guide

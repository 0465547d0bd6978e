// SPDX-License-Identifier: Apache-2.0
#include "guide_methods.h"

#include <stdexcept>

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

      {"cosine-one-shadow-ray", "cosine, one shadow ray a light and vertex",
       [](Settings& with) {
         with.render.guide = AWD_GUIDE_COSINE;
         with.render.shadowRays = 1;
       }},
      {"one-shadow-ray", "adaptive, one shadow ray a light and vertex",
       [](Settings& with) { with.render.shadowRays = 1; }},

      {"linear-bspline", "adaptive with this basis",
       [](Settings& with) { with.field.basis = "linear-bspline"; }},
      {"quadratic-bspline", "adaptive with this basis",
       [](Settings& with) { with.field.basis = "quadratic-bspline"; }},
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
      {"linear-bspline-quasi", "adaptive with this basis and estimator",
       [](Settings& with) {
         with.field.basis = "linear-bspline";
         with.field.estimator = AWD_ESTIMATOR_QUASI;
       }},

      {"spherical", "adaptive with this map of the hemisphere",
       [](Settings& with) { with.field.map = AWD_MAP_SPHERICAL; }},
      {"concentric-cosine", "adaptive with this map of the hemisphere",
       [](Settings& with) { with.field.map = AWD_MAP_CONCENTRIC_COSINE; }},
      {"level-2", "adaptive, no density finer than 4 x 4 cells",
       [](Settings& with) { with.field.maxLevel = AWD_LEVEL(2); }},
      {"level-4", "adaptive, no density finer than 16 x 16 cells",
       [](Settings& with) { with.field.maxLevel = AWD_LEVEL(4); }},
      {"tau-0.05", "adaptive, coefficients clamped at 0.05 of the mean density",
       [](Settings& with) { with.field.tau = 0.05; }},

      {"direct-area", "adaptive, light found by shadow rays alone",
       [](Settings& with) { with.render.direct = AWD_DIRECT_AREA; }},
      {"roulette-throughput", "adaptive, paths live by throughput times albedo",
       [](Settings& with) { with.render.roulette = AWD_ROULETTE_THROUGHPUT; }},
  };
  return all;
}

const Method& methodNamed(const std::string& name) {
  std::string message = "no method " + name + "; there are";
  for (const Method& method : methods()) {
    if (method.name == name) return method;
    message.append(" ").append(method.name);
  }
  throw std::runtime_error(message);
}

}  // namespace bench::guide

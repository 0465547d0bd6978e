// SPDX-License-Identifier: Apache-2.0
// One density learns from one set of samples: what came out, and what it cost.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "awd/density.h"
#include "refit_functions.h"
#include "support/handles.h"

namespace bench::refit {

using Density = awdtest::Handle<AWDDensity, awdReleaseDensity>;

/// Where a density's coefficients live.
struct Space {
  const char* basis;
  AWDDensityStructure structure;
  int dimensions;
  uint32_t level;
};

/// An estimator, and with refit its solver.
struct Method {
  const char* name;
  AWDEstimator estimator;
  const char* solver;
};

/// The projections, and refit by descent and by Ceres as far as there are such solvers; of others a
/// line on standard error says why not.
std::vector<Method> availableMethods(AWDDevice device);

struct Task {
  Space space;
  const Function* function = nullptr;
  Noise noise = Noise::kNone;
  uint64_t samples = 0;  ///< of each pass
  int passes = 1;        ///< of one the level is fixed; of more, space bounds the coefficients
  double shrinkage = 0.0;
};

/// Coefficients of the whole space.
uint64_t coefficientsOf(AWDDevice device, const Space& space);

/// Points, uniform in the cube, and noisy values of f there.
struct Samples {
  Samples(const Task& task, uint64_t seed);

  std::vector<double> points, pdfs, values;
};

struct Learned {
  Truth::Distance distance;
  double recordSeconds = 0.0, adaptSeconds = 0.0;     ///< CPU time of all passes
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;  ///< of the last adapt, without its message
  std::vector<double> coefficients;
};

/// `uniform`: samples of the first pass, which all but the paper's estimator take; that one draws
/// its own, of the same seed, from its components.
Learned learn(AWDDevice device, const Task& task, const Method& method, const Samples& uniform,
              const Truth& truth, uint64_t seed);

}  // namespace bench::refit

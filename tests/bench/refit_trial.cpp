// SPDX-License-Identifier: Apache-2.0
#include "refit_trial.h"

#include <cstdio>
#include <ctime>

namespace bench::refit {
namespace {

using awdtest::must;

constexpr Method kMethods[] = {{"paper", AWD_ESTIMATOR_PAPER, nullptr},
                               {"mixture", AWD_ESTIMATOR_MIXTURE, nullptr},
                               {"ratio", AWD_ESTIMATOR_RATIO, nullptr},
                               {"quasi", AWD_ESTIMATOR_QUASI, nullptr},
                               {"refit-descent", AWD_ESTIMATOR_REFIT, "descent"},
                               {"refit-ceres", AWD_ESTIMATOR_REFIT, "ceres"}};

/// CPU time of this thread: another's work is no cost of ours.
double cpuSeconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Runs `work` and tells what it took.
template <class Work>
double timed(Work&& work) {
  const double begin = cpuSeconds();
  must(work());
  return cpuSeconds() - begin;
}

AWDResult make(AWDDevice device, const Task& task, const Method& method, Density& density) {
  const bool fixed = task.passes == 1;
  const bool tree = task.space.structure == AWD_STRUCTURE_TREE;
  const uint32_t level = AWD_LEVEL(task.space.level);
  // A tree that may choose its boxes is bounded by their number instead.
  const AWDDensityAxis axis = {task.space.basis, fixed ? level : 0u, fixed || !tree ? level : 0u};
  const std::vector<AWDDensityAxis> axes(static_cast<std::size_t>(task.space.dimensions), axis);
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = static_cast<uint32_t>(task.space.dimensions);
  desc.structure = task.space.structure;
  desc.axes = axes.data();
  desc.estimator = method.estimator;
  desc.refitSolver = method.solver;
  desc.shrinkage = task.shrinkage;
  desc.passSamples = task.samples;
  if (!fixed && tree) desc.maxCoefficients = coefficientsOf(device, task.space);
  return awdNewDensity(device, &desc, density.out());
}

AWDDensityInfo infoOf(AWDDensity density) {
  AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
  must(awdGetDensityInfo(density, &info));
  return info;
}

/// A pass of a density's own samples.
void drawPass(const Task& task, AWDDensity density, awdtest::Random& random, Samples& samples,
              std::vector<uint32_t>& components) {
  const std::size_t d = static_cast<std::size_t>(task.space.dimensions);
  std::vector<double> uniforms(task.samples * infoOf(density).uniforms);
  for (double& u : uniforms) u = random.uniform();
  components.resize(task.samples);
  must(awdSampleDensity(density, task.samples, uniforms.data(), samples.points.data(),
                        samples.pdfs.data(), components.data()));
  for (std::size_t i = 0; i < task.samples; ++i) {
    samples.values[i] = task.function->value(&samples.points[i * d], task.space.dimensions) *
                        draw(task.noise, random);
  }
}

}  // namespace

std::vector<Method> availableMethods(AWDDevice device) {
  std::vector<Method> methods;
  for (const Method& method : kMethods) {
    Task task;
    task.space = {"linear-bspline", AWD_STRUCTURE_GRID, 1, 2};
    Density density;
    const AWDResult result = make(device, task, method, density);
    if (result == AWD_ERROR_UNSUPPORTED) {
      std::fprintf(stderr, "%s is left out: %s\n", method.name, awdGetLastErrorMessage());
      continue;
    }
    must(result);
    methods.push_back(method);
  }
  return methods;
}

uint64_t coefficientsOf(AWDDevice device, const Space& space) {
  Task task;
  task.space = space;
  Density density;
  must(make(device, task, kMethods[3], density));
  return infoOf(density).coefficients;
}

Samples::Samples(const Task& task, uint64_t seed) : pdfs(task.samples, 1.0) {
  awdtest::Random random(seed);
  const std::size_t d = static_cast<std::size_t>(task.space.dimensions);
  points.reserve(task.samples * d);
  for (std::size_t i = 0; i < task.samples * d; ++i) points.push_back(random.uniform());
  values.reserve(task.samples);
  for (std::size_t i = 0; i < task.samples; ++i) {
    values.push_back(task.function->value(&points[i * d], task.space.dimensions) *
                     draw(task.noise, random));
  }
}

Learned learn(AWDDevice device, const Task& task, const Method& method, const Samples& uniform,
              const Truth& truth, uint64_t seed) {
  Density density;
  must(make(device, task, method, density));
  const bool paper = method.estimator == AWD_ESTIMATOR_PAPER;
  awdtest::Random random(seed ^ 0x5bd1e995u);
  Samples own = uniform;
  std::vector<uint32_t> components;
  Learned learned;
  for (int pass = 0; pass < task.passes; ++pass) {
    if (paper || pass > 0) drawPass(task, density, random, own, components);
    learned.recordSeconds += timed([&] {
      return awdRecordDensity(density, task.samples, own.points.data(), own.pdfs.data(),
                              paper ? components.data() : nullptr, own.values.data());
    });
    learned.adaptSeconds += timed([&] { return awdAdaptDensity(density, &learned.report); });
  }
  learned.report.refitMessage = nullptr;  // dies with the density
  std::vector<double> pdfs(truth.count());
  must(awdGetDensityPdf(density, pdfs.size(), truth.points().data(), pdfs.data()));
  learned.distance = truth.distance(pdfs);
  learned.coefficients.resize(learned.report.coefficients);
  must(awdGetDensityCoefficients(density, AWD_COEFFICIENTS_SCALING, learned.coefficients.data(),
                                 learned.coefficients.size()));
  return learned;
}

}  // namespace bench::refit

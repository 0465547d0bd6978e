// SPDX-License-Identifier: Apache-2.0
// awd-bench wavelets: coefficients that a tree saves when details below their standard error are
// dropped, and what that does to the variance of f/p.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

#include "commands.h"
#include "support/handles.h"

namespace bench {
namespace {

using awdtest::must;

constexpr uint32_t kDimensions = 2;
constexpr uint32_t kLevel = 5;
constexpr uint32_t kGrid = 512;  // points of the quadrature along an axis

struct Function {
  const char* name;
  double (*value)(double x, double y);
};

const Function kFunctions[] = {
    {"constant", [](double, double) { return 1.0; }},
    {"ramp", [](double x, double y) { return 0.2 + x + 0.5 * y; }},
    {"bump", [](double x, double y) { return std::exp(-30.0 * (x * x + (y - 0.4) * (y - 0.4))); }},
    {"disc", [](double x, double y) { return std::hypot(x - 0.4, y - 0.5) < 0.3 ? 1.0 : 0.01; }},
    {"ridge", [](double x, double y) { return std::exp(-200.0 * (x - y) * (x - y)); }},
};

using Density = awdtest::Handle<AWDDensity, awdReleaseDensity>;

/// V / I^2 with V the variance of f/p, by the midpoint rule.
double relativeVariance(AWDDensity density, const Function& f) {
  std::vector<double> points, pdfs(kGrid * kGrid);
  for (uint32_t i = 0; i < kGrid; ++i) {
    for (uint32_t k = 0; k < kGrid; ++k) {
      points.insert(points.end(), {(i + 0.5) / kGrid, (k + 0.5) / kGrid});
    }
  }
  must(awdGetDensityPdf(density, pdfs.size(), points.data(), pdfs.data()));
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < pdfs.size(); ++i) {
    const double value = f.value(points[2 * i], points[2 * i + 1]);
    sum += value / (kGrid * kGrid);
    squares += value * value / pdfs[i] / (kGrid * kGrid);
  }
  return squares / (sum * sum) - 1.0;
}

/// A tree of 2^level x 2^level boxes that has learnt from so many uniform samples. fixed: none are
/// merged.
Density learn(AWDDevice device, const char* basis, const Function& f, std::size_t samples,
              bool fixed, AWDDensityReport& report) {
  // The boxes that there are are all that is allowed.
  const AWDDensityAxis axis = {basis, AWD_LEVEL(kLevel), AWD_LEVEL(fixed ? kLevel : kLevel + 1)};
  const AWDDensityAxis axes[kDimensions] = {axis, axis};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = kDimensions;
  desc.structure = AWD_STRUCTURE_TREE;
  desc.axes = axes;
  Density density;
  must(awdNewDensity(device, &desc, density.out()));
  std::mt19937_64 random(1);
  std::vector<double> uniforms(samples * kDimensions), points(uniforms.size()), values(samples);
  for (double& u : uniforms) u = std::generate_canonical<double, 53>(random);
  must(awdSampleDensity(density, samples, uniforms.data(), points.data(), nullptr, nullptr));
  for (std::size_t i = 0; i < samples; ++i) values[i] = f.value(points[2 * i], points[2 * i + 1]);
  must(awdRecordDensity(density, samples, points.data(), nullptr, nullptr, values.data()));
  must(awdAdaptDensity(density, &report));
  return density;
}

int run(std::size_t samples) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  awdtest::Handle<AWDDevice, awdReleaseDevice> device;
  must(awdNewDevice(&desc, device.out()));
  std::printf("%zu samples on %u x %u boxes; variance relative to the squared integral\n", samples,
              1u << kLevel, 1u << kLevel);
  std::printf("%-6s %-10s %8s %8s %8s %10s %10s\n", "basis", "function", "all", "dropped", "split",
              "variance", "after");
  for (const char* basis : {"haar", "f2", "m2", "m3"}) {
    for (const Function& f : kFunctions) {
      AWDDensityReport all = AWD_DENSITY_REPORT_INIT, kept = AWD_DENSITY_REPORT_INIT;
      const Density full = learn(device, basis, f, samples, true, all);
      const Density coarse = learn(device, basis, f, samples, false, kept);
      std::printf("%-6s %-10s %8llu %8llu %8llu %10.5f %10.5f\n", basis, f.name,
                  static_cast<unsigned long long>(all.coefficients),
                  static_cast<unsigned long long>(kept.coarsened),
                  static_cast<unsigned long long>(kept.split), relativeVariance(full, f),
                  relativeVariance(coarse, f));
    }
  }
  return 0;
}

}  // namespace

void addWaveletsCommand(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "wavelets", "Coefficients saved by dropping details below their standard error");
  const auto samples = std::make_shared<std::size_t>(20000);
  command->add_option("--samples", *samples, "Of the pass; default 20000")
      ->check(CLI::Range(1000, 100000000));
  command->callback([samples, &action] { action = [samples] { return run(*samples); }; });
}

}  // namespace bench

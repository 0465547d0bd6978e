// SPDX-License-Identifier: Apache-2.0
// Densities through the C interface, and short ways to ask and to feed them.
#pragma once

#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "support/handles.h"
#include "support/random.h"

namespace awdtest {

using Density = Handle<AWDDensity, awdReleaseDensity>;

constexpr const char* kFamilies[] = {"haar",
                                     "f2",
                                     "m2",
                                     "m3",
                                     "linear-bspline",
                                     "linear-bspline-periodic",
                                     "quadratic-bspline",
                                     "quadratic-bspline-periodic"};
constexpr const char* kNested[] = {"haar", "f2", "m2", "m3"};

inline bool isPiecewiseConstant(const std::string& basis) {
  return basis == "haar" || basis == "f2";
}

/// Starts at the first level and may go up to the last.
inline AWDDensityAxis axisFrom(const char* basis, uint32_t start, uint32_t most) {
  return {basis, AWD_LEVEL(start), AWD_LEVEL(most)};
}
inline AWDDensityAxis fixedAxis(const char* basis, uint32_t level) {
  return axisFrom(basis, level, level);
}
using Axes = std::vector<AWDDensityAxis>;

inline AWDDensityDesc gridDesc() {
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.structure = AWD_STRUCTURE_GRID;
  return desc;
}
inline AWDDensityDesc treeDesc() {
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.structure = AWD_STRUCTURE_TREE;
  return desc;
}

inline Density newDensity(AWDDevice device, const Axes& axes, AWDDensityDesc desc = gridDesc()) {
  desc.axes = axes.data();
  desc.dimensions = static_cast<uint32_t>(axes.size());
  Density density;
  must(awdNewDensity(device, &desc, density.out()));
  return density;
}

inline AWDDensityInfo infoOf(AWDDensity density) {
  AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
  must(awdGetDensityInfo(density, &info));
  return info;
}

inline AWDDensityAxisInfo axisInfoOf(AWDDensity density, uint32_t axis) {
  AWDDensityAxisInfo info = AWD_DENSITY_AXIS_INFO_INIT;
  must(awdGetDensityAxisInfo(density, axis, &info));
  return info;
}

inline std::vector<double> coefficientsOf(AWDDensity density,
                                          AWDCoefficientForm form = AWD_COEFFICIENTS_SCALING) {
  std::vector<double> c(infoOf(density).coefficients);
  must(awdGetDensityCoefficients(density, form, c.data(), c.size()));
  return c;
}

inline void setCoefficients(AWDDensity density, const std::vector<double>& c) {
  must(awdSetDensityCoefficients(density, c.data(), c.size()));
}

/// Coefficients over three decades, every sixth 0 if zeros are wanted.
inline void setRandomCoefficients(AWDDensity density, Random& random, bool zeros = false) {
  std::vector<double> c(infoOf(density).coefficients);
  for (double& value : c) value = std::pow(10.0, 3.0 * random.uniform());
  for (size_t i = 1; zeros && i < c.size(); i += 6) c[i] = 0.0;
  setCoefficients(density, c);
}

inline double integralOver(AWDDensity density, const std::vector<double>& lower,
                           const std::vector<double>& upper) {
  double mass;
  must(awdGetDensityIntegral(density, lower.data(), upper.data(), &mass));
  return mass;
}
inline double integralOf(AWDDensity density) {
  double mass;
  must(awdGetDensityIntegral(density, nullptr, nullptr, &mass));
  return mass;
}

/// Leaf i: lower ends, then upper ends.
inline std::vector<double> leavesOf(AWDDensity density) {
  size_t count;
  must(awdGetDensityLeaves(density, nullptr, 0, &count));
  std::vector<double> boxes(size_t{2} * infoOf(density).dimensions * count);
  must(awdGetDensityLeaves(density, boxes.data(), count, &count));
  return boxes;
}

inline std::vector<double> pdfsAt(AWDDensity density, const std::vector<double>& points) {
  std::vector<double> pdfs(points.size() / infoOf(density).dimensions);
  must(awdGetDensityPdf(density, pdfs.size(), points.data(), pdfs.data()));
  return pdfs;
}

inline std::vector<double> randomNumbers(size_t count, Random& random) {
  std::vector<double> numbers(count);
  for (double& u : numbers) u = random.uniform();
  return numbers;
}

using Function = std::function<double(const double*)>;

/// Points with the density they were drawn from and the values of a function there.
struct Samples {
  uint32_t dimensions = 0;
  std::vector<double> points, pdfs, values;
  std::vector<uint32_t> components;

  size_t size() const { return pdfs.size(); }
  const double* point(size_t i) const { return &points[i * dimensions]; }
  void evaluate(const Function& f) {
    values.resize(size());
    for (size_t i = 0; i < size(); ++i) values[i] = f(point(i));
  }
};

inline Samples drawWith(AWDDensity density, const std::vector<double>& uniforms) {
  const AWDDensityInfo info = infoOf(density);
  Samples samples;
  samples.dimensions = info.dimensions;
  const size_t count = uniforms.size() / info.uniforms;
  samples.points.resize(count * info.dimensions);
  samples.pdfs.resize(count);
  samples.components.resize(count);
  must(awdSampleDensity(density, count, uniforms.data(), samples.points.data(), samples.pdfs.data(),
                        samples.components.data()));
  return samples;
}

inline Samples draw(AWDDensity density, size_t count, Random& random) {
  return drawWith(density, randomNumbers(count * infoOf(density).uniforms, random));
}

inline Samples draw(AWDDensity density, size_t count, Random& random, const Function& f) {
  Samples samples = draw(density, count, random);
  samples.evaluate(f);
  return samples;
}

/// Samples [first, last).
inline void record(AWDDensity density, const Samples& samples, size_t first, size_t last) {
  must(awdRecordDensity(density, last - first, samples.point(first), &samples.pdfs[first],
                        &samples.components[first], &samples.values[first]));
}
inline void record(AWDDensity density, const Samples& samples) {
  if (samples.size() > 0) record(density, samples, 0, samples.size());
}

inline AWDDensityReport adapt(AWDDensity density) {
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
  must(awdAdaptDensity(density, &report));
  return report;
}

/// A whole pass.
inline AWDDensityReport pass(AWDDensity density, size_t count, Random& random, const Function& f) {
  record(density, draw(density, count, random, f));
  return adapt(density);
}

inline AWDDensityEstimate estimateOf(AWDDensity density) {
  AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
  must(awdGetDensityEstimate(density, &estimate));
  return estimate;
}

inline Density forkOf(AWDDensity density) {
  Density fork;
  must(awdForkDensity(density, fork.out()));
  return fork;
}

using Bytes = std::vector<char>;

inline Bytes statisticsOf(AWDDensity density) {
  size_t size;
  must(awdExportDensityStatistics(density, nullptr, 0, &size));
  Bytes bytes(size);
  must(awdExportDensityStatistics(density, bytes.data(), bytes.size(), &size));
  return bytes;
}

inline Bytes saved(AWDDensity density) {
  size_t size;
  must(awdSaveDensity(density, nullptr, 0, &size));
  Bytes bytes(size);
  must(awdSaveDensity(density, bytes.data(), bytes.size(), &size));
  return bytes;
}

inline Density loaded(AWDDevice device, const Bytes& bytes) {
  Density density;
  must(awdLoadDensity(device, bytes.data(), bytes.size(), density.out()));
  return density;
}

/// Whether two arrays have the same bits.
template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Spots of integral about 1, for functions to learn: at 0.6 on every axis.
inline double bump(const double* x, uint32_t dimensions, double width) {
  double exponent = 0.0;
  for (uint32_t a = 0; a < dimensions; ++a) {
    const double t = (x[a] - 0.6) / width;
    exponent -= 0.5 * t * t;
  }
  return std::exp(exponent) * std::pow(2.5066282746310002 * width, -double(dimensions));
}

}  // namespace awdtest

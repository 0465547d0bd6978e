// SPDX-License-Identifier: Apache-2.0
// Densities, and statistics of densities, from bytes that anyone may have made. First byte: bit 0,
// the frame is repaired; bit 1, they are statistics; the rest, of which density.
#include <cmath>
#include <cstring>

#include "bounded_device.h"
#include "density/densities.h"
#include "frame.h"
#include "require.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Axes;
using awdtest::axisFrom;
using awdtest::Density;
using awdtest::fixedAxis;
using awdtest::Random;

constexpr uint8_t kRepaired = 1, kStatistics = 2;

struct Kind {
  Axes axes;
  AWDDensityDesc desc;
};

const std::vector<Kind>& kinds() {
  const auto with = [](AWDDensityDesc desc, AWDEstimator estimator, AWDCombination combination) {
    desc.estimator = estimator;
    desc.combination = combination;
    desc.maxCoefficients = 60;
    desc.passSamples = 40;
    return desc;
  };
  const AWDDensityDesc grid = with(awdtest::gridDesc(), 0, 0),
                       tree = with(awdtest::treeDesc(), 0, 0);
  static const std::vector<Kind> all = {
      {{{"haar", 0, 0}, {"haar", 0, 0}}, grid},
      {{axisFrom("quadratic-bspline-periodic", 0, 2), fixedAxis("m3", 0), {"f2", 0, 0}}, grid},
      {{axisFrom("linear-bspline", 1, 3), axisFrom("quadratic-bspline", 0, 2)},
       with(awdtest::gridDesc(), AWD_ESTIMATOR_PAPER, 0)},
      {{{"linear-bspline-periodic", 0, 0}},
       with(awdtest::gridDesc(), 0, AWD_COMBINE_CROSS_VARIANCE)},
      {{{"haar", 0, 0}, {"f2", 0, 0}}, tree},
      {{{"m3", 0, 0}}, with(awdtest::treeDesc(), AWD_ESTIMATOR_RATIO, AWD_COMBINE_CROSS_VARIANCE)}};
  return all;
}

double bumpAt(const double* x, uint32_t dimensions) {
  double square = 0.0;
  for (uint32_t a = 0; a < dimensions; ++a) square += (x[a] - 0.7) * (x[a] - 0.7);
  return 0.1 + std::exp(-20.0 * square);
}

Input bytesOf(AWDDensity density, decltype(&awdSaveDensity) call) {
  size_t size = 0;
  require(call(density, nullptr, 0, &size) == AWD_SUCCESS, "can't be saved");
  Input bytes(size);
  require(call(density, bytes.data(), size, &size) == AWD_SUCCESS, "can't be saved");
  return bytes;
}

/// A pass is recorded as hosts do it, and what is promised of it looked at.
void recordPass(AWDDensity density, std::size_t count, Random& random) {
  const AWDDensityInfo info = awdtest::infoOf(density);
  const bool component = info.sampler == AWD_SAMPLER_COMPONENT;
  const double edges[] = {0.0, 0.5, 1.0 - 0x1p-53};
  std::vector<double> uniforms(count * info.uniforms), points(count * info.dimensions);
  std::vector<double> pdfs(count), again(count), values(count);
  std::vector<uint32_t> components(count);
  for (double& u : uniforms) u = random.bits() % 8 ? random.uniform() : edges[random.bits() % 3];
  require(awdSampleDensity(density, count, uniforms.data(), points.data(), pdfs.data(),
                           components.data()) == AWD_SUCCESS,
          "no points");
  for (const double x : points) require(x >= 0.0 && x < 1.0, "a point lies outside");
  for (const double pdf : pdfs) require(isDensity(pdf) && pdf > 0.0, "a sample's pdf is none");
  require(awdGetDensityPdf(density, count, points.data(), again.data()) == AWD_SUCCESS, "no pdf");
  require(std::memcmp(pdfs.data(), again.data(), count * sizeof(double)) == 0, "two pdfs");
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = bumpAt(&points[i * info.dimensions], info.dimensions);
  }
  oneOf(awdRecordDensity(density, count, points.data(), pdfs.data(),
                         component ? components.data() : nullptr, values.data()),
        {AWD_ERROR_INVALID_OPERATION}, "record");
}

void look(AWDDensity density) {
  require(std::abs(awdtest::integralOf(density) - 1.0) < 1e-6, "p does not integrate to 1");
  AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
  require(awdGetDensityEstimate(density, &estimate) == AWD_SUCCESS, "no estimate");
  require(!std::isnan(estimate.integral) && !std::isnan(estimate.standardError),
          "an estimate is NaN");
}

void use(const Bounds& bounds, AWDDensity density) {
  Random random(5);
  look(density);
  const auto round = [&] {
    const Input bytes = bytesOf(density, awdSaveDensity);
    Density copy;
    if (oneOf(awdLoadDensity(bounds.device(), bytes.data(), bytes.size(), copy.out()),
              {AWD_ERROR_OUT_OF_MEMORY}, "what was saved")) {
      require(bytesOf(copy, awdSaveDensity) == bytes, "saved again it is another");
    }
  };
  round();
  Density fork;
  require(awdForkDensity(density, fork.out()) == AWD_SUCCESS, "no fork");
  for (int pass = 0; pass < 2; ++pass) {
    recordPass(density, 24, random);
    AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
    if (!oneOf(awdAdaptDensity(density, &report), {AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_CANCELLED},
               "adapt")) {
      return;
    }
    look(density);
  }
  round();
}

Density trained(const Kind& kind, AWDDevice device) {
  Density density = awdtest::newDensity(device, kind.axes, kind.desc);
  Random random(61);
  for (int pass = 0; pass < 2; ++pass) {
    recordPass(density, 60, random);
    awdtest::must(awdAdaptDensity(density, nullptr));
  }
  recordPass(density, 20, random);
  return density;
}

void run(const uint8_t* data, std::size_t size) {
  if (size < 2) return;
  const uint8_t flags = data[0];
  Input bytes(data + 1, data + size);
  const Bounds bounds(std::size_t{48} << 20);
  const bool statistics = flags & kStatistics;
  static const Input framesLike[2] = {
      bytesOf(trained(kinds()[0], bounds.device()), awdSaveDensity),
      bytesOf(trained(kinds()[0], bounds.device()), awdExportDensityStatistics)};
  if (flags & kRepaired) repairFrame(bytes, 0, bytes.size(), framesLike[statistics]);
  if (statistics) {
    const Density density = trained(kinds()[(flags >> 2) % kinds().size()], bounds.device());
    const auto take = flags & 0x80 ? awdAddDensityStatistics : awdImportDensityStatistics;
    if (oneOf(take(density, bytes.data(), bytes.size()),
              {AWD_ERROR_IO, AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_INVALID_OPERATION},
              "statistics")) {
      use(bounds, density);
    }
    return;
  }
  Density density;
  if (oneOf(awdLoadDensity(bounds.device(), bytes.data(), bytes.size(), density.out()),
            {AWD_ERROR_IO, AWD_ERROR_UNSUPPORTED, AWD_ERROR_OUT_OF_MEMORY}, "load")) {
    use(bounds, density);
  }
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  for (std::size_t i = 0; i < kinds().size(); ++i) {
    const Density density = trained(kinds()[i], BoundedDevice::shared().get());
    for (const bool statistics : {false, true}) {
      Input bytes = bytesOf(density, statistics ? awdExportDensityStatistics : awdSaveDensity);
      bytes.insert(bytes.begin(),
                   static_cast<uint8_t>(statistics ? kRepaired | kStatistics | i << 2 : kRepaired));
      result.push_back(std::move(bytes));
    }
  }
  return result;
}

}  // namespace

const Target kSavedDensity = {"saved-density", run, seeds};

}  // namespace fuzz

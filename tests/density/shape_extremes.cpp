// SPDX-License-Identifier: Apache-2.0
// What densities may look like: contrast, uniforms at their ends, levels, sizes, and how often they
// may adapt.
#include <algorithm>

#include "density/extreme_kinds.h"
#include "density/extremes.h"

namespace awdtest {

namespace {

constexpr double kBelowOne = 1.0 - 0x1p-53;

Outcome sixtyDecades() {
  Findings found;
  // Without floor and shrinkage every coefficient is the mean of its own box, to the smallest.
  double worst = 0.0;
  for (const AWDDensityDesc& structure : {gridDesc(), treeDesc()}) {
    AWDDensityDesc desc = structure;
    desc.tau = kNoFloor;
    desc.shrinkage = -1.0;
    desc.estimator = AWD_ESTIMATOR_QUASI;
    const Density density = newDensity(extremeDevice(), {fixedAxis("haar", 6)}, desc);
    std::vector<double> uniforms(16384);
    for (size_t i = 0; i < uniforms.size(); ++i) {
      uniforms[i] = (double(i) + 0.5) / double(uniforms.size());
    }
    Samples samples = drawWith(density, uniforms);
    samples.evaluate([](const double* x) { return std::pow(10.0, 60.0 * x[0] - 30.0); });
    record(density, samples);
    adapt(density);
    const std::vector<double> c = coefficientsOf(density);
    for (size_t i = 0; i + 1 < c.size(); ++i) {
      const double error = c[i] / c[i + 1] / std::pow(10.0, -60.0 / 64.0) - 1.0;
      worst = std::max(worst, std::fabs(error));
    }
    found.expect(worst < 1e-9, "a coefficient is wrong by %g", worst);
    found.expect(c[63] / c[0] > 1e59, "contrast %g", c[63] / c[0]);
    expectSane(found, density, "haar");
  }
  for (const Kind& kind : kinds(1)) {
    const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
    Random random(6);
    for (int k = 0; k < 4; ++k) {
      pass(density, 500, random,
           [](const double* x) { return std::pow(10.0, 60.0 * x[0] - 30.0); });
      expectSane(found, density, kind.name);
    }
    // Given by the host, in the worst order.
    std::vector<double> c(infoOf(density).coefficients);
    for (size_t i = 0; i < c.size(); ++i) {
      c[i] = std::pow(10.0, i % 2 ? 30.0 : 60.0 * random.uniform() - 30.0);
    }
    setCoefficients(density, c);
    expectSane(found, density, kind.name);
  }
  return found.outcome("neighbours' ratios within %.2g", worst);
}

Outcome uniformsAtTheirEnds() {
  Findings found;
  double least = HUGE_VAL;
  for (const double tau : {0.0, kNoFloor}) {
    for (Kind& kind : kinds(3)) {
      kind.desc.tau = tau;
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
      Random random(7);
      pass(density, 1000, random,
           [](const double* x) { return x[0] > 0.3 && x[1] < 0.6 && x[2] > 0.5 ? 1.0 : 0.0; });
      const double ends[] = {0.0, kBelowOne};
      std::vector<double> uniforms;
      for (size_t i = 0; i < 24; ++i) uniforms.push_back(ends[i / 3 >> i % 3 & 1]);
      const Samples samples = drawWith(density, uniforms);
      for (const double x : samples.points) {
        found.expect(x >= 0.0 && x < 1.0, "%s: x = %.17g", kind.name.c_str(), x);
      }
      for (const double p : samples.pdfs) {
        found.expect(p > 0.0 && std::isfinite(p), "%s: p = %g", kind.name.c_str(), p);
        least = std::min(least, p);
      }
    }
  }
  return found.outcome("x in [0,1), p from %.2g up", least);
}

/// Beside a coefficient of 1 one that is next to nothing, where the uniform 0 leads.
Outcome nextToNothing() {
  Findings found;
  double least = HUGE_VAL;
  for (const uint32_t dimensions : {1u, 2u, 3u}) {
    for (const Kind& kind : kinds(dimensions, fixedAxis(nullptr, 2), 65536)) {
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
      for (const double small : {1e-90, 1e-120, 1e-200, 1e-290, 1e-300, 1e-308, 1e-320}) {
        std::vector<double> c(infoOf(density).coefficients, 0.0);
        c[c.size() / 2] = small;
        c.front() = small;
        c.back() = 1.0;
        setCoefficients(density, c);
        expectSane(found, density, kind.name);
        std::vector<double> uniforms;
        for (size_t i = 0; i < 3 * infoOf(density).uniforms; ++i) {
          uniforms.push_back(i % 7 == 3 ? 0.5 : 0.0);
        }
        const Samples samples = drawWith(density, uniforms);
        for (const double x : samples.points) {
          found.expect(x >= 0.0 && x < 1.0, "%s: x = %.17g", kind.name.c_str(), x);
        }
        for (const double p : samples.pdfs) {
          found.expect(p > 0.0 && std::isfinite(p), "%s beside %g: p = %g", kind.name.c_str(),
                       small, p);
          least = std::min(least, p);
        }
      }
    }
  }
  return found.outcome("x in [0,1), p from %.2g up", least);
}

Outcome levelZero() {
  Findings found;
  for (const Kind& kind : kinds(2, fixedAxis(nullptr, 0))) {
    const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
    Random random(8);
    for (int k = 0; k < 3; ++k) pass(density, 500, random, bumpOf(kind));
    expectSane(found, density, kind.name);
    found.expect(axisInfoOf(density, 0).level == 0, "%s: level %u", kind.name.c_str(),
                 axisInfoOf(density, 0).level);
    if (axisInfoOf(density, 0).count == 1) {
      const double c = coefficientsOf(density)[0];
      found.expect(c == 1.0, "%s: the constant is %.17g", kind.name.c_str(), c);
    }
  }
  return found.outcome("densities; constants are 1 exactly");
}

Outcome levelTwelve() {
  Findings found;
  double worst = 0.0;
  for (const Kind& kind : kinds(1, fixedAxis(nullptr, 12), 65536)) {
    const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
    Random random(9);
    pass(density, 20000, random, bumpOf(kind));
    expectSane(found, density, kind.name);
    found.expect(axisInfoOf(density, 0).level == 12, "%s: level %u", kind.name.c_str(),
                 axisInfoOf(density, 0).level);
    double sum = 0.0;
    for (int i = 0; i < 16; ++i) sum += integralOver(density, {i / 16.0}, {(i + 1) / 16.0});
    worst = std::max(worst, std::fabs(sum - 1.0));
    const double near = integralOver(density, {0.45}, {0.75});
    found.expect(near > 0.5, "%s: %g of the mass near the bump", kind.name.c_str(), near);
  }
  found.expect(worst < 1e-12, "masses miss 1 by %g", worst);
  return found.outcome("masses sum to 1 within %.2g", worst);
}

Outcome thousandCycles() {
  Findings found;
  double worst = 0.0;
  for (const Kind& kind : kinds(1, {}, 64)) {
    const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
    Random random(10);
    const Function f = bumpOf(kind);
    const uint32_t width = infoOf(density).uniforms;
    Samples samples;
    samples.dimensions = 1;
    samples.points.resize(32);
    samples.pdfs.resize(32);
    samples.components.resize(32);
    for (int cycle = 0; cycle < 1000; ++cycle) {
      must(awdSampleDensity(density, 32, randomNumbers(size_t{32} * width, random).data(),
                            samples.points.data(), samples.pdfs.data(), samples.components.data()));
      samples.evaluate(f);
      record(density, samples);
      must(awdAdaptDensity(density, nullptr));
      worst = std::max(worst, std::fabs(integralOf(density) - 1.0));
    }
    expectSane(found, density, kind.name);
  }
  found.expect(worst <= 1e-12, "the integral misses 1 by %g", worst);
  return found.outcome("integral within %.2g of 1", worst);
}

/// 1/(distance + width): half of its integral lies within the square root of the width.
Outcome spike() {
  constexpr double kWidth = 1e-6, kPlace = 0.3;
  const Function f = [](const double* x) { return 1.0 / (std::fabs(x[0] - kPlace) + kWidth); };
  const double exact = std::log1p(kPlace / kWidth) + std::log1p((1.0 - kPlace) / kWidth);
  Findings found;
  double widest = 0.0;
  for (const Kind& kind : kinds(1, {}, 1024)) {
    const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
    Random random(11);
    for (int k = 0; k < 10; ++k) pass(density, 2000, random, f);
    expectSane(found, density, kind.name);
    if (kind.desc.structure == AWD_STRUCTURE_GRID) continue;
    double size = 1.0;
    const std::vector<double> leaves = leavesOf(density);
    for (size_t i = 0; i < leaves.size(); i += 2) {
      if (leaves[i] <= kPlace && kPlace < leaves[i + 1]) size = leaves[i + 1] - leaves[i];
    }
    widest = std::max(widest, size);
    found.expect(size < 4.0 * kWidth, "%s: the box at the spike is %g wide", kind.name.c_str(),
                 size);
    // Null hypothesis: the estimate of one more pass is right; 5 standard errors: 6e-7.
    const Samples samples = draw(density, 4000, random, f);
    double mean = 0.0, squares = 0.0;
    for (size_t i = 0; i < 4000; ++i) {
      const double ratio = samples.values[i] / samples.pdfs[i];
      mean += ratio / 4000.0;
      squares += ratio * ratio / 4000.0;
    }
    const double sigma = std::sqrt(std::max(squares - mean * mean, 0.0));
    found.expect(sigma < 0.5 * exact, "%s: sigma %g of mean %g", kind.name.c_str(), sigma, mean);
    found.expect(std::fabs(mean - exact) < 5.0 * sigma / std::sqrt(4000.0), "%s: %g, not %g",
                 kind.name.c_str(), mean, exact);
  }
  return found.outcome("boxes of %.2g at the spike", widest);
}

Outcome millionCells() {
  AWDDensityDesc desc = gridDesc();
  desc.maxCoefficients = 1u << 20;
  constexpr size_t kSide = 1024;
  const Density density = newDensity(extremeDevice(), Axes(2, fixedAxis("haar", 10)), desc);
  // Large ones first, so that sums of floats would stall.
  std::vector<double> c(kSide * kSide);
  Random random(12);
  for (size_t i = 0; i < c.size(); ++i) {
    c[i] = std::pow(10.0, 8.0 * random.uniform() * (1.0 - 0.9 * double(i) / double(c.size())));
  }
  setCoefficients(density, c);
  Findings found;
  long double whole = 0.0L;
  for (const double value : c) whole += value;
  double worst = 0.0;
  std::vector<double> strips(16);
  for (size_t strip = 0; strip < 16; ++strip) {
    long double sum = 0.0L;
    for (size_t i = 0; i < c.size() / 16; ++i) sum += c[strip * (c.size() / 16) + i];
    strips[strip] = static_cast<double>(sum / whole);
    const double seen =
        integralOver(density, {double(strip) / 16.0, 0.0}, {double(strip + 1) / 16.0, 1.0});
    worst = std::max(worst, std::fabs(seen / strips[strip] - 1.0));
  }
  found.expect(worst < 1e-10, "the mass of a strip is wrong by %g", worst);
  // Evenly spaced uniforms: each strip gets its share of points.
  constexpr size_t kPoints = 8192;
  std::vector<double> uniforms;
  for (size_t i = 0; i < kPoints; ++i) {
    uniforms.push_back((double(i) + 0.5) / double(kPoints));
    uniforms.push_back(random.uniform());
  }
  uniforms.insert(uniforms.end(), {kBelowOne, kBelowOne});
  const Samples samples = drawWith(density, uniforms);
  std::vector<double> points(16);
  for (size_t i = 0; i < kPoints; ++i)
    points[static_cast<size_t>(samples.point(i)[0] * 16.0)] += 1.0;
  for (size_t strip = 0; strip < 16; ++strip) {
    found.expect(std::fabs(points[strip] - strips[strip] * kPoints) <= 1.0 + 1e-6,
                 "strip %zu: %g of %g points", strip, points[strip], strips[strip] * kPoints);
  }
  const double* last = samples.point(kPoints);
  found.expect(last[0] >= 1.0 - 1.0 / kSide && last[1] >= 1.0 - 1.0 / kSide,
               "the last uniforms give (%.17g, %.17g)", last[0], last[1]);
  found.expect(sameBits(pdfsAt(density, samples.points), samples.pdfs), "pdfs differ");
  return found.outcome("masses of strips within %.2g", worst);
}

}  // namespace

std::vector<Extreme> shapeExtremes() {
  return {
      {"60 decades in one density", "every coefficient right; a density", sixtyDecades},
      {"u = 0 and u = 1 - 2^-53", "x in [0,1), p > 0", uniformsAtTheirEnds},
      {"coefficients from 1e-90 to 1e-320 beside 1", "x in [0,1), p > 0", nextToNothing},
      {"level 0", "a density", levelZero},
      {"level 12", "a density; masses of cells sum to 1 within 1e-12", levelTwelve},
      {"1000 adapt cycles", "integral within 1e-12 of 1", thousandCycles},
      {"a spike of width 1e-6", "trees resolve it; the estimate is right", spike},
      {"10^6 cells of high contrast", "keep their mass; points by mass", millionCells},
  };
}

}  // namespace awdtest

// SPDX-License-Identifier: Apache-2.0
#include "density/extremes.h"

#include <algorithm>
#include <limits>

#include "density/densities.h"
#include "support/findings.h"

namespace awdtest {

namespace {

constexpr double kBelowOne = 1.0 - 0x1p-53;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoFloor = -1.0;

/// One for all cases: a device tests each family when it is first asked for.
AWDDevice device() {
  static const Device shared = newDevice(1u);
  return shared;
}

struct Kind {
  std::string name;
  Axes axes;
  AWDDensityDesc desc;

  uint32_t dimensions() const { return static_cast<uint32_t>(axes.size()); }
};

/// Every family as a grid, the nested ones as a tree too.
std::vector<Kind> kinds(uint32_t dimensions, AWDDensityAxis like = {}, uint64_t most = 256) {
  std::vector<Kind> all;
  const auto add = [&](const char* basis, AWDDensityDesc desc, const char* structure) {
    like.basis = basis;
    desc.maxCoefficients = most;
    all.push_back({std::string(basis) + structure, Axes(dimensions, like), desc});
  };
  for (const char* basis : kFamilies) add(basis, gridDesc(), " grid");
  for (const char* basis : kNested) add(basis, treeDesc(), " tree");
  return all;
}

/// Is it a density still? Integral, points, and that pdfs are those of the points.
void expectSane(Findings& found, AWDDensity density, const std::string& name) {
  const double mass = integralOf(density);
  found.expect(std::fabs(mass - 1.0) <= 1e-12, "%s: integral 1 %+.3g", name.c_str(), mass - 1.0);
  for (const double c : coefficientsOf(density)) {
    found.expect(c >= 0.0 && std::isfinite(c), "%s: a coefficient is %g", name.c_str(), c);
  }
  Random random(99);
  const Samples samples = draw(density, 200, random);
  for (const double p : samples.pdfs) {
    found.expect(p > 0.0 && std::isfinite(p), "%s: drew p = %g", name.c_str(), p);
  }
  for (const double x : samples.points) {
    found.expect(x >= 0.0 && x < 1.0, "%s: drew x = %.17g", name.c_str(), x);
  }
  found.expect(sameBits(pdfsAt(density, samples.points), samples.pdfs), "%s: pdfs differ",
               name.c_str());
}

Function bumpOf(const Kind& kind, double scale = 1.0) {
  const uint32_t d = kind.dimensions();
  return [d, scale](const double* x) { return scale * (0.1 + bump(x, d, 0.15)); };
}

/// That the samples of `f` leave p as it is, and are counted.
Outcome keepsP(const Function& f, uint64_t samples, uint64_t rejected) {
  Findings found;
  for (const Kind& kind : kinds(2)) {
    const Density density = newDensity(device(), kind.axes, kind.desc);
    Random random(1);
    pass(density, 500, random, bumpOf(kind));
    const std::vector<double> before = coefficientsOf(density);
    const AWDDensityReport report = pass(density, samples, random, f);
    const char* name = kind.name.c_str();
    found.expect(report.kept == 1, "%s: not said to be kept", name);
    found.expect(report.samples == samples && report.rejected == rejected,
                 "%s: %llu samples, %llu rejected", name,
                 static_cast<unsigned long long>(report.samples),
                 static_cast<unsigned long long>(report.rejected));
    found.expect(sameBits(coefficientsOf(density), before), "%s: p has changed", name);
    found.expect(infoOf(density).learned == 500, "%s: learned from nothing", name);
    found.expect(estimateOf(density).samples == 500 + samples, "%s: samples are forgotten", name);
  }
  return found.outcome("p kept, %llu of %llu rejected", static_cast<unsigned long long>(rejected),
                       static_cast<unsigned long long>(samples));
}

Outcome allZero() {
  return keepsP([](const double*) { return 0.0; }, 300, 0);
}
Outcome noSamples() {
  return keepsP([](const double*) { return 1.0; }, 0, 0);
}
Outcome nothingUsable() {
  return keepsP([](const double* x) { return x[0] < 0.5 ? kNaN : HUGE_VAL; }, 300, 300);
}

Outcome oneSample() {
  Findings found;
  for (Kind& kind : kinds(2)) {
    for (const double tau : {0.0, kNoFloor}) {
      kind.desc.tau = tau;
      const Density density = newDensity(device(), kind.axes, kind.desc);
      Random random(2);
      const AWDDensityReport report = pass(density, 1, random, bumpOf(kind));
      found.expect(report.kept == 0, "%s: kept", kind.name.c_str());
      expectSane(found, density, kind.name);
      found.expect(estimateOf(density).standardError == HUGE_VAL, "%s: an error from one sample",
                   kind.name.c_str());
    }
  }
  return found.outcome("a density, its error infinite");
}

/// Rejected samples do what zeros in their place would have done.
Outcome notANumber() {
  Findings found;
  uint64_t rejected = 0;
  for (const Kind& kind : kinds(2)) {
    std::vector<double> outcome[2];
    double integral[2];
    for (const bool zeros : {false, true}) {
      const Density density = newDensity(device(), kind.axes, kind.desc);
      Random random(3);
      Samples samples = draw(density, 1000, random, bumpOf(kind));
      const double nonsense[] = {kNaN, HUGE_VAL, -HUGE_VAL, -kNaN};
      for (size_t i = 0; i < 1000; i += 7) samples.values[i] = zeros ? 0.0 : nonsense[i % 4];
      record(density, samples);
      integral[zeros] = estimateOf(density).integral;
      const AWDDensityReport report = adapt(density);
      found.expect(report.samples == 1000, "%s: samples are missing", kind.name.c_str());
      found.expect(report.rejected == (zeros ? 0u : 143u), "%s: %llu rejected", kind.name.c_str(),
                   static_cast<unsigned long long>(report.rejected));
      if (!zeros) rejected = report.rejected;
      outcome[zeros] = coefficientsOf(density);
    }
    found.expect(sameBits(outcome[0], outcome[1]), "%s: not as zeros", kind.name.c_str());
    found.expect(integral[0] == integral[1], "%s: estimates differ", kind.name.c_str());
  }
  return found.outcome("%llu of 1000 rejected, else as zeros",
                       static_cast<unsigned long long>(rejected));
}

Outcome negative() {
  Findings found;
  for (const Kind& kind : kinds(2)) {
    std::vector<double> outcome[2];
    double integral[2];
    for (const bool minus : {false, true}) {
      const Density density = newDensity(device(), kind.axes, kind.desc);
      Random random(4);
      const AWDDensityReport report = pass(density, 1000, random, bumpOf(kind, minus ? -1.0 : 1.0));
      found.expect(report.rejected == 0, "%s: rejected", kind.name.c_str());
      outcome[minus] = coefficientsOf(density);
      integral[minus] = estimateOf(density).integral;
    }
    found.expect(sameBits(outcome[0], outcome[1]), "%s: not learned as |f|", kind.name.c_str());
    found.expect(integral[0] == -integral[1] && integral[0] > 0.5, "%s: the estimate of -f is %g",
                 kind.name.c_str(), integral[1]);
  }
  return found.outcome("the same p, the opposite estimate");
}

/// The same density as of values near 1: the same bits if the scale is a power of 2^32, in whose
/// digits sums are kept. By other scales values are rounded elsewhere, so that a tree may decide
/// otherwise about a box on the brink: there the distance of the densities counts.
Outcome magnitude(double scale, double tolerance) {
  Findings found;
  double worst = 0.0;
  std::vector<double> points(1000);
  for (size_t i = 0; i < points.size(); ++i) points[i] = (double(i) + 0.5) / 1000.0;
  for (Kind& kind : kinds(1)) {
    for (const AWDTarget target : {AWD_TARGET_MEAN, AWD_TARGET_RMS}) {
      kind.desc.target = target;
      const Density density = newDensity(device(), kind.axes, kind.desc);
      const Density usual = newDensity(device(), kind.axes, kind.desc);
      Random random(5), again(5);
      for (int k = 0; k < 2; ++k) {
        pass(density, 500, random, bumpOf(kind, scale));
        pass(usual, 500, again, bumpOf(kind));
      }
      const std::vector<double> seen = pdfsAt(density, points), expected = pdfsAt(usual, points);
      double largest = 0.0, distance = 0.0;
      for (size_t i = 0; i < points.size(); ++i) {
        distance += std::fabs(seen[i] - expected[i]) / 1000.0;
        largest = std::max(largest, std::fabs(seen[i] / expected[i] - 1.0));
      }
      const bool tree = kind.desc.structure == AWD_STRUCTURE_TREE;
      const bool loose = tree && tolerance > 0.0;
      const double error = loose ? distance : largest;
      found.expect(error <= (loose ? 0.02 : tolerance), "%s, target %d: off by %g",
                   kind.name.c_str(), target, error);
      if (!tree) worst = std::max(worst, error);
      const double integral = estimateOf(density).integral / scale;
      found.expect(std::fabs(integral / estimateOf(usual).integral - 1.0) <=
                       tolerance + (loose ? 0.01 : 0.0),
                   "%s: integral %g", kind.name.c_str(), integral);
      expectSane(found, density, kind.name);
    }
  }
  return found.outcome("p of grids within %.2g of that of f near 1", worst);
}

Outcome tiny() { return magnitude(1e-300, 1e-9); }
Outcome huge() { return magnitude(1e300, 1e-9); }
Outcome scaledByPowers() {
  const Outcome up = magnitude(0x1p992, 0.0);
  return up.ok ? magnitude(0x1p-992, 0.0) : up;
}
Outcome denormal() { return magnitude(0x1p-1055, 1e-3); }

Outcome sixtyDecades() {
  Findings found;
  // Without floor and shrinkage every coefficient is the mean of its own box, to the smallest.
  double worst = 0.0;
  for (const AWDDensityDesc& structure : {gridDesc(), treeDesc()}) {
    AWDDensityDesc desc = structure;
    desc.tau = kNoFloor;
    desc.shrinkage = -1.0;
    desc.estimator = AWD_ESTIMATOR_QUASI;
    const Density density = newDensity(device(), {fixedAxis("haar", 6)}, desc);
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
    const Density density = newDensity(device(), kind.axes, kind.desc);
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
      const Density density = newDensity(device(), kind.axes, kind.desc);
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

Outcome levelZero() {
  Findings found;
  for (const Kind& kind : kinds(2, fixedAxis(nullptr, 0))) {
    const Density density = newDensity(device(), kind.axes, kind.desc);
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
    const Density density = newDensity(device(), kind.axes, kind.desc);
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
    const Density density = newDensity(device(), kind.axes, kind.desc);
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
    const Density density = newDensity(device(), kind.axes, kind.desc);
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
  const Density density = newDensity(device(), Axes(2, fixedAxis("haar", 10)), desc);
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

Outcome smallVariance() {
  Findings found;
  double ratio = 0.0;
  for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE}) {
    AWDDensityDesc desc = gridDesc();
    desc.combination = combination;
    const Density density = newDensity(device(), {fixedAxis("haar", 0)}, desc);
    Random random(13);
    Samples samples = draw(density, 10000, random);
    std::vector<double> deviations;
    for (size_t i = 0; i < samples.size(); ++i) {
      double normal = -6.0;
      for (int k = 0; k < 12; ++k) normal += random.uniform();
      samples.values.push_back(1e8 + normal);
      deviations.push_back(samples.values.back() - 1e8);  // exact
    }
    double mean = 0.0, variance = 0.0;
    for (const double x : deviations) mean += x / 10000.0;
    for (const double x : deviations) variance += (x - mean) * (x - mean) / 9999.0;
    record(density, samples);
    const AWDDensityEstimate estimate = estimateOf(density);
    found.expect(std::fabs(estimate.integral - 1e8 - mean) < 1e-6, "mean 1e8 %+g, not %+g",
                 estimate.integral - 1e8, mean);
    ratio = estimate.standardError * estimate.standardError * 10000.0 / variance;
    found.expect(std::fabs(ratio - 1.0) < 0.01, "variance times %g", ratio);
  }
  return found.outcome("variance times %.6f", ratio);
}

/// Only a floor that was given up lets p be 0 where f seemed to be.
Outcome noFloorUnlessAsked() {
  Findings found;
  double least = HUGE_VAL;
  for (Kind& kind : kinds(1, fixedAxis(nullptr, 5))) {
    for (const double tau : {0.0, kNoFloor}) {
      kind.desc.tau = tau;
      kind.desc.shrinkage = -1.0;
      kind.desc.estimator = AWD_ESTIMATOR_QUASI;
      const Density density = newDensity(device(), kind.axes, kind.desc);
      Random random(14);
      const AWDDensityReport report =
          pass(density, 2000, random, [](const double* x) { return x[0] > 0.5 && x[0] < 0.7; });
      const double p = pdfsAt(density, {0.2})[0];
      if (tau == 0.0) {
        found.expect(report.tau >= 0.01, "%s: tau is %g", kind.name.c_str(), report.tau);
        found.expect(p > 1e-3, "%s: p = %g where no f was seen", kind.name.c_str(), p);
        least = std::min(least, p);
      } else {
        found.expect(p == 0.0, "%s: p = %g without a floor", kind.name.c_str(), p);
        // A sample from there can't be this density's.
        const double x = 0.2, value = 1.0;
        must(awdRecordDensity(density, 1, &x, nullptr, nullptr, &value));
        found.expect(infoOf(density).rejected == 1, "%s: f/0 is not rejected", kind.name.c_str());
        found.expect(std::isfinite(estimateOf(density).integral), "%s: estimate %g",
                     kind.name.c_str(), estimateOf(density).integral);
      }
    }
  }
  return found.outcome("p from %.2g up; 0 when asked for", least);
}

/// Squares of f/p leave the range of a double by far.
Outcome hugeRatios() {
  Findings found;
  for (const Kind& kind : kinds(1)) {
    for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE}) {
      AWDDensityDesc desc = kind.desc;
      desc.combination = combination;
      desc.target = AWD_TARGET_RMS;
      const Density density = newDensity(device(), kind.axes, desc);
      const double x[] = {0.1, 0.3, 0.6, 0.9}, f[] = {1e308, 5e-324, -1e-308, 0.0},
                   p[] = {1e-300, 1e300, 5e-324, 1.0};
      for (int k = 0; k < 3; ++k) {
        must(awdRecordDensity(density, 4, x, p, nullptr, f));
        const AWDDensityReport report = adapt(density);
        found.expect(report.rejected == 0, "%s: rejected", kind.name.c_str());
        expectSane(found, density, kind.name);
        found.expect(!std::isnan(estimateOf(density).integral), "%s: estimate is no number",
                     kind.name.c_str());
      }
    }
  }
  return found.outcome("densities");
}

}  // namespace

const std::vector<Extreme>& densityExtremes() {
  static const std::vector<Extreme> all = {
      {"f all zero", "keeps p and says so; the zeros count", allZero},
      {"no samples", "keeps p and says so", noSamples},
      {"nothing usable: NaN and infinite f only", "keeps p and says so; all rejected, all counted",
       nothingUsable},
      {"one sample", "a density; infinite standard error", oneSample},
      {"NaN and infinite f among others", "rejected, counted, and as zeros", notANumber},
      {"negative f", "learned as |f|, estimated with its sign", negative},
      {"f at 1e-300", "as f near 1", tiny},
      {"f at 1e300", "as f near 1", huge},
      {"f times 2^992 and 2^-992", "the same bits as f near 1", scaledByPowers},
      {"denormal f", "as f near 1, to the digits that f has", denormal},
      {"f/p from 1e-624 to 1e608", "a density", hugeRatios},
      {"60 decades in one density", "every coefficient right; a density", sixtyDecades},
      {"u = 0 and u = 1 - 2^-53", "x in [0,1), p > 0", uniformsAtTheirEnds},
      {"level 0", "a density", levelZero},
      {"level 12", "a density; masses of cells sum to 1 within 1e-12", levelTwelve},
      {"1000 adapt cycles", "integral within 1e-12 of 1", thousandCycles},
      {"a spike of width 1e-6", "trees resolve it; the estimate is right", spike},
      {"10^6 cells of high contrast", "keep their mass; points by mass", millionCells},
      {"f of mean 1e8 and sigma 1", "variance right to 1 %", smallVariance},
      {"f that is 0 where it was looked at", "p > 0 unless tau < 0; f/0 is rejected",
       noFloorUnlessAsked},
  };
  return all;
}

}  // namespace awdtest

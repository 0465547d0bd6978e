// SPDX-License-Identifier: Apache-2.0
// What values samples may have: none, one, no number, the smallest and the largest.
#include <algorithm>
#include <limits>

#include "density/extreme_kinds.h"
#include "density/extremes.h"

namespace awdtest {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// That the samples of `f` leave p as it is, and are counted.
Outcome keepsP(const Function& f, uint64_t samples, uint64_t rejected) {
  Findings found;
  for (const Kind& kind : kinds(2)) {
    const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
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
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
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
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
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
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
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
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
      const Density usual = newDensity(extremeDevice(), kind.axes, kind.desc);
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

/// Squares of f/p leave the range of a double by far.
Outcome hugeRatios() {
  Findings found;
  for (const Kind& kind : kinds(1)) {
    for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE}) {
      AWDDensityDesc desc = kind.desc;
      desc.combination = combination;
      desc.target = AWD_TARGET_RMS;
      const Density density = newDensity(extremeDevice(), kind.axes, desc);
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

Outcome smallVariance() {
  Findings found;
  double ratio = 0.0;
  for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE}) {
    AWDDensityDesc desc = gridDesc();
    desc.combination = combination;
    const Density density = newDensity(extremeDevice(), {fixedAxis("haar", 0)}, desc);
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
      const Density density = newDensity(extremeDevice(), kind.axes, kind.desc);
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

}  // namespace

std::vector<Extreme> sampleExtremes() {
  return {
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
      {"f of mean 1e8 and sigma 1", "variance right to 1 %", smallVariance},
      {"f that is 0 where it was looked at", "p > 0 unless tau < 0; f/0 is rejected",
       noFloorUnlessAsked},
  };
}

}  // namespace awdtest

// SPDX-License-Identifier: Apache-2.0
// The estimator refit through the C interface, with both of its solvers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "density/learning.h"

namespace {

using namespace awdtest;

constexpr const char* kSolvers[] = {"descent", "ceres"};

AWDDensityDesc refitDesc(AWDDensityDesc desc, const char* solver = nullptr) {
  desc.estimator = AWD_ESTIMATOR_REFIT;
  desc.refitSolver = solver;
  return desc;
}

struct Shape {
  const char* name;
  AWDDensityDesc desc;
  Axes axes;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  for (const char* basis : kFamilies) {
    all.push_back({basis, gridDesc(), {fixedAxis(basis, 3)}});
    all.push_back({basis, gridDesc(), {fixedAxis(basis, 2), fixedAxis("linear-bspline", 1)}});
  }
  for (const char* basis : kNested) {
    all.push_back({basis, treeDesc(), {fixedAxis(basis, 2)}});
    all.push_back({basis, treeDesc(), {fixedAxis(basis, 1), fixedAxis("m2", 2)}});
  }
  all.push_back({"3D",
                 gridDesc(),
                 {fixedAxis("quadratic-bspline", 1), fixedAxis("haar", 1), fixedAxis("m2", 1)}});
  return all;
}

class Refit : public Learning {
 protected:
  /// A density learned by a solver from samples that are the same for both.
  Density learned(const Shape& shape, const char* solver, size_t perCoefficient, const Function& f,
                  AWDDensityReport& report) {
    Density density = newDensity(device_, shape.axes, refitDesc(shape.desc, solver));
    Random random(17);
    report = pass(density, perCoefficient * infoOf(density).coefficients, random, f);
    return density;
  }
};

double largestOf(const std::vector<double>& c) { return *std::max_element(c.begin(), c.end()); }

/// A residual of 0 can be had, so that the solution is what was sampled, from few samples.
TEST_F(Refit, FindsWhatTheBasisHolds) {
  for (Shape shape : shapes()) {
    shape.desc.tau = kNone;
    shape.desc.shrinkage = kNone;
    Random random(3);
    const Density truth = newDensity(device_, shape.axes, shape.desc);
    std::vector<double> c(infoOf(truth).coefficients);
    for (double& value : c) value = 0.2 + random.uniform();
    setCoefficients(truth, c);
    const std::vector<double> expected = coefficientsOf(truth);
    const Function f = [&](const double* x) {
      double p;
      must(awdGetDensityPdf(truth, 1, x, &p));
      return 7.0 * p;
    };
    for (const char* solver : kSolvers) {
      SCOPED_TRACE(std::string(shape.name) + " " + solver);
      AWDDensityReport report;
      const Density density = learned(shape, solver, 30, f, report);
      EXPECT_EQ(report.estimator, AWD_ESTIMATOR_REFIT);
      EXPECT_EQ(report.refitStatus, AWD_REFIT_CONVERGED) << report.refitMessage;
      EXPECT_EQ(report.refitAtBound, 0u);
      EXPECT_EQ(report.negative, 0u);
      EXPECT_LT(report.refitObjective, 1e-12);
      EXPECT_GT(report.refitLambda, 0.0);
      expectNear(coefficientsOf(density), expected, 1e-5);
    }
  }
}

/// What both minimise is the same, and so is what they find, where some coefficients are held by
/// the floor, some are not, and f is noisy.
TEST_F(Refit, SolversAgree) {
  uint64_t atBound = 0;
  for (const Shape& shape : shapes()) {
    for (const double shrinkage : {0.0, kNone}) {
      SCOPED_TRACE(shape.name);
      AWDDensityReport reports[2];
      std::vector<double> c[2];
      for (int i = 0; i < 2; ++i) {
        Shape present = shape;
        present.desc.shrinkage = shrinkage;
        Random noise(5);
        const Density density = learned(
            present, kSolvers[i], 6,
            [&](const double* x) {
              const double tent = std::max(0.0, 0.3 - std::fabs(x[0] - 0.4));
              return tent * -std::log(1.0 - noise.uniform());
            },
            reports[i]);
        c[i] = coefficientsOf(density);
        EXPECT_EQ(reports[i].refitStatus, AWD_REFIT_CONVERGED) << reports[i].refitMessage;
        atBound += reports[i].refitAtBound;
      }
      EXPECT_GT(reports[0].refitObjective, 0.05) << "noise can't be fitted";
      EXPECT_NEAR(reports[0].refitObjective, reports[1].refitObjective,
                  1e-8 * reports[0].refitObjective);
      const double tolerance = (shrinkage == 0.0 ? 1e-6 : 1e-4) * largestOf(c[0]);
      for (size_t j = 0; j < c[0].size(); ++j) EXPECT_NEAR(c[0][j], c[1][j], tolerance) << j;
    }
  }
  EXPECT_GT(atBound, 100u) << "a floor that holds next to nothing is not tested";
}

TEST_F(Refit, CoefficientsAreAtTheFloorAtLeast) {
  AWDDensityDesc desc = refitDesc(gridDesc());
  desc.tau = 0.2;
  const Density density = newDensity(device_, {fixedAxis("quadratic-bspline", 4)}, desc);
  Random random(4);
  const AWDDensityReport report =
      pass(density, 4000, random, [](const double* x) { return x[0] < 0.5 ? 1.0 : 0.0; });
  EXPECT_EQ(report.tau, 0.2);
  EXPECT_GT(report.refitAtBound, 4u);
  for (const double c : coefficientsOf(density)) EXPECT_GE(c, 0.15);
}

/// Of f that is 1 or 100 by chance the local mean is 50.5, the root of the mean square 70.7: the
/// constant target is the same, but not where f is sure.
TEST_F(Refit, AimsAtTheRootOfTheMeanSquareWhenAsked) {
  for (const AWDTarget target : {AWD_TARGET_MEAN, AWD_TARGET_RMS}) {
    AWDDensityDesc desc = refitDesc(gridDesc());
    desc.target = target;
    const Density density = newDensity(device_, {fixedAxis("haar", 1)}, desc);
    Random random(6);
    pass(density, 100000, random, [&](const double* x) {
      return x[0] < 0.5 ? (random.uniform() < 0.5 ? 1.0 : 100.0) : 50.5;
    });
    const std::vector<double> c = coefficientsOf(density);
    EXPECT_NEAR(c[0] / c[1], target == AWD_TARGET_MEAN ? 1.0 : 70.714 / 50.5, 0.01);
  }
}

/// Whatever the samples are, there is a density after them, and nobody has printed anything: Ceres
/// would, of what it can't solve.
TEST_F(Refit, BadDataHasADefinedResult) {
  testing::internal::CaptureStderr();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    const char* name;
    size_t samples;
    Function f;
    bool kept;
  } cases[] = {
      {"no samples", 0, [](const double*) { return 1.0; }, true},
      {"one sample", 1, [](const double*) { return 3.0; }, false},
      {"all zero", 500, [](const double*) { return 0.0; }, true},
      {"all NaN", 500, [&](const double*) { return nan; }, true},
      {"one value", 500, [](const double* x) { return x[0] < 0.01 ? 1e10 : 0.0; }, false},
      {"60 decades", 500, [](const double* x) { return std::pow(10.0, 60.0 * x[0] - 30.0); },
       false},
      {"tiny", 500, [](const double* x) { return 1e-300 * x[0]; }, false},
      {"huge", 500, [](const double* x) { return 1e300 * x[0]; }, false},
  };
  for (const char* solver : kSolvers) {
    for (const Shape& shape : shapes()) {
      for (const double shrinkage : {0.0, kNone}) {
        for (const auto& c : cases) {
          SCOPED_TRACE(std::string(shape.name) + " " + c.name + " " + solver);
          AWDDensityDesc desc = refitDesc(shape.desc, solver);
          desc.shrinkage = shrinkage;
          desc.tau = kNone;
          const Density density = newDensity(device_, shape.axes, desc);
          Random random(9);
          const AWDDensityReport report = pass(density, c.samples, random, c.f);
          EXPECT_EQ(report.kept, c.kept);
          EXPECT_EQ(report.refitStatus == AWD_REFIT_NONE, c.kept);
          EXPECT_TRUE(std::isfinite(report.refitLambda) && std::isfinite(report.refitObjective));
          EXPECT_NEAR(integralOf(density), 1.0, 1e-12);
          for (const double value : coefficientsOf(density)) {
            ASSERT_TRUE(value >= 0.0 && std::isfinite(value)) << value;
          }
        }
      }
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// The first pass draws from one cell alone, so that the others' functions are never seen.
TEST_F(Refit, CellsNeverVisitedGoByTheCascade) {
  for (const char* solver : kSolvers) {
    const Density density =
        newDensity(device_, {fixedAxis("linear-bspline", 3)}, refitDesc(gridDesc(), solver));
    std::vector<double> points(300), values(300, 2.0), pdfs(300, 8.0);
    Random random(10);
    for (double& x : points) x = 0.125 * random.uniform();
    must(awdRecordDensity(density, 300, points.data(), pdfs.data(), nullptr, values.data()));
    const AWDDensityReport report = adapt(density);
    EXPECT_EQ(report.refitStatus, AWD_REFIT_CONVERGED);
    for (const double c : coefficientsOf(density)) EXPECT_NEAR(c, 1.0, 1e-6) << "all f is 2";
  }
}

TEST_F(Refit, TheSameSamplesGiveTheSameBits) {
  const Function f = [](const double* x) { return 0.1 + x[0] * x[0]; };
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    Density densities[3];
    for (Density& density : densities) {
      density = newDensity(device_, shape.axes, refitDesc(shape.desc));
    }
    Random random(12);
    const Samples samples = draw(densities[0], 400, random, f);
    record(densities[0], samples);
    // Backwards, one by one, by way of a fork; and by way of bytes.
    const Density fork = forkOf(densities[1]);
    for (size_t i = samples.size(); i-- > 0;) {
      record(i % 3 ? static_cast<AWDDensity>(fork) : densities[1], samples, i, i + 1);
    }
    must(awdJoinDensity(densities[1], fork));
    const Density other = forkOf(densities[2]);
    record(other, samples, 0, 100);
    record(densities[2], samples, 100, 400);
    const Bytes bytes = statisticsOf(other);
    must(awdAddDensityStatistics(densities[2], bytes.data(), bytes.size()));
    EXPECT_EQ(statisticsOf(densities[0]), statisticsOf(densities[1]));
    for (Density& density : densities) adapt(density);
    EXPECT_EQ(coefficientsOf(densities[0]), coefficientsOf(densities[1]));
    EXPECT_EQ(coefficientsOf(densities[0]), coefficientsOf(densities[2]));
  }
}

TEST_F(Refit, SavedInAPassItGoesOnAsIfNothingHadBeen) {
  const Function f = [](const double* x) { return 1.0 + x[0]; };
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const Density density = newDensity(device_, shape.axes, refitDesc(shape.desc, "descent"));
    Random random(13);
    record(density, draw(density, 300, random, f));
    const Bytes bytes = saved(density);
    const Density other = loaded(device_, bytes);
    EXPECT_EQ(infoOf(other).estimator, AWD_ESTIMATOR_REFIT);
    const Samples rest = draw(density, 300, random, f);
    record(density, rest);
    record(other, rest);
    adapt(density);
    adapt(other);
    EXPECT_EQ(coefficientsOf(density), coefficientsOf(other));
  }
}

TEST_F(Refit, RefinesAsThePassesGrow) {
  AWDDensityDesc desc = refitDesc(gridDesc());
  for (const bool tree : {false, true}) {
    desc.structure = tree ? AWD_STRUCTURE_TREE : AWD_STRUCTURE_GRID;
    const Density density = newDensity(device_, {{"m2", 0, 0}, {"m2", 0, 0}}, desc);
    Random random(14);
    const Function f = [](const double* x) {
      const double dx = x[0] - 0.3, dy = x[1] - 0.6;
      return std::exp(-(dx * dx + dy * dy) / (2 * 0.07 * 0.07));
    };
    const double before = relativeVariance(density, random, f);
    for (size_t samples = 1000; samples < 20000; samples *= 2) pass(density, samples, random, f);
    EXPECT_LT(relativeVariance(density, random, f), 0.05 * before) << "tree: " << tree;
  }
}

std::string refusalOf(AWDDevice device, const Axes& axes, AWDDensityDesc desc, AWDResult expected) {
  desc.axes = axes.data();
  desc.dimensions = static_cast<uint32_t>(axes.size());
  Density density;
  EXPECT_EQ(awdNewDensity(device, &desc, density.out()), expected);
  return awdGetLastErrorMessage();
}

TEST_F(Refit, SumsTooLargeAreRefusedOrAvoided) {
  AWDDensityDesc desc = refitDesc(gridDesc());
  const std::string text = refusalOf(device_, Axes(6, fixedAxis("quadratic-bspline", 2)), desc,
                                     AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(text.find("refitBytes is 268435456"), std::string::npos) << text;
  // Left to itself it keeps to levels and leaves that fit.
  desc.refitBytes = 20000;
  for (const bool tree : {false, true}) {
    desc.structure = tree ? AWD_STRUCTURE_TREE : AWD_STRUCTURE_GRID;
    const Axes axes(2, AWDDensityAxis{"m2", 0, 0});
    const Density density = newDensity(device_, axes, desc);
    Random random(15);
    for (int i = 0; i < 3; ++i) {
      const AWDDensityReport report =
          pass(density, 4000, random, [](const double* x) { return x[0] < 0.1 ? 1.0 : 1e-3; });
      EXPECT_EQ(report.refitStatus, AWD_REFIT_CONVERGED);
    }
    // At least 4 * 4 * 3 / 4 products of 32 bytes for every 4 coefficients.
    EXPECT_LE(infoOf(density).coefficients, 20000u / 32 / 3) << "tree: " << tree;
    EXPECT_GT(infoOf(density).coefficients, 20u) << "tree: " << tree;
  }
  desc.refitBytes = 100;
  refusalOf(device_, Axes(2, AWDDensityAxis{"m2", 0, 0}), desc, AWD_ERROR_INVALID_ARGUMENT);
}

TEST_F(Refit, SolversAreKnownByName) {
  const std::string text = refusalOf(device_, {fixedAxis("haar", 2)},
                                     refitDesc(gridDesc(), "newton"), AWD_ERROR_UNSUPPORTED);
  EXPECT_NE(text.find("newton"), std::string::npos) << text;
  for (const char* solver : kSolvers) EXPECT_NE(text.find(solver), std::string::npos) << text;
}

/// Stopped by its host an adapt changes nothing, and can be done again.
TEST(RefitDevice, CanBeCancelled) {
  static bool go;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;
  desc.progress = [](void*, const AWDProgress* progress) -> int32_t {
    EXPECT_STREQ(progress->operation, "adapt");
    return go;
  };
  const Device device = newDevice(&desc);
  for (const char* solver : kSolvers) {
    const Density density =
        newDensity(device, {fixedAxis("quadratic-bspline", 5)}, refitDesc(gridDesc(), solver));
    Random random(16);
    record(density, draw(density, 500, random, [](const double* x) { return x[0]; }));
    const Bytes before = saved(density);
    go = false;
    EXPECT_EQ(awdAdaptDensity(density, nullptr), AWD_ERROR_CANCELLED) << solver;
    EXPECT_EQ(saved(density), before);
    go = true;
    EXPECT_EQ(adapt(density).refitStatus, AWD_REFIT_CONVERGED);
  }
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// What stands between the sums and the solver: the solver here is a plain one of the test's own.
#include "density/refit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

#include "density/levels.h"
#include "density/plain_solver.h"
#include "util/error.h"

namespace awd {
namespace {

/// Samples of f on one axis, from the density p = 1/2 + x.
class Refit : public testing::Test {
 protected:
  template <class Function>
  NormalEquations equationsOf(int samples, Function&& f, double end = 1.0) {
    const Ref<NormalPattern> pattern = NormalPattern::make(memory(), &level_, 1);
    std::pmr::vector<BinnedSum> products(pattern->size());
    NormalEquations equations(memory());
    equations.rhs.assign(level_->count, 0.0);
    for (int i = 0; i < samples; ++i) {
      const double x = end * random_(), p = 0.5 + x, value = f(x);
      AxisValues at;
      evaluateAxis(*level_, x, at);
      pattern->forEachAlive<1>(
          &x, &at, [&](std::size_t entry, double product) { products[entry].add(product / p, 0); });
      for (uint32_t k = 0; k < at.count; ++k) {
        equations.rhs[at.function[k]] += value * at.value[k] / p;
      }
      equations.energy += value * value / p;
    }
    equations.takeMatrix(*pattern, products, 0);
    return equations;
  }

  Coefficients solve(const NormalEquations& equations, double lambda, double least,
                     const AWDRefitSolver& solver = kPlainSolver) {
    return refit({&solver, nullptr, nullptr}, equations, {prior_, weights_, least}, lambda,
                 Coefficients(memory()), report_);
  }

  Uniforms random_{5};
  Family family_ = family("quadratic-bspline", 3);
  const BasisLevel* level_ = &family_.level(3);
  Coefficients prior_{level_->count, 2.0, memory()};
  Coefficients weights_{level_->weights, memory()};
  RefitReport report_;
};

TEST_F(Refit, FindsWhatTheBasisHolds) {
  std::vector<double> truth(level_->count);
  for (double& c : truth) c = 0.1 + 1e3 * random_();
  const NormalEquations equations = equationsOf(5000, [&](double x) {
    AxisValues at;
    evaluateAxis(*level_, x, at);
    double f = 0.0;
    for (uint32_t k = 0; k < at.count; ++k) f += at.value[k] * truth[at.function[k]];
    return f;
  });
  const Coefficients c = solve(equations, 1e-13, 0.0);
  for (std::size_t j = 0; j < c.size(); ++j) EXPECT_NEAR(c[j], truth[j], 1e-7) << j;
  EXPECT_EQ(report_.status, AWD_REFIT_CONVERGED);
  EXPECT_GT(report_.iterations, 0u);
  EXPECT_LT(report_.objective, 1e-12);
}

/// The gradient of the whole objective, lambda's term and all, as the definition has it.
TEST_F(Refit, IsTheOptimumOfItsDefinition) {
  const NormalEquations equations = equationsOf(
      300, [&](double x) { return std::max(0.0, std::sin(9.0 * x)) + 0.1 * random_(); });
  const double lambda = 0.05, least = 0.03;
  for (double& c : prior_) c = 0.1 + random_();
  const Coefficients c = solve(equations, lambda, least);
  double s0 = 0.0;
  for (const double a : equations.values) s0 += a;
  int held = 0;
  for (std::size_t j = 0; j < c.size(); ++j) {
    double gradient = lambda * s0 * weights_[j] * (c[j] - prior_[j]) - equations.rhs[j];
    for (uint64_t i = equations.rowBegin[j]; i < equations.rowBegin[j + 1]; ++i) {
      gradient += equations.values[i] * c[equations.columns[i]];
    }
    EXPECT_GE(c[j], least);
    if (c[j] > least * (1.0 + 1e-12)) {
      EXPECT_NEAR(gradient, 0.0, 1e-9) << j;
    } else {
      EXPECT_GE(gradient, -1e-9) << j;
      ++held;
    }
  }
  EXPECT_GT(held, 0) << "a floor that holds nothing is not tested";
  EXPECT_GT(report_.objective, 0.0);
  EXPECT_LT(report_.objective, 1.0);
}

TEST_F(Refit, CellsThatNoSampleSawGoByThePrior) {
  for (std::size_t j = 0; j < prior_.size(); ++j) prior_[j] = 1.0 + 0.1 * double(j);
  // All samples in the first of eight cells, where three functions are alive.
  const NormalEquations equations = equationsOf(
      400, [](double) { return 5.0; }, 0.125);
  const Coefficients c = solve(equations, refitLambda(0.0, 10.0, 400.0), 0.0);
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(c[j], 5.0, 1e-4) << j;
  for (std::size_t j = 3; j < c.size(); ++j) EXPECT_NEAR(c[j], prior_[j], 1e-12) << j;
  EXPECT_GT(refitLambda(0.0, 10.0, 400.0), 0.0);
  EXPECT_EQ(refitLambda(0.5, 10.0, 400.0), 0.5 * 10.0 / 400.0);
}

/// Left open, lambda is small where f is sure and in the basis, and large where it is all noise.
TEST_F(Refit, NoiseSettlesLambda) {
  const auto lambdaOf = [&](double noise) {
    const NormalEquations equations = equationsOf(
        200, [&](double x) { return 1.0 + x - noise * (1.0 + std::log(1.0 - random_())); });
    refit({&kPlainSolver, nullptr, nullptr}, equations, {prior_, weights_, 0.0}, -1.0, 200.0,
          report_);
    return report_.lambda;
  };
  const double sure = lambdaOf(0.0), noisy = lambdaOf(1.0), wild = lambdaOf(10.0);
  EXPECT_LT(sure, 1e-4);
  EXPECT_GT(noisy, 1e-2);
  EXPECT_GT(wild, 2.0 * noisy);
  EXPECT_LE(wild, 8.0 * double(prior_.size()) / 200.0) << "at most as if all were noise";
  const NormalEquations equations = equationsOf(200, [](double x) { return x; });
  refit({&kPlainSolver, nullptr, nullptr}, equations, {prior_, weights_, 0.0}, 0.5, 200.0, report_);
  EXPECT_EQ(report_.lambda, 0.5 * double(prior_.size()) / 200.0) << "as it was asked for";
}

TEST_F(Refit, StrongPriorsWin) {
  const NormalEquations equations = equationsOf(100, [](double x) { return x; });
  const Coefficients c = solve(equations, 1e9, 0.0);
  for (std::size_t j = 0; j < c.size(); ++j) EXPECT_NEAR(c[j], prior_[j], 1e-6) << j;
}

/// Units of the values and of the sums change nothing but by rounding.
TEST_F(Refit, ScalesAsItsInput) {
  const auto f = [](double x) { return std::exp(-20.0 * (x - 0.4) * (x - 0.4)); };
  const NormalEquations equations = equationsOf(500, f);
  const Coefficients plain = solve(equations, 0.01, 0.1);
  NormalEquations scaled = equations;
  for (double& a : scaled.values) a *= 1e-120;
  for (double& b : scaled.rhs) b *= 1e30 * 1e-120;
  scaled.energy *= 1e60 * 1e-120;
  for (double& c : prior_) c *= 1e30;
  const double objective = report_.objective;
  const Coefficients other = solve(scaled, 0.01, 0.1 * 1e30);
  for (std::size_t j = 0; j < plain.size(); ++j) EXPECT_NEAR(other[j] * 1e-30, plain[j], 1e-11);
  EXPECT_NEAR(report_.objective, objective, 1e-11);
}

/// Whatever a solver does the coefficients are usable.
TEST_F(Refit, SolversThatFailOrLieLeaveThePrior) {
  static AWDRefitStatus status;
  static double answer;
  const AWDRefitSolver liar = {sizeof(AWDRefitSolver), "liar", "",
                               [](const AWDRefitProblem* p, double* c, AWDRefitOutcome* outcome) {
                                 std::fill_n(c, p->unknowns, answer);
                                 outcome->status = status;
                                 std::fill_n(outcome->message, sizeof outcome->message, '\a');
                                 return AWDResult(AWD_SUCCESS);
                               }};
  const NormalEquations equations = equationsOf(100, [](double x) { return x; });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  prior_[0] = 0.5;
  const struct {
    AWDRefitStatus status;
    double answer;
    AWDRefitStatus told;
  } cases[] = {{AWD_REFIT_FAILED, 3.0, AWD_REFIT_FAILED},
               {AWD_REFIT_NONE, 3.0, AWD_REFIT_FAILED},
               {99, 3.0, AWD_REFIT_FAILED},
               {AWD_REFIT_CONVERGED, nan, AWD_REFIT_FAILED},
               {AWD_REFIT_LIMIT, std::numeric_limits<double>::infinity(), AWD_REFIT_FAILED},
               {AWD_REFIT_CONVERGED, -3.0, AWD_REFIT_CONVERGED}};
  for (const auto& c : cases) {
    status = c.status;
    answer = c.answer;
    const Coefficients out = solve(equations, 0.1, 1.0, liar);
    EXPECT_EQ(report_.status, c.told);
    EXPECT_LE(report_.message.size(), 192u);
    EXPECT_EQ(out[0], 1.0) << "raised to the least";
    EXPECT_EQ(out[1], c.told == AWD_REFIT_FAILED ? 2.0 : 1.0);
  }
}

TEST_F(Refit, PassesOnThatTheHostSaidStopAndThatMemoryIsShort) {
  const AWDRefitSolver stopped = {
      sizeof(AWDRefitSolver), "stopped", "",
      [](const AWDRefitProblem* p, double*, AWDRefitOutcome*) {
        return AWDResult(p->progress(p->user, 0.5) ? AWD_SUCCESS : AWD_ERROR_CANCELLED);
      }};
  const AWDRefitSolver hungry = {sizeof(AWDRefitSolver), "hungry", "",
                                 [](const AWDRefitProblem*, double*, AWDRefitOutcome*) {
                                   return AWDResult(AWD_ERROR_OUT_OF_MEMORY);
                                 }};
  const NormalEquations equations = equationsOf(100, [](double x) { return x; });
  int asked = 0;
  const auto stop = [](void* user, double) -> int32_t {
    ++*static_cast<int*>(user);
    return 0;
  };
  try {
    refit({&stopped, stop, &asked}, equations, {prior_, weights_, 0.0}, 0.1, 100.0, report_);
    FAIL() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_CANCELLED);
  }
  EXPECT_EQ(asked, 1);
  EXPECT_THROW(solve(equations, 0.1, 0.0, hungry), std::bad_alloc);
}

TEST_F(Refit, BlocksAreSymmetricToTheBit) {
  NormalEquations equations(memory());
  const double block[] = {2.0, 1.0 + 0x1p-52, 0.0, 1.0, 3.0, 0.5, 0.0, 0.5, 1.0};
  equations.appendBlock(block, 3);
  equations.appendBlock(block, 1);
  EXPECT_EQ(equations.rowBegin, (std::pmr::vector<uint64_t>{0, 2, 5, 7, 8}));
  EXPECT_EQ(equations.columns, (std::pmr::vector<uint32_t>{0, 1, 0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(equations.values[1], equations.values[2]);
}

}  // namespace
}  // namespace awd

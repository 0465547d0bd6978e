// SPDX-License-Identifier: Apache-2.0
// Wrong arguments are refused with the right code and a message that names argument and value, and
// nothing has changed then.
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

#include "awd/basis.h"
#include "density/densities.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

constexpr AWDResult kInvalid = AWD_ERROR_INVALID_ARGUMENT;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class Arguments : public testing::Test {
 protected:
  void SetUp() override {
    Random random(71);
    pass(density_, 100, random, [](const double* x) { return x[0]; });
    before_ = saved(density_);
  }
  void TearDown() override {
    EXPECT_TRUE(sameBits(saved(density_), before_)) << "something has changed";
  }
  /// What awdNewDensity says of `desc` with these axes.
  void expectNone(AWDResult code, AWDDensityDesc desc, const Axes& axes,
                  const std::vector<std::string>& parts) {
    if (!axes.empty()) {
      desc.axes = axes.data();
      desc.dimensions = static_cast<uint32_t>(axes.size());
    }
    AWDDensity none = density_;
    expectFailure(awdNewDensity(device_, &desc, &none), code, parts);
    EXPECT_EQ(none, nullptr);
  }

  Device device_ = newDevice(1u);
  Density density_ = newDensity(device_, {axisFrom("linear-bspline", 1, 3), fixedAxis("m2", 1)});
  Bytes before_;
  double numbers_[64] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5};
  uint32_t components_[8] = {};
};

TEST_F(Arguments, Null) {
  AWDDensity density;
  AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
  AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
  AWDDensityAxisInfo axisInfo = AWD_DENSITY_AXIS_INFO_INIT;
  const Density tree = newDensity(device_, {fixedAxis("haar", 1)}, treeDesc());
  AWDDensityDesc desc = gridDesc();
  desc.dimensions = 1;
  double* const n = numbers_;
  const double* const in = numbers_;
  size_t size;
  char bytes[8] = {};
  const std::pair<std::function<AWDResult()>, const char*> calls[] = {
      {[&] { return awdNewDensity(nullptr, &desc, &density); }, "device"},
      {[&] { return awdNewDensity(device_, nullptr, &density); }, "desc"},
      {[&] { return awdNewDensity(device_, &desc, nullptr); }, "density"},
      {[&] { return awdForkDensity(nullptr, &density); }, "density"},
      {[&] { return awdForkDensity(density_, nullptr); }, "fork"},
      {[&] { return awdJoinDensity(nullptr, density_); }, "density"},
      {[&] { return awdJoinDensity(density_, nullptr); }, "fork"},
      {[&] { return awdSampleDensity(nullptr, 1, in, n, n, nullptr); }, "density"},
      {[&] { return awdSampleDensity(density_, 1, nullptr, n, n, nullptr); }, "uniforms"},
      {[&] { return awdSampleDensity(density_, 1, in, nullptr, n, nullptr); }, "points"},
      {[&] { return awdGetDensityPdf(nullptr, 1, in, n); }, "density"},
      {[&] { return awdGetDensityPdf(density_, 1, nullptr, n); }, "points"},
      {[&] { return awdGetDensityPdf(density_, 1, in, nullptr); }, "pdfs"},
      {[&] { return awdRecordDensity(nullptr, 1, in, in, nullptr, in); }, "density"},
      {[&] { return awdRecordDensity(density_, 1, nullptr, in, nullptr, in); }, "points"},
      {[&] { return awdRecordDensity(density_, 1, in, in, nullptr, nullptr); }, "values"},
      {[&] { return awdAdaptDensity(nullptr, nullptr); }, "density"},
      {[&] { return awdRefineDensity(nullptr, 0); }, "density"},
      {[&] { return awdGetDensityEstimate(nullptr, &estimate); }, "density"},
      {[&] { return awdGetDensityEstimate(density_, nullptr); }, "estimate"},
      {[&] { return awdGetDensityInfo(nullptr, &info); }, "density"},
      {[&] { return awdGetDensityInfo(density_, nullptr); }, "info"},
      {[&] { return awdGetDensityAxisInfo(nullptr, 0, &axisInfo); }, "density"},
      {[&] { return awdGetDensityAxisInfo(density_, 0, nullptr); }, "info"},
      {[&] { return awdGetDensityCoefficients(nullptr, 0, n, 64); }, "density"},
      {[&] { return awdGetDensityCoefficients(density_, 0, nullptr, 64); }, "coefficients"},
      {[&] { return awdSetDensityCoefficients(nullptr, in, 12); }, "density"},
      {[&] { return awdSetDensityCoefficients(density_, nullptr, 12); }, "coefficients"},
      {[&] { return awdGetDensityIntegral(nullptr, in, in, n); }, "density"},
      {[&] { return awdGetDensityIntegral(density_, nullptr, in, n); }, "lower"},
      {[&] { return awdGetDensityIntegral(density_, in, nullptr, n); }, "upper"},
      {[&] { return awdGetDensityIntegral(density_, in, in, nullptr); }, "integral"},
      {[&] { return awdGetDensityLeaves(nullptr, n, 1, &size); }, "density"},
      {[&] { return awdGetDensityLeaves(density_, n, 1, nullptr); }, "count"},
      {[&] { return awdGetDensityLeaves(density_, nullptr, 1, &size); }, "boxes"},
      {[&] { return awdGetDensityDetailEnergy(nullptr, n, 1, &size); }, "density"},
      {[&] { return awdGetDensityDetailEnergy(tree, n, 1, nullptr); }, "count"},
      {[&] { return awdGetDensityDetailEnergy(tree, nullptr, 1, &size); }, "energies"},
      {[&] { return awdExportDensityStatistics(nullptr, bytes, 8, &size); }, "density"},
      {[&] { return awdExportDensityStatistics(density_, bytes, 8, nullptr); }, "size"},
      {[&] { return awdAddDensityStatistics(nullptr, bytes, 8); }, "density"},
      {[&] { return awdAddDensityStatistics(density_, nullptr, 8); }, "bytes"},
      {[&] { return awdImportDensityStatistics(nullptr, bytes, 8); }, "density"},
      {[&] { return awdImportDensityStatistics(density_, nullptr, 8); }, "bytes"},
      {[&] { return awdSaveDensity(nullptr, bytes, 8, &size); }, "density"},
      {[&] { return awdSaveDensity(density_, bytes, 8, nullptr); }, "size"},
      {[&] { return awdLoadDensity(nullptr, bytes, 8, &density); }, "device"},
      {[&] { return awdLoadDensity(device_, nullptr, 8, &density); }, "bytes"},
      {[&] { return awdLoadDensity(device_, bytes, 8, nullptr); }, "density"},
  };
  int number = 0;
  for (const auto& [call, argument] : calls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {std::string(argument) + " is NULL"});
  }
}

TEST_F(Arguments, NullWhereItMayBe) {
  awdRetainDensity(nullptr);
  awdReleaseDensity(nullptr);
  must(awdSampleDensity(density_, 0, nullptr, nullptr, nullptr, nullptr));
  must(awdSampleDensity(density_, 1, numbers_, numbers_ + 8, nullptr, nullptr));
  must(awdGetDensityPdf(density_, 0, nullptr, nullptr));
  must(awdRecordDensity(density_, 0, nullptr, nullptr, nullptr, nullptr));
  size_t count;
  must(awdGetDensityLeaves(density_, nullptr, 0, &count));
  EXPECT_EQ(count, 1u) << "a grid is one box";
  EXPECT_EQ(leavesOf(density_), (std::vector<double>{0.0, 0.0, 1.0, 1.0}));
  // One reference more, and it is still there after one less.
  awdRetainDensity(density_);
  awdReleaseDensity(density_);
}

TEST_F(Arguments, StructSizes) {
  AWDDensityDesc desc = gridDesc();
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
  AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
  AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
  AWDDensityAxisInfo axisInfo = AWD_DENSITY_AXIS_INFO_INIT;
  for (const size_t size : {size_t{0}, size_t{7}, size_t{5000}}) {
    desc.structSize = report.structSize = estimate.structSize = info.structSize =
        axisInfo.structSize = size;
    const std::string figure = "structSize is " + std::to_string(size);
    expectNone(kInvalid, desc, {}, {"desc", figure, "AWD_DENSITY_DESC_INIT"});
    expectFailure(awdAdaptDensity(density_, &report), kInvalid,
                  {"report", figure, "AWD_DENSITY_REPORT_INIT"});
    expectFailure(awdGetDensityEstimate(density_, &estimate), kInvalid,
                  {"estimate", figure, "AWD_DENSITY_ESTIMATE_INIT"});
    expectFailure(awdGetDensityInfo(density_, &info), kInvalid,
                  {"info", figure, "AWD_DENSITY_INFO_INIT"});
    expectFailure(awdGetDensityAxisInfo(density_, 0, &axisInfo), kInvalid,
                  {"info", figure, "AWD_DENSITY_AXIS_INFO_INIT"});
  }
  // Hosts that were compiled with fewer fields get those.
  info = AWD_DENSITY_INFO_INIT;
  info.structSize = offsetof(AWDDensityInfo, leaves);
  info.leaves = 77;
  must(awdGetDensityInfo(density_, &info));
  EXPECT_EQ(info.dimensions, 2u);
  EXPECT_EQ(info.leaves, 77u);
}

TEST_F(Arguments, TheDesc) {
  AWDDensityDesc desc = gridDesc();
  for (const uint32_t dimensions : {0u, 7u, 0xFFFFFFFFu}) {
    desc.dimensions = dimensions;
    expectNone(kInvalid, desc, {}, {"desc->dimensions is " + std::to_string(dimensions), "1 to 6"});
  }
  desc.dimensions = 2;
  const std::pair<int32_t AWDDensityDesc::*, const char*> choices[] = {
      {&AWDDensityDesc::structure, "structure"},
      {&AWDDensityDesc::estimator, "estimator"},
      {&AWDDensityDesc::target, "target"},
      {&AWDDensityDesc::sampler, "sampler"},
      {&AWDDensityDesc::combination, "combination"}};
  for (const auto& [choice, name] : choices) {
    for (const int32_t bad : {-1, 6, 1 << 30}) {
      AWDDensityDesc wrong = desc;
      wrong.*choice = bad;
      expectNone(kInvalid, wrong, {}, {std::string(name) + " is " + std::to_string(bad)});
    }
  }
  for (const double tau : {kNaN, 1.01, HUGE_VAL}) {
    AWDDensityDesc wrong = desc;
    wrong.tau = tau;
    expectNone(kInvalid, wrong, {}, {"desc->tau", "at most 1"});
  }
  for (const double shrinkage : {kNaN, HUGE_VAL, -HUGE_VAL}) {
    AWDDensityDesc wrong = desc;
    wrong.shrinkage = shrinkage;
    expectNone(kInvalid, wrong, {}, {"desc->shrinkage", "finite"});
  }
  desc.maxCoefficients = UINT64_MAX;
  expectNone(kInvalid, desc, {}, {"desc->maxCoefficients is 18446744073709551615"});
  desc = gridDesc();
  desc.estimator = AWD_ESTIMATOR_PAPER;
  desc.sampler = AWD_SAMPLER_INVERSE_CDF;
  expectNone(kInvalid, desc, Axes(2, axisFrom("haar", 0, 2)), {"desc->sampler", "paper"});
  desc = treeDesc();
  desc.sampler = AWD_SAMPLER_COMPONENT;
  expectNone(AWD_ERROR_UNSUPPORTED, desc, Axes(2, axisFrom("haar", 0, 2)),
             {"desc->sampler", "tree"});
}

TEST_F(Arguments, Axes) {
  expectNone(AWD_ERROR_UNSUPPORTED, gridDesc(), {fixedAxis("haar", 0), fixedAxis("no-such", 0)},
             {"\"no-such\"", "haar", "bases-1"});  // the paths that were tried
  expectNone(AWD_ERROR_UNSUPPORTED, treeDesc(), {fixedAxis("haar", 0), {"linear-bspline", 0, 0}},
             {"desc->axes[1].basis is linear-bspline", "nested"});
  expectNone(kInvalid, gridDesc(), {fixedAxis("haar", 0), axisFrom("haar", 0, 21)},
             {"desc->axes[1].maxLevel", "21", "0 to 20"});
  expectNone(kInvalid, gridDesc(), {axisFrom("haar", 21, 3)},
             {"desc->axes[0].startLevel", "21", "0 to 20"});
  expectNone(kInvalid, gridDesc(), {axisFrom("haar", 4, 3)},
             {"desc->axes[0].startLevel", "4", "maxLevel, 3"});
  expectNone(kInvalid, treeDesc(), {axisFrom("haar", 0, 31)},
             {"desc->axes[0].maxLevel", "31", "0 to 30"});
  expectNone(kInvalid, gridDesc(), Axes(6, fixedAxis("haar", 3)),
             {"262144 coefficients", "desc->maxCoefficients is 65536"});
  expectNone(kInvalid, gridDesc(), Axes(6, fixedAxis("haar", 20)),
             {"more than", "coefficients", "desc->maxCoefficients is 65536"});
  expectNone(kInvalid, treeDesc(), Axes(6, fixedAxis("haar", 3)),
             {"262144 coefficients", "desc->maxCoefficients is 65536"});
  AWDDensityDesc desc = treeDesc();
  desc.maxCoefficients = 8;
  expectNone(AWD_ERROR_UNSUPPORTED, desc, Axes(2, fixedAxis("m3", 0)), {"9 coefficients", "8"});
}

TEST_F(Arguments, Numbers) {
  double out[8];
  for (const double bad : {1.0, -1e-300, kNaN, HUGE_VAL}) {
    const double uniforms[] = {0.5, 0.5, 0.5, bad};
    expectFailure(awdSampleDensity(density_, 2, uniforms, out, nullptr, nullptr), kInvalid,
                  {"uniforms[3]", "[0,1)", "point 1"});
  }
  const double value = 1.0;
  for (const double bad : {1.0 + 1e-15, -1e-300, kNaN, -HUGE_VAL}) {
    const double points[] = {bad, 0.5};
    expectFailure(awdGetDensityPdf(density_, 1, points, out), kInvalid, {"points[0]", "[0,1]"});
    expectFailure(awdRecordDensity(density_, 1, points, nullptr, nullptr, &value), kInvalid,
                  {"points[0]", "[0,1]"});
  }
  // Of many samples the last is wrong: none is recorded.
  for (const double bad : {0.0, -1.0, kNaN, HUGE_VAL}) {
    const double pdfs[] = {1.0, 1.0, bad};
    expectFailure(awdRecordDensity(density_, 3, numbers_, pdfs, nullptr, numbers_), kInvalid,
                  {"pdfs[2]", "positive"});
  }
  expectFailure(awdGetDensityPdf(density_, SIZE_MAX / 8, numbers_, out), kInvalid, {"count"});
  expectFailure(awdRefineDensity(density_, 2), kInvalid, {"axis is 2", "2"});
  AWDDensityAxisInfo info = AWD_DENSITY_AXIS_INFO_INIT;
  expectFailure(awdGetDensityAxisInfo(density_, 2, &info), kInvalid, {"axis is 2", "2"});
  for (const auto& [a, b] :
       {std::pair(0.6, 0.4), {-0.1, 0.5}, {0.5, 1.1}, {kNaN, 1.0}, {0.0, kNaN}}) {
    const double lower[] = {0.0, a}, upper[] = {1.0, b};
    expectFailure(awdGetDensityIntegral(density_, lower, upper, out), kInvalid,
                  {"lower[1]", "upper[1]"});
  }
}

TEST_F(Arguments, Components) {
  AWDDensityDesc desc = gridDesc();
  desc.estimator = AWD_ESTIMATOR_PAPER;
  const Density paper = newDensity(device_, {fixedAxis("linear-bspline", 2)}, desc);
  expectFailure(awdRecordDensity(paper, 1, numbers_, numbers_, nullptr, numbers_), kInvalid,
                {"components is NULL", "awdSampleDensity"});
  components_[1] = 5;
  expectFailure(awdRecordDensity(paper, 2, numbers_, numbers_, components_, numbers_), kInvalid,
                {"components[1] is 5", "5 components"});
  EXPECT_EQ(infoOf(paper).samples, 0u);
}

TEST_F(Arguments, Coefficients) {
  const size_t n = infoOf(density_).coefficients;
  std::vector<double> c(n, 1.0);
  expectFailure(awdSetDensityCoefficients(density_, c.data(), n - 1), kInvalid,
                {"count is " + std::to_string(n - 1), std::to_string(n)});
  for (const double bad : {-1e-300, kNaN, HUGE_VAL}) {
    c[n - 1] = bad;
    expectFailure(awdSetDensityCoefficients(density_, c.data(), n), kInvalid,
                  {"coefficients[" + std::to_string(n - 1) + "]"});
  }
  c.assign(n, 0.0);
  expectFailure(awdSetDensityCoefficients(density_, c.data(), n), kInvalid, {"all 0"});
  c.assign(n, 77.0);
  expectFailure(awdGetDensityCoefficients(density_, AWD_COEFFICIENTS_SCALING, c.data(), n - 1),
                kInvalid, {"capacity is " + std::to_string(n - 1), std::to_string(n)});
  EXPECT_EQ(c, std::vector<double>(n, 77.0)) << "nothing was written";
  expectFailure(awdGetDensityCoefficients(density_, 2, c.data(), n), kInvalid, {"form is 2"});
  // linear-bspline is not nested.
  expectFailure(awdGetDensityCoefficients(density_, AWD_COEFFICIENTS_ORTHONORMAL, c.data(), n),
                AWD_ERROR_UNSUPPORTED, {"nested"});
  size_t count;
  expectFailure(awdGetDensityDetailEnergy(density_, nullptr, 0, &count), AWD_ERROR_UNSUPPORTED,
                {"nested"});
}

/// Coefficients neither of the largest nor of the smallest numbers overflow on the way.
TEST_F(Arguments, CoefficientsOfAnyMagnitude) {
  const Density density = newDensity(device_, Axes(2, fixedAxis("haar", 2)));
  for (const double magnitude : {1e308, 1e-308, 5e-324}) {
    std::vector<double> c(16, magnitude);
    c[3] = 0.0;
    setCoefficients(density, c);
    c.assign(16, 16.0 / 15.0);
    c[3] = 0.0;
    const std::vector<double> seen = coefficientsOf(density);
    for (size_t i = 0; i < 16; ++i) EXPECT_NEAR(seen[i], c[i], 1e-14) << magnitude;
  }
}

TEST_F(Arguments, CallsAtTheWrongTime) {
  const Density density = newDensity(device_, {axisFrom("haar", 1, 2)});
  const double x = 0.5, f = 1.0;
  must(awdRecordDensity(density, 1, &x, nullptr, nullptr, &f));
  const Bytes before = saved(density);
  expectFailure(awdRefineDensity(density, 0), AWD_ERROR_INVALID_OPERATION,
                {"1 samples", "adapt before refining"});
  const double c[] = {1.0, 2.0};
  expectFailure(awdSetDensityCoefficients(density, c, 2), AWD_ERROR_INVALID_OPERATION,
                {"1 samples", "adapt before"});
  EXPECT_TRUE(sameBits(saved(density), before));
  // Beyond the last level, and beyond the number of coefficients: all axes or none.
  const Density full = newDensity(device_, {axisFrom("haar", 1, 2), fixedAxis("haar", 1)});
  const Bytes old = saved(full);
  expectFailure(awdRefineDensity(full, AWD_ALL_AXES), AWD_ERROR_INVALID_OPERATION,
                {"axis 1", "level 1"});
  EXPECT_TRUE(sameBits(saved(full), old));
  must(awdRefineDensity(full, 0));
  expectFailure(awdRefineDensity(full, 0), AWD_ERROR_INVALID_OPERATION, {"axis 0", "level 2"});
  AWDDensityDesc desc = treeDesc();
  desc.maxCoefficients = 5;
  const Density tree = newDensity(device_, {axisFrom("m2", 1, 9)}, desc);
  expectFailure(awdRefineDensity(tree, 0), AWD_ERROR_INVALID_OPERATION,
                {"8 coefficients", "maxCoefficients is 5"});
}

/// Everything that the defaults are documented to be.
TEST_F(Arguments, Defaults) {
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 3;
  Density density;
  must(awdNewDensity(device_, &desc, density.out()));
  AWDDensityInfo info = infoOf(density);
  EXPECT_EQ(info.structure, AWD_STRUCTURE_GRID);
  EXPECT_EQ(info.estimator, AWD_ESTIMATOR_DEFAULT);
  EXPECT_EQ(info.target, AWD_TARGET_MEAN);
  EXPECT_EQ(info.sampler, AWD_SAMPLER_INVERSE_CDF);
  EXPECT_EQ(info.combination, AWD_COMBINE_COUNT);
  EXPECT_EQ(info.uniforms, 3u);
  EXPECT_EQ(info.learned, 0u);
  EXPECT_GT(info.bytes, 8 * info.coefficients);
  EXPECT_STREQ(axisInfoOf(density, 2).basis, "linear-bspline");
  EXPECT_EQ(coefficientsOf(density), std::vector<double>(info.coefficients, 1.0));
  desc.structure = AWD_STRUCTURE_TREE;
  must(awdNewDensity(device_, &desc, density.out()));
  info = infoOf(density);
  EXPECT_EQ(info.structure, AWD_STRUCTURE_TREE);
  EXPECT_EQ(info.leaves, info.coefficients);
  EXPECT_GT(info.leaves, 1u);
  const AWDDensityAxisInfo axis = axisInfoOf(density, 0);
  EXPECT_STREQ(axis.basis, "haar");
  EXPECT_EQ(axis.maxLevel, 20u);
  EXPECT_EQ(axis.count, 1u);
  EXPECT_EQ(axis.order, 1u);
  EXPECT_TRUE(axis.flags & AWD_BASIS_NESTED);
  desc.structure = AWD_STRUCTURE_DEFAULT;
  desc.estimator = AWD_ESTIMATOR_PAPER;
  must(awdNewDensity(device_, &desc, density.out()));
  EXPECT_EQ(infoOf(density).sampler, AWD_SAMPLER_COMPONENT) << "which the paper's wants";
  EXPECT_EQ(infoOf(density).uniforms, 4u);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Densities as bytes: they go on with the same bits, and damage is found.
#include <gtest/gtest.h>

#include <algorithm>

#include "density/densities.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

struct Case {
  const char* name;
  Axes axes;
  AWDDensityDesc desc;
};

std::vector<Case> cases() {
  const auto with = [](AWDDensityDesc desc, AWDEstimator estimator, AWDCombination combination) {
    desc.estimator = estimator;
    desc.combination = combination;
    desc.maxCoefficients = 60;
    desc.passSamples = 40;
    return desc;
  };
  const AWDDensityDesc grid = with(gridDesc(), AWD_ESTIMATOR_DEFAULT, AWD_COMBINE_DEFAULT),
                       tree = with(treeDesc(), AWD_ESTIMATOR_DEFAULT, AWD_COMBINE_DEFAULT);
  return {
      {"haar", {{"haar", 0, 0}, {"haar", 0, 0}}, grid},
      {"three families",
       {axisFrom("quadratic-bspline-periodic", 0, 2), fixedAxis("m3", 0), {"f2", 0, 0}},
       grid},
      {"paper",
       {axisFrom("linear-bspline", 1, 3), axisFrom("quadratic-bspline", 0, 2)},
       with(gridDesc(), AWD_ESTIMATOR_PAPER, AWD_COMBINE_DEFAULT)},
      {"history of a grid",
       {{"linear-bspline-periodic", 0, 0}},
       with(gridDesc(), AWD_ESTIMATOR_DEFAULT, AWD_COMBINE_CROSS_VARIANCE)},
      {"tree", {{"haar", 0, 0}, {"haar", 0, 0}}, tree},
      {"tree of two families", {{"f2", 0, 0}, axisFrom("m2", 0, 3)}, tree},
      {"history of a tree",
       {{"m3", 0, 0}},
       with(treeDesc(), AWD_ESTIMATOR_RATIO, AWD_COMBINE_CROSS_VARIANCE)},
  };
}

class DensityBytes : public testing::Test {
 protected:
  /// Three passes have been learned, and a fourth is at work.
  Density trained(const Case& c) const {
    Density density = newDensity(device_, c.axes, c.desc);
    Random random(61);
    for (int k = 0; k < 3; ++k) pass(density, 150, random, function(c));
    record(density, draw(density, 77, random, function(c)));
    return density;
  }
  static Function function(const Case& c) {
    const auto d = static_cast<uint32_t>(c.axes.size());
    return [d](const double* x) { return 0.1 - bump(x, d, 0.2); };
  }

  Device device_ = newDevice(1u);
};

TEST_F(DensityBytes, ALoadedDensityGoesOnWithTheSameBits) {
  const Device other = newDevice(1u);
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Density density = trained(c);
    const Bytes bytes = saved(density);
    const Density copy = loaded(other, bytes);
    EXPECT_TRUE(sameBits(saved(copy), bytes));
    const AWDDensityInfo a = infoOf(density), b = infoOf(copy);
    EXPECT_EQ(a.coefficients, b.coefficients);
    EXPECT_EQ(a.samples, 77u);
    EXPECT_EQ(b.samples, 77u);
    EXPECT_EQ(b.learned, 150u);
    EXPECT_EQ(b.passes, 3u);
    EXPECT_EQ(a.estimator, b.estimator);
    EXPECT_EQ(a.combination, b.combination);
    for (uint32_t axis = 0; axis < a.dimensions; ++axis) {
      EXPECT_STREQ(axisInfoOf(copy, axis).basis, c.axes[axis].basis);
      EXPECT_EQ(axisInfoOf(copy, axis).level, axisInfoOf(density, axis).level);
      EXPECT_EQ(axisInfoOf(copy, axis).maxLevel, axisInfoOf(density, axis).maxLevel);
    }
    Random ours(62), theirs(62);
    for (int k = 0; k < 3; ++k) {
      const Samples one = draw(density, 200, ours, function(c));
      const Samples two = draw(copy, 200, theirs, function(c));
      EXPECT_TRUE(sameBits(one.points, two.points));
      EXPECT_TRUE(sameBits(one.pdfs, two.pdfs));
      record(density, one);
      record(copy, two);
      EXPECT_EQ(estimateOf(density).integral, estimateOf(copy).integral);
      EXPECT_EQ(estimateOf(density).standardError, estimateOf(copy).standardError);
      const AWDDensityReport first = adapt(density), second = adapt(copy);
      EXPECT_EQ(first.coefficients, second.coefficients);
      EXPECT_EQ(first.tau, second.tau);
      EXPECT_EQ(first.split, second.split);
      EXPECT_TRUE(sameBits(saved(density), saved(copy)));
    }
  }
}

/// One of the ways in which bytes go wrong; never without a change.
Bytes corrupted(const Bytes& bytes, Random& random) {
  const auto below = [&](size_t n) { return static_cast<size_t>(random.uniform() * double(n)); };
  Bytes out = bytes;
  while (out == bytes) {
    const size_t at = below(out.size());
    switch (below(7)) {
      case 0:
        out[at] = static_cast<char>(out[at] ^ (1 << below(8)));
        break;
      case 1:
        for (size_t k = 1 + below(8); k > 0; --k) {
          out[below(out.size())] = static_cast<char>(random.bits());
        }
        break;
      case 2:
        out.resize(at);
        break;
      case 3:
        out.insert(out.begin() + static_cast<std::ptrdiff_t>(at), 1 + below(9),
                   static_cast<char>(random.bits()));
        break;
      case 4:
        std::swap(out[at], out[below(out.size())]);
        break;
      case 5:  // words change places
        if (out.size() >= 16) {
          std::swap_ranges(out.begin(), out.begin() + 8,
                           out.end() - 8 - static_cast<std::ptrdiff_t>(below(out.size() - 15)));
        }
        break;
      default:
        out.erase(out.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
  return out;
}

TEST_F(DensityBytes, TenThousandCorruptionsAreRefused) {
  const std::vector<Case> all = cases();
  const size_t each = 10000 / all.size() + 1;
  size_t refused = 0;
  for (const Case& c : all) {
    SCOPED_TRACE(c.name);
    const Density density = trained(c);
    const Bytes bytes = saved(density), statistics = statisticsOf(density);
    Random random(63);
    for (size_t i = 0; i < each; ++i) {
      const Bytes damaged = corrupted(bytes, random);
      AWDDensity none = density;
      const AWDResult result = awdLoadDensity(device_, damaged.data(), damaged.size(), &none);
      ASSERT_EQ(result, AWD_ERROR_IO) << awdGetLastErrorMessage();
      ASSERT_EQ(none, nullptr);
      ASSERT_STRNE(awdGetLastErrorMessage(), "");
      ++refused;
      if (i % 4 != 0) continue;
      const Bytes other = corrupted(statistics, random);
      ASSERT_EQ(awdAddDensityStatistics(density, other.data(), other.size()), AWD_ERROR_IO);
      ASSERT_EQ(awdImportDensityStatistics(density, other.data(), other.size()), AWD_ERROR_IO);
    }
    EXPECT_TRUE(sameBits(saved(density), bytes)) << "refused statistics change nothing";
  }
  EXPECT_GE(refused, 10000u);
}

TEST_F(DensityBytes, BytesOfOtherKindsAndVersions) {
  const Density density = trained(cases()[0]);
  const Bytes bytes = saved(density);
  AWDDensity none;
  Bytes other = bytes;
  other[0] = 'B';
  expectFailure(awdLoadDensity(device_, other.data(), other.size(), &none), AWD_ERROR_IO,
                {"not a saved density"});
  other = bytes;
  other[8] = 9;
  expectFailure(awdLoadDensity(device_, other.data(), other.size(), &none), AWD_ERROR_IO,
                {"version 9", "version 1"});
  other = bytes;
  other.pop_back();
  expectFailure(awdLoadDensity(device_, other.data(), other.size(), &none), AWD_ERROR_IO,
                {std::to_string(bytes.size()) + " bytes", std::to_string(other.size())});
  other = bytes;
  other.back() = static_cast<char>(other.back() ^ 1);
  expectFailure(awdLoadDensity(device_, other.data(), other.size(), &none), AWD_ERROR_IO,
                {"checksum"});
  const char nothing = 0;
  expectFailure(awdLoadDensity(device_, &nothing, 0, &none), AWD_ERROR_IO, {"0 bytes"});
}

TEST_F(DensityBytes, TheSizeIsToldBeforeAnythingIsWritten) {
  const Density density = trained(cases()[0]);
  for (const auto call : {awdSaveDensity, awdExportDensityStatistics}) {
    size_t size = 0;
    must(call(density, nullptr, 0, &size));
    Bytes bytes(size, 'x');
    size_t again = 0;
    expectFailure(call(density, bytes.data(), size - 1, &again), AWD_ERROR_INVALID_ARGUMENT,
                  {"capacity", std::to_string(size - 1), std::to_string(size)});
    EXPECT_EQ(again, size);
    EXPECT_EQ(bytes, Bytes(size, 'x'));
    expectFailure(call(density, nullptr, size, &again), AWD_ERROR_INVALID_ARGUMENT, {"bytes"});
    bytes.resize(size + 1, 'x');
    must(call(density, bytes.data(), size + 1, &again));
    EXPECT_EQ(again, size);
    EXPECT_EQ(bytes.back(), 'x');
  }
}

}  // namespace

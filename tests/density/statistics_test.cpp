// SPDX-License-Identifier: Apache-2.0
// The same samples make the same density to the last bit: in any order, in batches of any size, on
// any number of threads, and by way of bytes that were sent around.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <thread>

#include "density/densities.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

constexpr size_t kSamples = 2100;
constexpr uint64_t kCoefficients = 1200;

/// Values over 40 decades and of both signs, some of them 0, some no numbers.
double wild(const double* x) {
  const double t = 37.0 * x[0] + 11.0 * x[1];
  const int kind = static_cast<int>(100.0 * t) % 20;
  if (kind == 0) return 0.0;
  if (kind == 1) return std::nan("");
  return (kind % 2 ? 1.0 : -1.0) * std::pow(10.0, 20.0 * std::sin(t));
}

struct Case {
  const char* name;
  Axes axes;
  AWDDensityDesc desc;
};

std::vector<Case> cases() {
  const auto with = [](AWDDensityDesc desc, AWDEstimator estimator, AWDTarget target,
                       AWDCombination combination) {
    desc.estimator = estimator;
    desc.target = target;
    desc.combination = combination;
    desc.maxCoefficients = kCoefficients;
    return desc;
  };
  const Axes linear(2, axisFrom("linear-bspline", 2, 5)), haar(2, axisFrom("haar", 1, 9)),
      bernstein = {axisFrom("m2", 1, 8), axisFrom("m3", 0, 8)};
  return {
      {"grid", linear, with(gridDesc(), AWD_ESTIMATOR_DEFAULT, AWD_TARGET_MEAN, AWD_COMBINE_COUNT)},
      {"grid, ratio, rms", linear,
       with(gridDesc(), AWD_ESTIMATOR_RATIO, AWD_TARGET_RMS, AWD_COMBINE_COUNT)},
      {"grid, paper, cross variance", linear,
       with(gridDesc(), AWD_ESTIMATOR_PAPER, AWD_TARGET_MEAN, AWD_COMBINE_CROSS_VARIANCE)},
      {"tree", haar, with(treeDesc(), AWD_ESTIMATOR_DEFAULT, AWD_TARGET_MEAN, AWD_COMBINE_COUNT)},
      {"tree, rms, cross variance", bernstein,
       with(treeDesc(), AWD_ESTIMATOR_DEFAULT, AWD_TARGET_RMS, AWD_COMBINE_CROSS_VARIANCE)},
  };
}

/// All there is to see of a density with pending samples, and of what it learns from them.
struct Outcome {
  Bytes statistics, pending, adapted;
  std::vector<double> coefficients;

  explicit Outcome(AWDDensity density)
      : statistics(statisticsOf(density)), pending(saved(density)) {
    adapt(density);
    adapted = saved(density);
    coefficients = coefficientsOf(density);
  }
};

void expectSame(const Outcome& a, const Outcome& b) {
  EXPECT_TRUE(sameBits(a.statistics, b.statistics));
  EXPECT_TRUE(sameBits(a.pending, b.pending));
  EXPECT_TRUE(sameBits(a.adapted, b.adapted));
  EXPECT_TRUE(sameBits(a.coefficients, b.coefficients));
}

class Statistics : public testing::Test {
 protected:
  /// A density that has learned something, with a history if it keeps one.
  Density trained(const Case& c) const {
    Density density = newDensity(device_, c.axes, c.desc);
    Random random(31);
    for (int k = 0; k < 2; ++k) {
      pass(density, 500, random, [](const double* x) { return bump(x, 2, 0.2); });
    }
    return density;
  }
  /// The samples of its next pass, the same each time.
  Samples next(AWDDensity density) const {
    Random random(32);
    return draw(density, kSamples, random, wild);
  }
  Outcome whole(const Case& c) const {
    const Density density = trained(c);
    record(density, next(density));
    EXPECT_EQ(infoOf(density).samples, kSamples);
    return Outcome(density);
  }

  template <class Test>
  void forEach(Test&& test) const {
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name);
      test(c);
    }
  }

  Device device_ = newDevice(1u);
};

Samples permuted(const Samples& samples, const std::vector<size_t>& order) {
  Samples out;
  out.dimensions = samples.dimensions;
  for (const size_t i : order) {
    out.points.insert(out.points.end(), samples.point(i), samples.point(i) + samples.dimensions);
    out.pdfs.push_back(samples.pdfs[i]);
    out.values.push_back(samples.values[i]);
    out.components.push_back(samples.components[i]);
  }
  return out;
}

TEST_F(Statistics, OrderDoesNotMatter) {
  forEach([&](const Case& c) {
    const Outcome expected = whole(c);
    for (const uint64_t seed : {1u, 2u, 3u}) {
      const Density density = trained(c);
      const Samples samples = next(density);
      std::vector<size_t> order(samples.size());
      std::iota(order.begin(), order.end(), size_t{0});
      if (seed == 1) {
        std::reverse(order.begin(), order.end());
      } else {
        Random random(seed);
        for (size_t i = order.size(); i-- > 1;) {
          std::swap(order[i], order[static_cast<size_t>(random.uniform() * double(i + 1))]);
        }
      }
      record(density, permuted(samples, order));
      expectSame(Outcome(density), expected);
    }
  });
}

TEST_F(Statistics, BatchesDoNotMatter) {
  forEach([&](const Case& c) {
    const Outcome expected = whole(c);
    for (const size_t batch : {1u, 7u, 256u, 1000u}) {
      const Density density = trained(c);
      const Samples samples = next(density);
      for (size_t i = 0; i < samples.size(); i += batch) {
        record(density, samples, i, std::min(i + batch, samples.size()));
      }
      expectSame(Outcome(density), expected);
    }
  });
}

/// p evaluated by the library is what the sampler said it was.
TEST_F(Statistics, PdfsMayBeLeftOut) {
  forEach([&](const Case& c) {
    const Density density = trained(c);
    const Samples samples = next(density);
    must(awdRecordDensity(density, samples.size(), samples.points.data(), nullptr,
                          samples.components.data(), samples.values.data()));
    expectSame(Outcome(density), whole(c));
  });
}

TEST_F(Statistics, ThreadsDoNotMatter) {
  forEach([&](const Case& c) {
    const Outcome expected = whole(c);
    for (size_t threads = 1; threads <= 5; ++threads) {
      const Density density = trained(c);
      const Samples samples = next(density);
      std::vector<Density> forks;
      for (size_t t = 0; t < threads; ++t) forks.push_back(forkOf(density));
      std::vector<std::thread> workers;
      for (size_t t = 0; t < threads; ++t) {
        workers.emplace_back([&, t] {
          // Shares of unequal sizes, in batches.
          const size_t first = samples.size() * t * t / (threads * threads);
          const size_t last = samples.size() * (t + 1) * (t + 1) / (threads * threads);
          for (size_t i = first; i < last; i += 100) {
            record(forks[t], samples, i, std::min(i + 100, last));
          }
        });
      }
      for (std::thread& worker : workers) worker.join();
      for (size_t t = threads; t-- > 0;) {
        must(awdJoinDensity(density, forks[t]));
        EXPECT_EQ(infoOf(forks[t]).samples, 0u);
      }
      expectSame(Outcome(density), expected);
      // Forks follow: they take over the new density and are of use for the next pass.
      must(awdJoinDensity(density, forks[0]));
      EXPECT_TRUE(sameBits(saved(forks[0]), saved(density)));
    }
  });
}

/// Each of three machines has a share; the statistics go around as bytes.
TEST_F(Statistics, MachinesDoNotMatter) {
  forEach([&](const Case& c) {
    const Outcome expected = whole(c);
    std::vector<Bytes> parts;
    for (size_t part = 0; part < 3; ++part) {
      const Density density = trained(c);
      const Samples samples = next(density);
      record(density, samples, part * kSamples / 3, (part + 1) * kSamples / 3);
      parts.push_back(statisticsOf(density));
    }
    // The first by import, which forgets what was there, the others added in any order.
    for (const bool reversed : {false, true}) {
      const Density density = trained(c);
      record(density, next(density), 5, 50);
      if (reversed) std::reverse(parts.begin(), parts.end());
      must(awdImportDensityStatistics(density, parts[0].data(), parts[0].size()));
      EXPECT_EQ(infoOf(density).samples, kSamples / 3);
      for (size_t part = 1; part < 3; ++part) {
        must(awdAddDensityStatistics(density, parts[part].data(), parts[part].size()));
      }
      expectSame(Outcome(density), expected);
    }
    // Added to what was recorded here.
    const Density density = trained(c);
    const Samples samples = next(density);
    std::reverse(parts.begin(), parts.end());
    record(density, samples, 0, kSamples / 3);
    for (size_t part = 1; part < 3; ++part) {
      must(awdAddDensityStatistics(density, parts[part].data(), parts[part].size()));
    }
    expectSame(Outcome(density), expected);
  });
}

TEST_F(Statistics, OthersAreRefused) {
  const Axes axes(2, axisFrom("m2", 1, 4));
  AWDDensityDesc rms = gridDesc(), paper = gridDesc();
  rms.target = AWD_TARGET_RMS;
  paper.estimator = AWD_ESTIMATOR_PAPER;
  const Density density = newDensity(device_, axes), finer = newDensity(device_, axes);
  must(awdRefineDensity(finer, 1));
  const Density tree = newDensity(device_, axes, treeDesc());
  const Density others[] = {newDensity(device_, Axes(2, axisFrom("f2", 1, 4))),
                            newDensity(device_, Axes(1, axisFrom("m2", 1, 4))),
                            newDensity(device_, Axes(2, axisFrom("m2", 2, 4))),
                            newDensity(device_, axes, rms),
                            newDensity(device_, axes, paper),
                            newDensity(device_, axes, treeDesc()),
                            loaded(device_, saved(finer))};
  Random random(33);
  record(density, draw(density, 100, random, wild));
  const Bytes before = saved(density);
  for (const Density& other : others) {
    const Bytes bytes = statisticsOf(other);
    for (const auto call : {awdAddDensityStatistics, awdImportDensityStatistics}) {
      expectFailure(call(density, bytes.data(), bytes.size()), AWD_ERROR_INVALID_ARGUMENT,
                    {"bytes", "other"});
    }
  }
  // Other boxes.
  const Density halved = newDensity(device_, axes, treeDesc());
  must(awdRefineDensity(halved, 0));
  const Bytes boxes = statisticsOf(halved);
  expectFailure(awdAddDensityStatistics(tree, boxes.data(), boxes.size()),
                AWD_ERROR_INVALID_ARGUMENT, {"boxes"});
  // A saved density is no statistics, and the other way round.
  expectFailure(awdAddDensityStatistics(density, before.data(), before.size()), AWD_ERROR_IO,
                {"statistics"});
  const Bytes own = statisticsOf(density);
  AWDDensity none;
  expectFailure(awdLoadDensity(device_, own.data(), own.size(), &none), AWD_ERROR_IO, {"saved"});
  EXPECT_TRUE(sameBits(saved(density), before));

  // What estimates and floors are taken does not matter.
  AWDDensityDesc ratio = gridDesc();
  ratio.estimator = AWD_ESTIMATOR_RATIO;
  ratio.tau = 0.2;
  const Density like = newDensity(device_, axes, ratio);
  must(awdAddDensityStatistics(like, own.data(), own.size()));
  EXPECT_EQ(infoOf(like).samples, 100u);
}

TEST_F(Statistics, ForksOfAnotherPass) {
  forEach([&](const Case& c) {
    const Density density = trained(c), early = forkOf(density), empty = forkOf(density);
    const Samples samples = next(density);
    record(early, samples);
    const Bytes held = saved(early);
    record(density, samples);
    adapt(density);
    const Bytes before = saved(density);
    expectFailure(awdJoinDensity(density, early), AWD_ERROR_INVALID_OPERATION,
                  {"fork", std::to_string(kSamples), "another p"});
    EXPECT_TRUE(sameBits(saved(density), before));
    EXPECT_TRUE(sameBits(saved(early), held)) << "its samples are not lost";
    // Even when the adapt kept p; but a fork without samples just takes over.
    adapt(density);
    expectFailure(awdJoinDensity(density, early), AWD_ERROR_INVALID_OPERATION, {"fork"});
    must(awdJoinDensity(density, empty));
    EXPECT_TRUE(sameBits(saved(empty), saved(density)));
    // Forks of one pass may join each other.
    const Density one = forkOf(density), two = forkOf(density);
    Random random(34);
    const Samples more = draw(density, 100, random, wild);
    record(one, more, 0, 40);
    record(two, more, 40, 100);
    must(awdJoinDensity(one, two));
    must(awdJoinDensity(density, one));
    EXPECT_EQ(infoOf(density).samples, 100u);
    expectFailure(awdJoinDensity(density, density), AWD_ERROR_INVALID_ARGUMENT, {"fork"});
  });
}

/// A pass holds 2^30 - 1 samples: statistics that claim more can't be added up.
/// As many adapts, and the same p, since the first learned from a zero alone; but one of them has a
/// pass more to be weighed against.
TEST_F(Statistics, ForksOfOtherPasses) {
  AWDDensityDesc desc = gridDesc();
  desc.combination = AWD_COMBINE_CROSS_VARIANCE;
  const Density density = newDensity(device_, {AWDDensityAxis{}}, desc);
  const Density fork = forkOf(density);
  const double x = 0.5, zero = 0.0, one = 1.0;
  must(awdRecordDensity(density, 1, &x, nullptr, nullptr, &zero));
  adapt(density);
  adapt(fork);
  must(awdRecordDensity(fork, 1, &x, nullptr, nullptr, &one));
  expectFailure(awdJoinDensity(density, fork), AWD_ERROR_INVALID_OPERATION, {"fork", "another p"});
  EXPECT_EQ(infoOf(fork).samples, 1u);
}

/// Two trees whose boxes were halved along the same axes, but not at the same places.
TEST_F(Statistics, OfOtherBoxesAreRefused) {
  const auto treeOf = [this](const std::function<double(double)>& place) {
    AWDDensityDesc desc = treeDesc();
    desc.maxCoefficients = 5;
    Density density = newDensity(device_, {axisFrom("haar", 1, 10)}, desc);
    Random random(35);
    pass(density, 20000, random, [&](const double* x) {
      const double y = place(x[0]);
      return y < 0.125 ? 14.0 : y < 0.25 ? 10.0 : y < 0.5 ? 1.0 : y < 0.75 ? 9.0 : 1.0;
    });
    return density;
  };
  const Density one = treeOf([](double x) { return x; });
  const Density other = treeOf([](double x) { return x < 0.5 ? x + 0.5 : x - 0.5; });
  ASSERT_EQ(infoOf(one).coefficients, infoOf(other).coefficients);
  ASSERT_NE(leavesOf(one), leavesOf(other));
  Random random(36);
  const Samples samples = draw(other, 10, random, [](const double* x) { return x[0]; });
  record(other, samples);
  const Bytes bytes = statisticsOf(other);
  expectFailure(awdAddDensityStatistics(one, bytes.data(), bytes.size()),
                AWD_ERROR_INVALID_ARGUMENT, {"boxes"});
}

TEST_F(Statistics, AtMostSoManySamples) {
  const Density density = newDensity(device_, {fixedAxis("haar", 0)});
  const double x = 0.5, p = 1.0, f = 1.0;
  must(awdRecordDensity(density, 1, &x, &p, nullptr, &f));
  for (uint64_t samples = 1; 2 * samples < (uint64_t{1} << 30); samples *= 2) {
    const Bytes bytes = statisticsOf(density);
    must(awdAddDensityStatistics(density, bytes.data(), bytes.size()));
  }
  EXPECT_EQ(infoOf(density).samples, uint64_t{1} << 29);
  const Bytes bytes = statisticsOf(density);
  expectFailure(awdAddDensityStatistics(density, bytes.data(), bytes.size()),
                AWD_ERROR_INVALID_OPERATION, {"536870912 samples on top", "1073741823", "adapt"});
  const Density fork = forkOf(density);
  must(awdImportDensityStatistics(fork, bytes.data(), bytes.size()));
  expectFailure(awdJoinDensity(density, fork), AWD_ERROR_INVALID_OPERATION, {"adapt"});
  EXPECT_EQ(infoOf(fork).samples, uint64_t{1} << 29);
  // All of them are as they should be.
  const AWDDensityEstimate estimate = estimateOf(density);
  EXPECT_EQ(estimate.samples, uint64_t{1} << 29);
  EXPECT_EQ(estimate.integral, 1.0);
  EXPECT_EQ(estimate.standardError, 0.0);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
#include "density/square_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

struct Record {
  float u, v;
  double p, f;
};

/// Points anywhere, the corners among them, densities of six decades and values of nine.
std::vector<Record> someRecords(std::size_t count, uint64_t seed) {
  Uniforms random(seed);
  std::vector<Record> records = {{0.0f, 1.0f, 1.0, 1.0}, {1.0f, 0.0f, 2.0, 0.0}};
  while (records.size() < count) {
    records.push_back({static_cast<float>(random()), static_cast<float>(random()),
                       std::pow(10.0, 6.0 * random() - 3.0), std::pow(10.0, 9.0 * random() - 7.0)});
  }
  return records;
}

/// A level of a family, and sums on it.
class Sums {
 public:
  explicit Sums(const char* name, uint32_t level = 2, bool products = true)
      : family_(family(name, level)), level_(family_.level(level)) {
    const BasisLevel* const levels[] = {&level_, &level_};
    if (products) pattern_ = NormalPattern::make(memory(), levels, 2);
  }
  const BasisLevel& level() const { return level_; }
  const NormalPattern& pattern() const { return *pattern_; }
  Owned<SquareSums> make(double magnitude = 1.0) const {
    return makeOwned<SquareSums>(memory(), memory(), level_, pattern_,
                                 SquareSums::unitExponentFor(magnitude));
  }
  Owned<SquareSums> of(const std::vector<Record>& records) const {
    Owned<SquareSums> sums = make();
    for (const Record& r : records) sums->record(r.u, r.v, r.p, r.f);
    return sums;
  }

 private:
  Family family_;
  const BasisLevel& level_;
  Ref<NormalPattern> pattern_;
};

/// Every number that the sums hold.
std::vector<long double> numbersOf(const SquareSums& sums) {
  const DensityStatistics all = sums.statistics();
  std::vector<long double> numbers = {
      static_cast<long double>(all.sums.samples), static_cast<long double>(all.sums.rejected),
      static_cast<long double>(sums.saturated()), static_cast<long double>(sums.largest())};
  for (const Tally& tally : all.tallies) {
    numbers.insert(numbers.end(), {tally.value.value(), tally.weight.value(), tally.count()});
  }
  numbers.push_back(all.normal.energy.value());
  for (const BinnedSum& product : all.normal.products) numbers.push_back(product.value());
  return numbers;
}

// A sample is rounded by half a unit of 2^-32 at most, of S1, S0 and A alike for the magnitude 1,
// and by one of 2^-30 in its count.
TEST(SquareSums, AgreesWithSumsInLongDouble) {
  const std::vector<Record> records = someRecords(3000, 21);
  const long double tolerance = 0x1p-33L * static_cast<long double>(records.size());
  for (const char* name : kShipped) {
    SCOPED_TRACE(name);
    const Sums on(name);
    const std::size_t n = std::size_t{on.level().count} * on.level().count;
    std::vector<long double> value(n), weight(n), alive(n), products(n * n);
    long double energy = 0.0L;
    for (const Record& r : records) {
      AxisValues u, v;
      evaluateAxis(on.level(), static_cast<double>(r.u), u);
      evaluateAxis(on.level(), static_cast<double>(r.v), v);
      std::vector<long double> all(n);
      for (uint32_t a = 0; a < u.count; ++a) {
        for (uint32_t b = 0; b < v.count; ++b) {
          all[std::size_t{u.function[a]} * on.level().count + v.function[b]] +=
              static_cast<long double>(u.value[a]) * v.value[b];
        }
      }
      energy += static_cast<long double>(r.f) * r.f / r.p;
      for (std::size_t j = 0; j < n; ++j) {
        value[j] += r.f * all[j] / r.p;
        weight[j] += all[j] / r.p;
        alive[j] += all[j];
        for (std::size_t k = 0; all[j] > 0.0L && k < n; ++k) {
          products[j * n + k] += all[j] * all[k] / r.p;
        }
      }
    }
    const Owned<SquareSums> sums = on.of(records);
    EXPECT_EQ(sums->samples(), records.size());
    EXPECT_EQ(sums->rejected(), 0u);
    EXPECT_EQ(sums->saturated(), 0u);
    const DensityStatistics found = sums->statistics();
    EXPECT_EQ(found.sums.samples, records.size());
    ASSERT_EQ(found.tallies.size(), n);
    long double total = 0.0L;
    for (std::size_t j = 0; j < n; ++j) {
      EXPECT_LE(std::abs(found.tallies[j].value.value() - value[j]), tolerance);
      EXPECT_LE(std::abs(found.tallies[j].weight.value() - weight[j]), tolerance);
      EXPECT_LE(std::abs(found.tallies[j].count() - alive[j]), 8 * tolerance);
      total += value[j];
    }
    EXPECT_LE(std::abs(sums->total() - total), tolerance * static_cast<long double>(n));
    EXPECT_LE(std::abs(found.normal.energy.value() / energy - 1.0L), 1e-10L);
    ASSERT_EQ(found.normal.products.size(), on.pattern().size());
    // The diagonal has half a unit more for each pair of functions and sample.
    const long double ridge = tolerance * (std::pow(on.level().alive, 4.0L) + 1.0L);
    on.pattern().forEachPair([&](std::size_t entry, std::size_t j, std::size_t k, bool) {
      const long double more = found.normal.products[entry].value() - products[j * n + k];
      ASSERT_GE(more, -tolerance);
      ASSERT_LE(more, j == k ? ridge : tolerance);
    });
  }
}

TEST(SquareSums, OrderAndThreadsChangeNoBit) {
  const std::vector<Record> records = someRecords(6000, 22);
  const Sums on("quadratic-bspline");
  const std::vector<long double> once = numbersOf(*on.of(records));
  const Owned<SquareSums> threaded = on.make();
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = records.size(); i-- > 0;) {
        const Record& r = records[i];
        if (i % 4 == t) threaded->record(r.u, r.v, r.p, r.f);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(numbersOf(*threaded), once);
  const std::ptrdiff_t half = 2500;
  const Owned<SquareSums> sum = on.of({records.begin(), records.begin() + half});
  sum->add(*on.of({records.begin() + half, records.end()}));
  EXPECT_EQ(numbersOf(*sum), once);
  sum->clear();
  EXPECT_EQ(numbersOf(*sum), numbersOf(*on.make()));
}

/// However the functions share a sample, it counts as one.
TEST(SquareSums, CountsEverySample) {
  for (const char* name : kShipped) {
    const Owned<SquareSums> sums = Sums(name, 3, false).of(someRecords(20000, 23));
    EXPECT_EQ(sums->samples(), 20000u) << name;
  }
}

TEST(SquareSums, HoldsNoProductsUnlessAsked) {
  EXPECT_TRUE(Sums("m2", 2, false).make()->statistics().normal.products.empty());
  EXPECT_LT(Sums("m2", 2, false).make()->bytes(), Sums("m2", 2, true).make()->bytes());
}

/// sum_jk c_j A_jk c_k >= 0, also of a few samples that few functions share, with rare ones and
/// with far-off weights among them.
TEST(SquareSums, ProductsStayPositiveDefinite) {
  for (const char* name : kShipped) {
    SCOPED_TRACE(name);
    const Sums on(name);
    const std::size_t n = std::size_t{on.level().count} * on.level().count;
    for (uint64_t seed = 50; seed < 60; ++seed) {
      const DensityStatistics found = on.of(someRecords(seed % 5 + 1, seed))->statistics();
      std::vector<long double> rest(n * n);
      on.pattern().forEachPair([&](std::size_t entry, std::size_t j, std::size_t k, bool) {
        rest[j * n + k] = rest[k * n + j] = found.normal.products[entry].value();
      });
      for (std::size_t j = 0; j < n; ++j) {  // Cholesky: no pivot below 0 but for rounding
        const long double pivot = rest[j * n + j];
        ASSERT_GE(pivot, 0.0L) << "seed " << seed;
        if (pivot == 0.0L) continue;
        for (std::size_t r = j + 1; r < n; ++r) {
          const long double factor = rest[r * n + j] / pivot;
          for (std::size_t c = r; c < n; ++c) {
            rest[r * n + c] -= factor * rest[j * n + c];
            rest[c * n + r] = rest[r * n + c];
          }
        }
      }
    }
  }
}

TEST(SquareSums, RejectsWhatIsNoRadiance) {
  const Sums on("haar", 0);
  const Owned<SquareSums> sums = on.make();
  for (const double f : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0, 2.0}) {
    sums->record(0.5f, 0.5f, 0.5, f);
  }
  EXPECT_EQ(sums->rejected(), 4u);
  EXPECT_EQ(sums->samples(), 5u);  // they stay, as zeros
  const DensityStatistics all = sums->statistics();
  EXPECT_EQ(all.sums.rejected, 4u);
  EXPECT_EQ(all.tallies[0].value.value(), 4.0L);
  EXPECT_EQ(all.tallies[0].weight.value(), 10.0L);
  EXPECT_EQ(all.normal.products[0].value(), 10.0L + 5 * 0x1p-32L);
}

TEST(SquareSums, KeepsNineDigitsAtAnyMagnitude) {
  const Sums on("haar", 0);
  for (const double magnitude : {1e-300, 1e-30, 1e30, 1e300}) {
    const Owned<SquareSums> sums = on.make(magnitude);
    for (int i = 0; i < 1000; ++i) sums->record(0.5f, 0.5f, 0.5, magnitude);
    EXPECT_NEAR(sums->total() / magnitude, 2000.0, 2e-6) << magnitude;
    const double m = std::ldexp(magnitude, -std::ilogb(magnitude));
    const BinnedSum energy = sums->statistics().normal.energy;
    EXPECT_NEAR(energy.plain(2 * std::ilogb(magnitude)) / (m * m), 2000.0, 2e-6) << magnitude;
    EXPECT_EQ(sums->saturated(), 0u);
    EXPECT_FALSE(sums->overflowed());
  }
}

TEST(SquareSums, ClampsTowersAndSaysSo) {
  const Sums on("haar", 0);
  const auto after = [&](double p, double f) {
    Owned<SquareSums> sums = on.make();
    sums->record(0.5f, 0.5f, p, f);
    return sums;
  };
  const Owned<SquareSums> bright = after(1.0, 1e30);
  EXPECT_EQ(bright->saturated(), 1u);
  EXPECT_EQ(bright->largest(), 1e30);
  EXPECT_EQ(bright->total(), 0x1p20);
  EXPECT_EQ(bright->statistics().tallies[0].weight.value(), 1.0L);
  for (const double p : {0.0, 1e-300, 0x1p-21}) {
    const Owned<SquareSums> rare = after(p, 0x1p-20);
    EXPECT_EQ(rare->saturated(), 1u) << p;
    EXPECT_EQ(rare->samples(), 1u);
    EXPECT_EQ(rare->statistics().tallies[0].weight.value(), 0x1p20L);
    EXPECT_EQ(rare->total(), 1.0);
  }
  EXPECT_EQ(after(0.0, std::numeric_limits<double>::max())->saturated(), 1u) << "counted once";
  EXPECT_EQ(after(0x1p40, 0x1p39)->saturated(), 0u);
  EXPECT_EQ(after(0x1p40, 0x1p41)->saturated(), 1u) << "f^2/p is too large, f/p is not";
  EXPECT_EQ(after(0x1p-20, 1.0)->saturated(), 0u);
  EXPECT_TRUE(std::isfinite(after(0.0, std::numeric_limits<double>::max())->largest()));

  // Past the end of a sum once, and then around it: what has overflowed stays so.
  for (const Record r : {Record{0.5f, 0.5f, 1.0, 1e30}, Record{0.5f, 0.5f, 0.0, 0.0}}) {
    const Owned<SquareSums> sums = on.make();
    for (int i = 0; i < 2000; ++i) sums->record(r.u, r.v, r.p, r.f);
    EXPECT_FALSE(sums->overflowed());
    for (int i = 0; i < 4000; ++i) sums->record(r.u, r.v, r.p, r.f);
    EXPECT_TRUE(sums->overflowed());
    sums->clear();
    EXPECT_FALSE(sums->overflowed());
  }
}

}  // namespace
}  // namespace awd

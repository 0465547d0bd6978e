// SPDX-License-Identifier: Apache-2.0
#include "basis/family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "basis/bernstein.h"
#include "tables.h"

namespace {

using namespace awd;

Family compile(const AWDBasisFamily& table, uint32_t maxLevel) {
  return Family(std::pmr::get_default_resource(), table, maxLevel);
}

/// N_j(x) from the tables.
double valueOf(const BasisLevel& level, uint32_t j, double x) {
  const uint32_t cell = std::min(static_cast<uint32_t>(x * level.cells), level.cells - 1);
  double sum = 0.0;
  for (uint32_t a = 0; a < level.alive; ++a) {
    const std::size_t row = std::size_t{cell} * level.alive + a;
    if (level.functions[row] != j) continue;
    sum += bernsteinValue(&level.pieces[row * level.order], level.order, x * level.cells - cell);
  }
  return sum;
}

class EveryFamily : public testing::TestWithParam<const AWDBasisFamily* (*)()> {
 protected:
  const AWDBasisFamily& table() const { return *GetParam()(); }
};

TEST_P(EveryFamily, TablesSayWhatThePluginSays) {
  const Family family = compile(table(), 6);
  EXPECT_EQ(family.name(), table().name);
  EXPECT_EQ(family.minLevel(), 0u);
  EXPECT_EQ(family.maxLevel(), 6u);
  for (uint32_t l = 0; l <= 6; ++l) {
    const BasisLevel& level = family.level(l);
    EXPECT_EQ(level.level, l);
    ASSERT_EQ(level.count, table().count(l));
    ASSERT_EQ(level.cells, table().cells(l));
    ASSERT_EQ(level.order, table().order);
    ASSERT_EQ(level.functions.size(), std::size_t{level.cells} * level.alive);
    ASSERT_EQ(level.pieces.size(), level.functions.size() * level.order);
    for (double b : level.pieces) EXPECT_GE(b, 0.0);
    for (int i = 0; i <= 100; ++i) {
      const double x = i / 100.0;
      std::vector<double> want(level.count, 0.0);
      uint32_t first = 0;
      double values[kMaxOrder];
      const uint32_t size = table().eval(l, x, &first, values);
      for (uint32_t k = 0; k < size; ++k) want[(first + k) % level.count] += values[k];
      for (uint32_t j = 0; j < level.count; ++j) {
        EXPECT_NEAR(valueOf(level, j, x), want[j], 1e-14) << l << " " << j << " " << x;
      }
    }
  }
}

TEST_P(EveryFamily, WeightsAreTheMassOfThePieces) {
  const Family family = compile(table(), 5);
  for (uint32_t l = 0; l <= 5; ++l) {
    const BasisLevel& level = family.level(l);
    ASSERT_EQ(level.weights.size(), level.count);
    EXPECT_NEAR(std::accumulate(level.weights.begin(), level.weights.end(), 0.0), 1.0, 1e-14);
    ASSERT_EQ(level.componentBegin.size(), level.count + 1u);
    for (uint32_t j = 0; j < level.count; ++j) {
      double mass = 0.0, before = 0.0;
      std::vector<double> masses;
      for (uint32_t i = level.componentBegin[j]; i < level.componentBegin[j + 1]; ++i) {
        const BasisLevel::Piece& piece = level.componentPieces[i];
        const std::size_t row = std::size_t{piece.cell} * level.alive + piece.row;
        EXPECT_EQ(level.functions[row], j);
        const double* b = &level.pieces[row * level.order];
        masses.push_back(std::accumulate(b, b + level.order, 0.0) / level.order / level.cells);
        mass += masses.back();
        if (i > level.componentBegin[j]) {
          EXPECT_GT(piece.cell, level.componentPieces[i - 1].cell);
        }
      }
      EXPECT_NEAR(mass, level.weights[j], 1e-15);
      for (std::size_t i = 0; i < masses.size(); ++i) {
        const double cumulative = level.componentPieces[level.componentBegin[j] + i].cumulative;
        EXPECT_NEAR(cumulative - before, masses[i] / mass, 1e-15);
        before = cumulative;
      }
      EXPECT_EQ(before, 1.0) << "exactly";
    }
  }
}

TEST_P(EveryFamily, TwoScaleRowsRefineExactly) {
  const Family family = compile(table(), 5);
  for (uint32_t l = 0; l < 5; ++l) {
    const BasisLevel& level = family.level(l);
    const BasisLevel& finer = family.level(l + 1);
    ASSERT_EQ(level.twoScaleBegin.size(), level.count + 1u);
    for (uint32_t j = 0; j < level.count; ++j) {
      double mass = 0.0;
      for (uint32_t k = level.twoScaleBegin[j]; k < level.twoScaleBegin[j + 1]; ++k) {
        EXPECT_GT(level.twoScale[k].value, 0.0);
        mass += level.twoScale[k].value * finer.weights[level.twoScale[k].fine];
      }
      EXPECT_NEAR(mass, level.weights[j], 1e-15);
      for (double x : {0.0, 0.11, 0.25, 0.49, 0.73, 0.97}) {
        double sum = 0.0;
        for (uint32_t k = level.twoScaleBegin[j]; k < level.twoScaleBegin[j + 1]; ++k) {
          sum += level.twoScale[k].value * valueOf(finer, level.twoScale[k].fine, x);
        }
        EXPECT_NEAR(sum, valueOf(level, j, x), 1e-14) << l << " " << j << " " << x;
      }
    }
  }
  EXPECT_TRUE(family.level(5).twoScaleBegin.empty());
  EXPECT_TRUE(family.level(5).twoScale.empty());
}

std::string nameOf(const testing::TestParamInfo<const AWDBasisFamily* (*)()>& family) {
  std::string name = family.param()->name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily,
                         testing::Values(
                             +[] { return &test::haar(); }, +[] { return &test::linear(); },
                             +[] { return &test::linearPeriodic(); },
                             +[] { return &test::quadratic(); }),
                         nameOf);

TEST(Family, HaarIsExact) {
  const Family family = compile(test::haar(), 8);
  const BasisLevel& level = family.level(8);
  EXPECT_EQ(level.alive, 1u);
  for (uint32_t c = 0; c < 256; ++c) {
    EXPECT_EQ(level.functions[c], c);
    EXPECT_EQ(level.pieces[c], 1.0);
    EXPECT_EQ(level.weights[c], 1.0 / 256);
    EXPECT_EQ(level.componentPieces[c].cell, c);
  }
}

TEST(Family, FlagsAndSplit) {
  const Family haar = compile(test::haar(), 2), around = compile(test::linearPeriodic(), 0);
  EXPECT_TRUE(haar.nested() && haar.orthogonal() && !haar.periodic());
  EXPECT_TRUE(around.periodic() && !around.nested() && !around.orthogonal());
  EXPECT_EQ(around.order(), 2u);
  EXPECT_EQ(around.split().size, 0u);
  EXPECT_TRUE(around.split().functions.empty() && around.split().wavelets.empty());
  EXPECT_EQ(haar.split().size, 1u);
  EXPECT_EQ(haar.split().functions, (std::pmr::vector<double>{1.0, 1.0}));
  EXPECT_EQ(haar.split().wavelets, (std::pmr::vector<double>{1.0, -1.0}));
  EXPECT_EQ(haar.split().vanishingMoments, 1u);

  AWDBasisFamily without = test::haar();
  without.wavelet = nullptr;
  const Family found = compile(without, 0);  // no level 1 among its tables
  ASSERT_EQ(found.split().wavelets.size(), 2u);
  EXPECT_NEAR(std::abs(found.split().wavelets[0]), 1.0, 1e-15);
  EXPECT_NEAR(found.split().wavelets[0] + found.split().wavelets[1], 0.0, 1e-15);
}

TEST(Family, PeriodicRepeatsAreOneFunction) {
  const Family family = compile(test::linearPeriodic(), 1);
  const BasisLevel& zero = family.level(0);
  EXPECT_EQ(zero.alive, 1u);
  EXPECT_EQ(zero.pieces[0], 1.0);
  EXPECT_EQ(zero.pieces[1], 1.0);
  const BasisLevel& one = family.level(1);
  EXPECT_EQ(one.alive, 2u);
  EXPECT_EQ(one.componentBegin[1], 2u);
  EXPECT_EQ(zero.twoScale.size(), 2u);
}

TEST(Family, RowsBeyondTheFunctionsAliveAreZero) {
  // One function on the first of two cells, two on the second.
  AWDBasisFamily table = test::linear();
  table.minLevel = table.maxLevel = 1;
  table.eval = [](uint32_t, double x, uint32_t* first, double* values) {
    *first = x < 0.5 ? 0u : 1u;
    values[0] = x < 0.5 ? 1.0 : 2.0 - 2.0 * x;
    values[1] = 2.0 * x - 1.0;
    return x < 0.5 ? 1u : 2u;
  };
  table.weight = [](uint32_t, uint32_t j) { return j == 0 ? 0.5 : 0.25; };
  const Family family = compile(table, 20);
  EXPECT_EQ(family.minLevel(), 1u);
  EXPECT_EQ(family.maxLevel(), 1u);
  const BasisLevel& level = family.level(1);
  ASSERT_EQ(level.alive, 2u);
  EXPECT_EQ(level.functions[0], 0u);
  EXPECT_EQ(level.functions[1], 0u);
  EXPECT_EQ(level.pieces[2], 0.0);
  EXPECT_EQ(level.pieces[3], 0.0);
  EXPECT_EQ(level.componentBegin[1], 1u);
}

TEST(Family, LevelsAreClippedToThoseOfTheTable) {
  EXPECT_EQ(compile(test::quadratic(), 20).maxLevel(), 12u);
}

TEST(Family, MemoryIsTheResourcesAndComesBack) {
  struct Counting : std::pmr::memory_resource {
    std::size_t bytes = 0, calls = 0;
    void* do_allocate(std::size_t size, std::size_t alignment) override {
      bytes += size;
      ++calls;
      return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* ptr, std::size_t size, std::size_t alignment) override {
      bytes -= size;
      std::pmr::new_delete_resource()->deallocate(ptr, size, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override {
      return this == &other;
    }
  } memory;
  {
    const Family family(&memory, test::quadratic(), 8), nested(&memory, test::haar(), 3);
    EXPECT_GT(memory.bytes, family.level(8).pieces.size() * sizeof(double));
  }
  EXPECT_GT(memory.calls, 0u);
  EXPECT_EQ(memory.bytes, 0u);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
#include "basis/cell.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tables.h"
#include "util/error.h"

namespace {

using namespace awd;

std::string errorOf(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_PLUGIN_SELF_TEST);
    return error.what();
  }
  return "";
}

TEST(Cell, EvaluateAddsRepeatsOfAPeriodicFamily) {
  const TableLevel zero(test::linearPeriodic(), 0), one(test::linearPeriodic(), 1);
  const Row<kMaxOrder> whole = evaluate(zero, 0.3);
  ASSERT_EQ(whole.size, 1u);
  EXPECT_EQ(whole.of(0), 1.0);
  const Row<kMaxOrder> wrapped = evaluate(one, 0.875);
  ASSERT_EQ(wrapped.size, 2u);
  EXPECT_EQ(wrapped.of(1), 0.25);
  EXPECT_EQ(wrapped.of(0), 0.75);
  EXPECT_EQ(wrapped.of(7), 0.0);
}

TEST(Cell, RefineAddsRepeats) {
  const TableLevel zero(test::linearPeriodic(), 0), one(test::linearPeriodic(), 1);
  const Row<2 * kMaxOrder> row = refine(zero, one, 0);  // 1/2 1 1/2 on two functions
  ASSERT_EQ(row.size, 2u);
  EXPECT_EQ(row.of(0), 1.0);
  EXPECT_EQ(row.of(1), 1.0);
}

TEST(Cell, WhatIsOutOfRangeThrows) {
  AWDBasisFamily table = test::linear();
  table.eval = [](uint32_t, double, uint32_t* first, double* values) {
    *first = 9;
    values[0] = 1.0;
    return 1u;
  };
  const TableLevel level(table, 2);
  EXPECT_EQ(errorOf([&] { evaluate(level, 0.5); }),
            "eval: first index 9, but level 2 has 5 functions");
  table.eval = [](uint32_t, double, uint32_t* first, double* values) {
    *first = 4;
    values[0] = values[1] = 0.5;
    return 2u;
  };
  EXPECT_EQ(errorOf([&] { evaluate(level, 0.5); }), "eval: functions 4 to 5, but level 2 has 5");
  table.eval = [](uint32_t, double, uint32_t* first, double*) {
    *first = 0;
    return 0u;
  };
  EXPECT_EQ(errorOf([&] { evaluate(level, 0.5); }),
            "eval: level 2, x = 0.5: gives 0 values, but 1 to 8 can be alive");
  table.eval = [](uint32_t, double, uint32_t* first, double* values) {
    *first = 0;
    for (int i = 0; i < 30; ++i) values[i] = 0.0;  // and does not say so
    return 1u;
  };
  EXPECT_EQ(errorOf([&] { evaluate(level, 0.5); }),
            "eval: level 2, x = 0.5: gives 1 values, but 1 to 8 can be alive");
  table.twoScale = [](uint32_t, uint32_t, uint32_t* first, double*) {
    *first = 0;
    return 17u;
  };
  EXPECT_EQ(errorOf([&] { refine(level, TableLevel(table, 3), 1); }),
            "twoScale: level 2, function 1: gives 17 values, but it may be 1 to 16");
}

TEST(Cell, WaveletsStayWithinTheirRow) {
  AWDBasisFamily table = test::haar();
  double g[2 * kMaxOrder];
  readWavelet(table, 0, 2, g);
  EXPECT_EQ(g[0], 1.0);
  EXPECT_EQ(g[1], -1.0);
  table.wavelet = [](uint32_t, double* row) { row[0] = row[1] = row[2] = 0.5; };
  EXPECT_EQ(errorOf([&] { readWavelet(table, 0, 2, g); }),
            "wavelet 0: writes more than the 2 coefficients of level 1");
  table.wavelet = [](uint32_t, double* row) { row[0] = 0.5; };
  EXPECT_EQ(errorOf([&] { readWavelet(table, 0, 2, g); }).substr(0, 41),
            "wavelet 0: coefficient 1 is not finite: g");
}

TEST(Cell, FitGivesBernsteinCoefficients) {
  const TableLevel level(test::quadratic(), 2);
  const CellPieces cell = fitCell(level, 1, BernsteinFit(3));
  ASSERT_EQ(cell.size, 3u);
  // (1-t)^2/2 | 1/2 + t - t^2 | t^2/2
  const double want[3][3] = {{0.5, 0.0, 0.0}, {0.5, 1.0, 0.5}, {0.0, 0.0, 0.5}};
  for (uint32_t a = 0; a < 3; ++a) {
    ASSERT_NE(cell.of(1 + a), nullptr);
    for (uint32_t k = 0; k < 3; ++k) EXPECT_NEAR(cell.of(1 + a)[k], want[a][k], 1e-15);
  }
  EXPECT_EQ(cell.of(0), nullptr);
}

}  // namespace

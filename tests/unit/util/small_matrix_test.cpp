// SPDX-License-Identifier: Apache-2.0
#include "util/small_matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace {

using namespace awd;

SmallMatrix matrix(std::initializer_list<std::initializer_list<long double>> rows) {
  SmallMatrix result(static_cast<uint32_t>(rows.size()),
                     static_cast<uint32_t>(rows.begin()->size()));
  uint32_t i = 0;
  for (const auto& row : rows) {
    uint32_t j = 0;
    for (const long double value : row) result.at(i, j++) = value;
    ++i;
  }
  return result;
}

void expectEqual(const SmallMatrix& a, const SmallMatrix& b, double error) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.columns(), b.columns());
  for (uint32_t i = 0; i < a.rows(); ++i) {
    for (uint32_t j = 0; j < a.columns(); ++j) {
      EXPECT_NEAR(static_cast<double>(a.at(i, j) - b.at(i, j)), 0.0, error) << i << " " << j;
    }
  }
}

TEST(SmallMatrix, ProductAndTranspose) {
  const SmallMatrix a = matrix({{1, 2, 3}, {4, 5, 6}}), b = matrix({{1, 0}, {-1, 2}, {0, 5}});
  expectEqual(a * b, matrix({{-1, 19}, {-1, 40}}), 0.0);
  expectEqual(transposed(a), matrix({{1, 4}, {2, 5}, {3, 6}}), 0.0);
}

TEST(SmallMatrix, InverseOfHilberts) {
  SmallMatrix a(6, 6), unit(6, 6);
  for (uint32_t i = 0; i < 6; ++i) {
    for (uint32_t j = 0; j < 6; ++j) a.at(i, j) = 1.0L / (i + j + 1);
    unit.at(i, i) = 1.0L;
  }
  SmallMatrix inverse = a;
  ASSERT_TRUE(invert(inverse));
  expectEqual(a * inverse, unit, 1e-11);
  EXPECT_NEAR(static_cast<double>(inverse.at(0, 0)), 36.0, 1e-9);
  SmallMatrix swapped = matrix({{0, 1}, {2, 0}});
  ASSERT_TRUE(invert(swapped));
  expectEqual(swapped, matrix({{0, 0.5L}, {1, 0}}), 0.0);
}

TEST(SmallMatrix, SingularOnesHaveNoInverse) {
  SmallMatrix singular = matrix({{1, 2}, {2, 4}}), notFinite = matrix({{NAN, 0}, {0, 1}});
  EXPECT_FALSE(invert(singular));
  EXPECT_FALSE(invert(notFinite));
}

TEST(SmallMatrix, OrthonormalRowsLeaveOutWhatIsThere) {
  const SmallMatrix gram = matrix({{2, 1, 0}, {1, 3, 1}, {0, 1, 2}});
  const SmallMatrix rows = matrix({{1, 1, 0}, {2, 2, 0}, {0, 1, 1}, {1, 2, 1}, {0, 0, 1}});
  const SmallMatrix found = orthonormalRows(rows, gram, 1e-12L);
  ASSERT_EQ(found.rows(), 3u) << "the second and the fourth are combinations";
  expectEqual(found * gram * transposed(found), matrix({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 1e-15);
  // The first is the first, scaled.
  EXPECT_NEAR(static_cast<double>(found.at(0, 0)), 1.0 / std::sqrt(7.0), 1e-15);
  EXPECT_NEAR(static_cast<double>(found.at(0, 2)), 0.0, 1e-18);
}

}  // namespace

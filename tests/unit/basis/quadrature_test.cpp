// SPDX-License-Identifier: Apache-2.0
#include "basis/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(GaussRule, IsExactUpToDegree15AndNotBeyond) {
  const awd::GaussRule rule;
  const auto error = [&](int degree) {
    double sum = 0.0;
    for (uint32_t i = 0; i < awd::kMaxOrder; ++i) {
      sum += rule.weights[i] * std::pow(rule.points[i], degree);
    }
    return std::abs(sum * (degree + 1) - 1.0);
  };
  for (int degree = 0; degree <= 15; ++degree) EXPECT_LT(error(degree), 1e-14) << degree;
  EXPECT_GT(error(16), 1e-10);
}

TEST(GaussRule, PointsAscendWithin) {
  const awd::GaussRule rule;
  double before = 0.0;
  for (double point : rule.points) {
    EXPECT_GT(point, before);
    before = point;
  }
  EXPECT_LT(before, 1.0);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
#include "density/settings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "util/error.h"

namespace awd {
namespace {

constexpr uint32_t kOrder = 8;

/// Bernstein polynomials of degree 7 on one cell: as many functions alive as there may be.
AWDBasisFamily septic() {
  AWDBasisFamily family = {};
  family.structSize = sizeof family;
  family.name = "septic";
  family.order = kOrder;
  family.sampleDims = 1;
  family.count = [](uint32_t) { return kOrder; };
  family.cells = [](uint32_t) { return 1u; };
  family.weight = [](uint32_t, uint32_t) { return 1.0 / kOrder; };
  family.eval = [](uint32_t, double x, uint32_t* first, double* values) {
    *first = 0;
    for (uint32_t j = 0; j < kOrder; ++j) {
      values[j] = 1.0;
      for (uint32_t i = 0; i < j; ++i) values[j] *= x * (kOrder - 1 - i) / (i + 1);
      for (uint32_t i = j + 1; i < kOrder; ++i) values[j] *= 1.0 - x;
    }
    return kOrder;
  };
  return family;
}

AWDResult compile(uint32_t dimensions, AWDSampler sampler) {
  const AWDBasisFamily family = septic();
  const AWDBasisFamily* families[kMaxDimensions];
  std::fill_n(families, dimensions, &family);
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = dimensions;
  desc.sampler = sampler;
  desc.maxCoefficients = uint64_t{1} << 20;
  try {
    compileBases(std::pmr::get_default_resource(), settle(desc, families), families);
    return AWD_SUCCESS;
  } catch (const Error& error) {
    return error.code();
  }
}

/// 8^3 rows of coefficients are blended for one point, 8^4 are not.
TEST(Settings, RowsThatOnePointCannotBlendAreRefused) {
  EXPECT_EQ(compile(4, AWD_SAMPLER_INVERSE_CDF), AWD_SUCCESS);
  EXPECT_EQ(compile(5, AWD_SAMPLER_INVERSE_CDF), AWD_ERROR_UNSUPPORTED);
  EXPECT_EQ(compile(5, AWD_SAMPLER_COMPONENT), AWD_SUCCESS);
}

}  // namespace
}  // namespace awd

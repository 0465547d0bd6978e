// SPDX-License-Identifier: Apache-2.0
#include "util/vec.h"

#include <gtest/gtest.h>

#include <limits>

namespace awd {
namespace {

TEST(Vec3, CrossIsOrthogonalAndRightHanded) {
  const Vec3d a = {1, 2, 3}, b = {-2, 0.5, 4};
  const Vec3d c = cross(a, b);
  EXPECT_EQ(dot(a, c), 0.0);
  EXPECT_EQ(dot(b, c), 0.0);
  EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
}

TEST(Vec3, NormalizedHasLengthOne) { EXPECT_DOUBLE_EQ(length(normalized(Vec3d{3, -4, 12})), 1.0); }

TEST(Vec3, KnowsWhatIsNotFinite) {
  EXPECT_TRUE(isFinite(Vec3f{1, 2, 3}));
  EXPECT_FALSE(isFinite(Vec3f{1, std::numeric_limits<float>::infinity(), 3}));
  EXPECT_FALSE(isFinite(Vec3f{1, 2, std::numeric_limits<float>::quiet_NaN()}));
}

TEST(Luminance, OfWhiteIsOne) { EXPECT_FLOAT_EQ(luminance(Rgb{1, 1, 1}), 1.0f); }

}  // namespace
}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// What is returned where there are no exceptions.
#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

TEST(Result, IsAValueOrAnError) {
  awd::Result<awd::Device> device = awd::Device::create();
  ASSERT_TRUE(device);
  EXPECT_TRUE(*device);
  EXPECT_FALSE(device->bases()->empty());

  const awd::Result<awd::Image> none = awd::Image::create(*device, 0, 5);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code(), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(none.error().what()).find("0 x 5"), std::string::npos);

  const awd::Result<void> nothing = awd::Scene().commit();
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code(), AWD_ERROR_INVALID_ARGUMENT);

  const awd::Device moved = *std::move(device);
  EXPECT_TRUE(moved);
}

TEST(Result, EndsTheProgramWhereAnErrorIsIgnored) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(awd::Image::create(awd::Device(), 1, 1).value(), "");
  EXPECT_DEATH(awd::Result<int>(1).error(), "");
}

}  // namespace

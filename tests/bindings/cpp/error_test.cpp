// SPDX-License-Identifier: Apache-2.0
#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

TEST(Error, IsThrownWithCodeAndMessage) {
  const awd::Device device = oneThread();
  try {
    awd::Image::create(device, 0, 5);
    FAIL() << "nothing was thrown";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("0 x 5"), std::string::npos);
    EXPECT_EQ(dynamic_cast<const awd::Error&>(error).code(), AWD_ERROR_INVALID_ARGUMENT);
  }
}

TEST(Error, KeepsItsMessage) {
  const awd::Error first = errorOf([] { return awd::Scene().info(); });
  const awd::Error second = errorOf([] { return awd::Image().info(); });
  EXPECT_NE(std::string(first.what()).find("scene is NULL"), std::string::npos);
  EXPECT_NE(std::string(second.what()).find("image is NULL"), std::string::npos);
}

}  // namespace

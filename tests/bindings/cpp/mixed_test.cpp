// SPDX-License-Identifier: Apache-2.0
// A program of which one part is compiled without exceptions.
#include "bindings/cpp/other_mode.h"
#include "bindings/cpp/room.h"

namespace {

TEST(Mixed, EachPartFailsInItsOwnWay) {
  EXPECT_EQ(awdtest::codeOfWidth(0), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(awdtest::codeOfWidth(1), AWD_SUCCESS);
  EXPECT_THROW(awd::Image::create(awd::Device::create(), 0, 1), awd::Error);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
#include "bindings/cpp/other_mode.h"

#include "awd/awd.hpp"

#ifndef AWD_NO_EXCEPTIONS
#error "this is to be compiled without exceptions"
#endif

int32_t awdtest::codeOfWidth(uint32_t width) {
  const awd::Result<awd::Device> device = awd::Device::create();
  if (!device) return device.error().code();
  const awd::Result<awd::Image> image = awd::Image::create(*device, width, 1);
  return image ? AWD_SUCCESS : image.error().code();
}

// SPDX-License-Identifier: Apache-2.0
// A part of a program that is compiled without exceptions.
#pragma once

#include <cstdint>

namespace awdtest {

/// Code of what awd::Image::create() returns for that width.
int32_t codeOfWidth(uint32_t width);

}  // namespace awdtest

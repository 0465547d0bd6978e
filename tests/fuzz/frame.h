// SPDX-License-Identifier: Apache-2.0
// The frame of saved bytes: eight characters, version, length, checksum. Whoever forges bytes can
// forge these as well.
#pragma once

#include <cstddef>

#include "target.h"

namespace fuzz {

constexpr std::size_t kFrame = 8 + 4 + 8 + 8;

/// Makes the frame of bytes [begin, end) as whole as that of `like`, which begins with its magic
/// and version. False if they are too few.
bool repairFrame(Input& bytes, std::size_t begin, std::size_t end, const Input& like);

}  // namespace fuzz

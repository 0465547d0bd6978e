// SPDX-License-Identifier: Apache-2.0
// What roulette measures paths by: the radiance that a pixel is expected to have.
#pragma once

#include "render/film.h"

namespace awd {

/// The luminance of the film, averaged over 5 x 5 pixels, and nowhere less than a fifth of the
/// image's mean (without its brightest hundredth): after few samples most pixels have not yet met
/// the light that will make most of their radiance. Empty while there are no samples.
std::pmr::vector<float> expectedLuminance(std::pmr::memory_resource* memory, const Film& film);

}  // namespace awd

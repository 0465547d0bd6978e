// SPDX-License-Identifier: Apache-2.0
// What a sample of a pass counts for when passes are combined by inverse variance.
#pragma once

#include "render/film.h"

namespace awd {

/// 1 / v, v the mean over the pixels of the relative variance of one sample,
///   var(x) / (mean^2 + 0.01 (mean of the image)^2),
/// in luminance, of both without the hundredth part of the pixels where they are largest: one
/// number for the whole image, in which the noise of a pixel's own samples weighs nothing, so that
/// the combined image stays unbiased but for terms of the order of 1 / pixels. Of a pass of one
/// sample per pixel neighbours serve in the place of further samples. Of a black pass v is taken
/// for the number of its samples.
double passWeight(std::pmr::memory_resource* memory, const PassFilm& pass, uint64_t samples);

/// The luminance that pixels may be expected to have: that of the film, averaged over 5 x 5 pixels,
/// and nowhere less than a fifth of the image's mean (without its brightest hundredth): after few
/// samples most pixels have not yet met the light that will make most of their radiance. Empty
/// while there are no samples.
std::pmr::vector<float> expectedLuminance(std::pmr::memory_resource* memory, const Film& film);

}  // namespace awd

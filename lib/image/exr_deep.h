// SPDX-License-Identifier: Apache-2.0
// Deep images made flat.
#pragma once

#include <ImathBox.h>
#include <ImfMultiPartInputFile.h>

#include <memory_resource>
#include <string>
#include <vector>

namespace awd {

/// Where the pixels of one channel of a part go: row by row, packed, the size of its data window.
struct ExrPlane {
  std::string name;  // in the file
  int xSampling = 1, ySampling = 1;
  float* pixels = nullptr;
};

inline int widthOf(const Imath::Box2i& window) { return window.max.x - window.min.x + 1; }
inline int heightOf(const Imath::Box2i& window) { return window.max.y - window.min.y + 1; }

/// Reads a deep part, scanlines or tiles, and composites the samples of each pixel from near (small
/// Z) to far with "over", channels being premultiplied by A; without A the nearest sample hides the
/// others. Z and ZBack become those of the nearest sample, and a pixel without samples 0.
/// roomBytes: more samples than that in one row or tile can't be right.
void readDeepPart(Imf::MultiPartInputFile& file, int part, const std::vector<ExrPlane>& planes,
                  double roomBytes, std::pmr::memory_resource* memory);

}  // namespace awd

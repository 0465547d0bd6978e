// SPDX-License-Identifier: Apache-2.0
// All that a render leaves behind, but times: for tests that two ways lead to the same bits.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "support/films.h"

namespace awdtest {

constexpr int kFiguresOfAPass = 8;

struct Outcome {
  Film film;
  std::vector<char> field;        // as it is saved; empty unless the render is adaptive
  std::vector<uint64_t> figures;  // of each pass in turn
};

inline std::vector<char> fieldBytes(AWDRender render) {
  Field field;
  must(awdGetRenderField(render, field.out()));
  if (!field) return {};
  size_t size = 0;
  must(awdSaveField(field, nullptr, 0, &size));
  std::vector<char> bytes(size);
  must(awdSaveField(field, bytes.data(), bytes.size(), &size));
  return bytes;
}

inline Outcome outcomeOf(AWDRender render) {
  Outcome result = {readFilm(render), fieldBytes(render), {}};
  uint32_t passes = 0;
  must(awdGetPassCount(render, &passes));
  for (uint32_t pass = 0; pass < passes; ++pass) {
    AWDPassStatistics s = AWD_PASS_STATISTICS_INIT;
    must(awdGetPassStatistics(render, pass, &s));
    result.figures.insert(result.figures.end(),
                          {s.samplesPerPixel, s.samples, s.rays, s.shadowRays, s.patches,
                           s.coefficients, s.bytes, s.rejectedSamples});
  }
  return result;
}

/// Without printing thousands of bytes when they differ.
inline void expectSameOutcome(const Outcome& a, const Outcome& b) {
  EXPECT_TRUE(a.film.radiance == b.film.radiance);
  EXPECT_TRUE(a.film.variance == b.film.variance);
  EXPECT_EQ(a.film.samplesPerPixel, b.film.samplesPerPixel);
  EXPECT_TRUE(a.field == b.field);
  EXPECT_EQ(a.figures, b.figures);
}

}  // namespace awdtest

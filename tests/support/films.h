// SPDX-License-Identifier: Apache-2.0
// Rendering in one call, and what can be said of the film afterwards.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/handles.h"
#include "support/statistics.h"

namespace awdtest {

/// Radiance and variance of every pixel, three floats each.
struct Film {
  uint32_t width = 0, height = 0;
  uint64_t samplesPerPixel = 0;
  std::vector<float> radiance, variance;
};

inline Film readFilm(AWDRender render) {
  Film film;
  must(awdGetFilmInfo(render, &film.width, &film.height, &film.samplesPerPixel));
  film.radiance.resize(size_t{3} * film.width * film.height);
  film.variance.resize(film.radiance.size());
  must(awdReadFilm(render, AWD_FILM_RADIANCE, film.radiance.data(), 0, 0));
  must(awdReadFilm(render, AWD_FILM_VARIANCE, film.variance.data(), 0, 0));
  return film;
}

inline AWDRenderDesc renderDesc(const AWDCamera& camera, AWDGuide guide, uint64_t seed) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.camera = &camera;
  desc.guide = guide;
  desc.seed = seed;
  return desc;
}

inline Render newRender(AWDScene scene, const AWDRenderDesc& desc, AWDField field = nullptr) {
  Render render;
  must(awdNewRender(scene, field, &desc, render.out()));
  return render;
}

/// Passes of so many samples, with an adapt between every two.
inline void runPasses(AWDRender render, const std::vector<uint32_t>& passes) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = passes.data();
  schedule.passCount = static_cast<uint32_t>(passes.size());
  must(awdRenderPasses(render, &schedule));
}

inline Film renderFilm(AWDScene scene, const AWDRenderDesc& desc,
                       const std::vector<uint32_t>& passes) {
  const Render render = newRender(scene, desc);
  runPasses(render, passes);
  return readFilm(render);
}

/// Mean of a channel over a rectangle of pixels, with the film's own estimate of its error.
inline Estimate blockMean(const Film& film, uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1,
                          size_t channel) {
  double sum = 0.0, variance = 0.0;
  for (uint32_t y = y0; y < y1; ++y) {
    for (uint32_t x = x0; x < x1; ++x) {
      const size_t i = 3 * (size_t{y} * film.width + x) + channel;
      sum += film.radiance[i];
      variance += film.variance[i];
    }
  }
  const double n = double(x1 - x0) * double(y1 - y0);
  return {sum / n, std::sqrt(variance) / n};
}

inline Estimate imageMean(const Film& film, size_t channel) {
  return blockMean(film, 0, 0, film.width, film.height, channel);
}

/// z-scores of the difference of two independent films of one size in each block x block square
/// of pixels and each channel.
inline std::vector<double> blockScores(const Film& a, const Film& b, uint32_t block) {
  std::vector<double> scores;
  for (uint32_t y = 0; y < a.height; y += block) {
    for (uint32_t x = 0; x < a.width; x += block) {
      for (size_t channel = 0; channel < 3; ++channel) {
        scores.push_back(zScore(blockMean(a, x, y, x + block, y + block, channel),
                                blockMean(b, x, y, x + block, y + block, channel)));
      }
    }
  }
  return scores;
}

}  // namespace awdtest

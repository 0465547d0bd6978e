// SPDX-License-Identifier: Apache-2.0
//
// awd/render.h in C++.
#ifndef AWD_CPP_RENDER_HPP
#define AWD_CPP_RENDER_HPP

#include <vector>

#include "awd/cpp/field.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Size of a film, and samples per pixel so far.
struct FilmInfo {
  std::uint32_t width, height;
  std::uint64_t samplesPerPixel;
};

/// A path tracer with its film.
class Render : public Owner<Render, AWDRender, awdRetainRender, awdReleaseRender> {
 public:
  /// Without a field: with one of its own, if it is adaptive.
  static Returns<Render> create(const Scene& scene, const AWDRenderDesc& desc,
                                const Field& field = {}) {
    const detail::Call call;
    Render render;
    return detail::outcome(call, awdNewRender(scene.get(), field.get(), &desc, render.out()),
                           render);
  }

  /// Empty unless the render is adaptive.
  Returns<Field> field() const {
    AWDField handle = nullptr;
    const AWDResult result = awdGetRenderField(get(), &handle);
    Field field = Field::adopt(handle);
    return detail::outcome(result, field);
  }

  // --- passes: exclusive for the field too ------------------------------------------------------

  /// One pass; doesn't adapt.
  Returns<AWDPassStatistics> pass(std::uint32_t samplesPerPixel) {
    const detail::Call call(get());
    AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
    return detail::outcome(call, awdRenderPass(get(), samplesPerPixel, &statistics), statistics);
  }
  /// All passes of a schedule; without one the preset's.
  Returns<void> passes() { return run(nullptr); }
  Returns<void> passes(const AWDSchedule& schedule) { return run(&schedule); }

  // --- what came of them ------------------------------------------------------------------------

  Returns<std::uint32_t> passCount() {
    std::uint32_t count = 0;
    return detail::outcome(awdGetPassCount(get(), &count), count);
  }
  Returns<AWDPassStatistics> passStatistics(std::uint32_t index) {
    AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
    return detail::outcome(awdGetPassStatistics(get(), index, &statistics), statistics);
  }
  /// Of all passes.
  Returns<AWDPassStatistics> statistics() {
    AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
    return detail::outcome(awdGetRenderStatistics(get(), &statistics), statistics);
  }
  Returns<AWDRenderError> error() {
    AWDRenderError error = AWD_RENDER_ERROR_INIT;
    return detail::outcome(awdGetRenderError(get(), &error), error);
  }
  Returns<FilmInfo> filmInfo() {
    FilmInfo info = {};
    return detail::outcome(awdGetFilmInfo(get(), &info.width, &info.height, &info.samplesPerPixel),
                           info);
  }
  /// Writes a layer into the host's pixels.
  Returns<void> readFilm(ColourPixels pixels, AWDFilmLayer layer = AWD_FILM_RADIANCE) {
    std::uint32_t width = 0, height = 0;
    AWDResult result = awdGetFilmInfo(get(), &width, &height, nullptr);
    if (result == AWD_SUCCESS) {
      if (!pixels.is(width, height)) return detail::wrongPixels(pixels, width, height);
      result = awdReadFilm(get(), layer, pixels.data, pixels.pixelStride, pixels.rowStride);
    }
    return detail::outcome(result);
  }
  /// A layer as three floats a pixel, row by row.
  Returns<std::vector<float>> film(AWDFilmLayer layer = AWD_FILM_RADIANCE) {
    std::uint32_t width = 0, height = 0;
    std::vector<float> pixels;
    AWDResult result = awdGetFilmInfo(get(), &width, &height, nullptr);
    if (result == AWD_SUCCESS) {
      pixels.resize(std::size_t{3} * width * height);
      result = awdReadFilm(get(), layer, pixels.data(), 0, 0);
    }
    return detail::outcome(result, pixels);
  }
  Returns<std::uint32_t> pixelPatch(std::uint32_t x, std::uint32_t y) const {
    std::uint32_t patch = AWD_INVALID_ID;
    return detail::outcome(awdGetPixelPatch(get(), x, y, &patch), patch);
  }

 private:
  /// It adapts the field between passes, whose progress is then reported.
  Returns<void> run(const AWDSchedule* schedule) {
    AWDField handle = nullptr;
    const AWDResult found = awdGetRenderField(get(), &handle);
    if (found != AWD_SUCCESS) return detail::outcome(found);
    const Field field = Field::adopt(handle);
    const detail::Call call(get(), field.get());
    return detail::outcome(call, awdRenderPasses(get(), schedule));
  }
};

/// The schedule of a quality; the host may add seconds.
inline Returns<Schedule> qualitySchedule(AWDQuality quality) {
  Schedule schedule;
  return detail::outcome(awdGetQualitySchedule(quality, &schedule), schedule);
}

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif

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

  /// From a checkpoint; goes on with schedules that have `resume`.
  static Returns<Render> load(const Scene& scene, Text path) {
    return load(scene, path, nullptr, nullptr);
  }
  /// The same, if these settings are those of the checkpoint.
  static Returns<Render> load(const Scene& scene, Text path, const Field& field,
                              const AWDRenderDesc& desc) {
    return load(scene, path, field.get(), &desc);
  }
  /// Writes a checkpoint. Exclusive for the field too.
  Returns<void> save(Text path) { return detail::outcome(awdSaveRender(get(), path.get())); }

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

  // --- in several processes: exclusive for the field too ---------------------------------------

  /// Renders a part of the schedule's next pass, whose samples per pixel it returns: 0 if there is
  /// none. Without a schedule: of the preset's.
  Returns<std::uint32_t> passPart(std::uint32_t part, std::uint32_t parts) {
    return passPart(nullptr, part, parts);
  }
  Returns<std::uint32_t> passPart(const AWDSchedule& schedule, std::uint32_t part,
                                  std::uint32_t parts) {
    return passPart(&schedule, part, parts);
  }
  /// That part, to be combined with the others.
  Returns<Summands> exportPass() {
    return detail::summands([this](std::uint64_t* numbers, std::size_t capacity, std::size_t* sums,
                                   std::size_t* maxima) {
      return awdExportPass(get(), numbers, capacity, sums, maxima);
    });
  }
  /// Ends the pass with the numbers of all parts, combined.
  Returns<AWDPassStatistics> importPass(View<const std::uint64_t> numbers) {
    AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
    return detail::outcome(awdImportPass(get(), numbers.data(), numbers.size(), &statistics),
                           statistics);
  }

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
  static Returns<Render> load(const Scene& scene, const Text& path, AWDField field,
                              const AWDRenderDesc* desc) {
    const detail::Call call;
    Render render;
    return detail::outcome(call, awdLoadRender(scene.get(), path.get(), field, desc, render.out()),
                           render);
  }
  Returns<std::uint32_t> passPart(const AWDSchedule* schedule, std::uint32_t part,
                                  std::uint32_t parts) {
    AWDField handle = nullptr;
    const AWDResult found = awdGetRenderField(get(), &handle);
    if (found != AWD_SUCCESS) return detail::failure<std::uint32_t>(Error(found));
    const Field field = Field::adopt(handle);
    const detail::Call call(get(), field.get());
    std::uint32_t samples = 0;
    return detail::outcome(call, awdRenderPassPart(get(), schedule, part, parts, &samples),
                           samples);
  }
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

// SPDX-License-Identifier: Apache-2.0
// The object behind AWDRender: passes over a film, with their figures.
#pragma once

#include "guide/field.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/path.h"
#include "render/scene.h"

namespace awd {

class Render final : public RefCounted {
 public:
  /// field: null unless adaptive.
  static Ref<Render> make(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field,
                          const AWDRenderDesc& desc);
  Render(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field, const AWDRenderDesc& desc);

  /// One pass with frozen densities. Nothing is changed if it throws.
  AWDPassStatistics pass(uint32_t samplesPerPixel);
  /// The passes of a schedule, adapting between them.
  void passes(const AWDSchedule& schedule);

  const Film& film() const { return film_; }
  const Ref<Field>& field() const { return field_; }
  const std::pmr::vector<AWDPassStatistics>& statistics() const { return statistics_; }
  AWDPassStatistics total() const;
  FilmError error() const;
  uint32_t pixelPatch(uint32_t x, uint32_t y) const;

  const PathSettings& settings() const { return settings_; }
  AWDPreset preset() const { return preset_; }
  uint64_t seed() const { return seed_; }
  Context& context() const { return *context_; }

 private:
  void destroy() noexcept override;
  struct Counters;
  void passesWithin(const AWDSchedule& budget);
  /// More samples per pixel, at most, until the film's error is below; 0: it is.
  uint32_t samplesToReach(double error) const;
  void renderTile(uint32_t tile, uint32_t samplesPerPixel, PassFilm& film, Counters& counters);
  void adapt();
  /// Whether passes of so many samples per pixel in all are too few for learning to pay.
  bool shouldStepAside(double samples) const;
  void stepAside(bool aside);
  /// What a sample of the next pass counts for.
  double weightOfNext() const;

  Ref<Context> context_;
  Ref<Geometry> geometry_;
  Ref<Field> field_;
  AWDPreset preset_;
  PathSettings settings_;
  PathSettings used_;         ///< of the pass at hand
  Field* learner_ = nullptr;  ///< that paths of the pass at hand learn in: null unless guided
  uint64_t seed_;
  Camera camera_;
  AWDCombination combination_;
  bool experienced_ = false;  ///< the field had learned before
  Film film_;
  std::pmr::vector<float> expected_;  ///< luminance of pixels before the pass at hand, for roulette
  std::pmr::vector<AWDPassStatistics> statistics_;
};

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// The object behind AWDRender: passes over a film, with their figures.
#pragma once

#include <optional>

#include "guide/field.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/path.h"
#include "render/scene.h"
#include "render/stopwatch.h"

namespace awd {

/// The combination of a render's passes; AWD_ERROR_INVALID_ARGUMENT if it has none of that name.
AWDCombination settleCombination(const AWDRenderDesc& desc);

class Render final : public RefCounted {
 public:
  /// field: null unless adaptive; takes the scale of the scene's lights.
  static Ref<Render> make(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field,
                          const AWDRenderDesc& desc);
  Render(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field, const AWDRenderDesc& desc);

  /// From what save() wrote, of the same geometry. Fails if `desc` or the settings of `like` are
  /// others than they were; either may be null.
  static Ref<Render> load(Ref<Context> context, Ref<Geometry> geometry, const void* bytes,
                          std::size_t size, const Finders& find, const AWDRenderDesc* desc,
                          const Field* like);
  /// Everything that it takes to go on, in a file that is there whole or not at all.
  void save(const char* path) const;

  /// One pass with frozen densities. Nothing is changed if it throws.
  AWDPassStatistics pass(uint32_t samplesPerPixel);
  /// The passes of a schedule, adapting between them.
  void passes(const AWDSchedule& schedule);

  /// Renders one of so many parts of the schedule's next pass, adapting before it; its samples per
  /// pixel, 0: none is left. What is rendered counts once importPass() brings the whole.
  uint32_t passPart(const AWDSchedule& schedule, uint32_t part, uint32_t parts);
  Field::ExchangeSize exchangeSize() const;
  void exportPass(uint64_t* sums, uint64_t* maxima) const;
  AWDPassStatistics importPass(const uint64_t* sums, const uint64_t* maxima);

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
  struct Counters {
    uint64_t rays = 0, shadowRays = 0, rejected = 0;
  };
  struct AtomicCounters;
  /// Of a pass, before the others' are known.
  struct Part {
    uint32_t samples, part, parts;
    bool learns;  ///< whether the field was recorded in
    PassFilm film;
    Counters counters;
    double cpuSeconds, wallSeconds;
  };
  const Part& knownPart() const;
  /// Forgets a part that was never imported.
  void dropPart();
  /// Of all that those who render parts of one pass must agree in.
  uint64_t partDigest() const;
  /// All patches that a path may record in, unless they are spatial.
  std::pmr::vector<uint32_t> exchangedPatches() const;
  /// A schedule at work.
  struct Run {
    const AWDSchedule& schedule;
    std::pmr::vector<uint32_t> plan;  ///< of a schedule without limits
    uint32_t next;                    ///< number of the next pass in it
    uint32_t left;                    ///< samples per pixel, of one with limits
    double spent;                     ///< seconds, before it went on
    double pace;  ///< seconds a sample per pixel took in the last pass; 0: not known
    Stopwatch watch;
  };
  /// Fails if these settings are others than the render's.
  void checkSame(const AWDRenderDesc& other) const;
  Run begin(const AWDSchedule& schedule);
  /// Samples per pixel of the next pass, 0: there is none left. Settles whether it is guided.
  uint32_t next(Run& run);
  uint32_t nextWithin(Run& run);
  static bool isLimited(const AWDSchedule& schedule) {
    return schedule.seconds > 0.0 || schedule.error > 0.0;
  }
  /// Fails unless the passes so far are the first of the plan.
  void checkBegun(const std::pmr::vector<uint32_t>& plan) const;
  /// More samples per pixel, at most, until the film's error is below; 0: it is.
  uint32_t samplesToReach(double error) const;

  /// Of all passes, and of the one that is rendered.
  uint64_t bytesOfFilms() const;
  /// Leaves the field what desc.maxBytes leaves beside the films. Can't fail, and so comes last.
  void limitField();
  /// Settles what the next pass goes by, and all that may fail in finish().
  void prepare();
  /// The tiles of one of so many parts; what was recorded is forgotten if it throws.
  Counters renderTiles(uint32_t samplesPerPixel, uint32_t part, uint32_t parts, PassFilm& film);
  /// In vain if the progress is cancelled.
  void renderTile(uint32_t tile, uint32_t samplesPerPixel, PassFilm& film, AtomicCounters& counters,
                  Progress& progress);
  /// Takes a pass that is complete; its figures, in which times are still to be set.
  AWDPassStatistics& finish(const PassFilm& film, uint32_t samplesPerPixel,
                            const Counters& counters);
  /// Takes what the last pass has recorded, if it has not been taken yet.
  void adapt();
  /// Whether passes of so many samples per pixel in all are too few for learning to pay.
  bool shouldStepAside(double samples) const;
  void stepAside(bool aside);
  /// What a sample of the next pass counts for.
  double weightOfNext() const;

  Ref<Context> context_;
  Ref<Geometry> geometry_;
  Ref<Field> field_;
  AWDCamera view_;
  AWDRenderDesc desc_;  ///< as the host gave it, with its camera here
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
  std::optional<Part> part_;
};

}  // namespace awd

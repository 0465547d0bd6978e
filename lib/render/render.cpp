// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include <atomic>
#include <cmath>
#include <ctime>

#include "render/expected_luminance.h"
#include "render/schedule.h"
#include "util/error.h"

namespace awd {

namespace {

/// Side of the square of pixels that one thread renders at a time.
constexpr uint32_t kTile = 16;

/// With fewer samples per pixel than this in all, what is learned is not worth its time: measured
/// on six scenes, guided passes are less efficient than unguided ones below 4 to 7 samples.
constexpr double kFewestGuided = 6.0;

/// Before so many samples per pixel no path is split: what a pixel is expected to have is too
/// uncertain, and what comes of it too noisy to be worth more of the time.
constexpr uint64_t kFewestSplit = 8;

/// Before so many samples per pixel no error is believed to be small: light that is rare may not
/// have been met at all, and a black image has no error.
constexpr uint64_t kFewestTold = 16;

uint32_t tilesAlong(uint32_t pixels) { return (pixels + kTile - 1) / kTile; }

/// CPU time of the process and wall time since its construction.
class Stopwatch {
 public:
  double cpuSeconds() const { return now(CLOCK_PROCESS_CPUTIME_ID) - cpu_; }
  double wallSeconds() const { return now(CLOCK_MONOTONIC) - wall_; }

 private:
  static double now(clockid_t clock) {
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  double cpu_ = now(CLOCK_PROCESS_CPUTIME_ID);
  double wall_ = now(CLOCK_MONOTONIC);
};

bool isRadiance(Rgb c) { return isFinite(c) && c.x >= 0.0f && c.y >= 0.0f && c.z >= 0.0f; }

AWDCombination combinationOf(const AWDRenderDesc& desc) {
  if (desc.combination != AWD_COMBINE_DEFAULT && desc.combination != AWD_COMBINE_COUNT &&
      desc.combination != AWD_COMBINE_EXPERIENCE) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->combination is %d: renders know AWD_COMBINE_COUNT and "
         "AWD_COMBINE_EXPERIENCE",
         desc.combination);
  }
  if (desc.combination) return desc.combination;
  return desc.guide == AWD_GUIDE_ADAPTIVE && desc.preset != AWD_PRESET_PAPER
             ? AWD_COMBINE_EXPERIENCE
             : AWD_COMBINE_COUNT;
}

}  // namespace

struct Render::Counters {
  std::atomic<uint64_t> rays{0}, shadowRays{0}, rejected{0};
};

Ref<Render> Render::make(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field,
                         const AWDRenderDesc& desc) {
  std::pmr::memory_resource* memory = context->memory();
  return Ref<Render>::adopt(
      awd::make<Render>(memory, std::move(context), std::move(geometry), std::move(field), desc));
}

Render::Render(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field,
               const AWDRenderDesc& desc)
    : context_(std::move(context)),
      geometry_(std::move(geometry)),
      field_(std::move(field)),
      preset_(desc.preset),
      settings_(settle(desc)),
      seed_(desc.seed),
      camera_(*desc.camera, *geometry_),
      combination_(combinationOf(desc)),
      film_(context_->memory(), camera_.width(), camera_.height()),
      expected_(context_->memory()),
      statistics_(context_->memory()) {
  if (desc.maxBytes > 0) {
    const std::size_t pixels = std::size_t{camera_.width()} * camera_.height();
    const uint64_t film = film_.bytes() + PassFilm::bytesFor(pixels);
    if (film > desc.maxBytes) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->maxBytes is %llu: an image of %u x %u takes %llu bytes by itself",
           static_cast<unsigned long long>(desc.maxBytes), camera_.width(), camera_.height(),
           static_cast<unsigned long long>(film));
    }
    if (field_) field_->limitBytes(desc.maxBytes - film);
  }
  stepAside(false);
  if (field_) {
    experienced_ = field_->statistics().patches > 0;
    const double brightest = geometry_->lights().brightest();
    if (brightest > 0.0 && std::isfinite(brightest)) field_->setScale(brightest);
  }
}

void Render::destroy() noexcept {
  const Ref<Context> context = context_;
  unmake(context->memory(), this);
}

void Render::renderTile(uint32_t tile, uint32_t samplesPerPixel, PassFilm& film,
                        Counters& counters) {
  const uint32_t columns = tilesAlong(film.width);
  const uint32_t x0 = tile % columns * kTile;
  const uint32_t y0 = tile / columns * kTile;
  PathTracer tracer(*geometry_, learner_, used_);
  uint64_t rejected = 0;
  for (uint32_t y = y0; y < std::min(y0 + kTile, film.height); ++y) {
    for (uint32_t x = x0; x < std::min(x0 + kTile, film.width); ++x) {
      const uint64_t number = uint64_t{y} * film.width + x;
      for (uint32_t s = 0; s < samplesPerPixel; ++s) {
        const auto index = static_cast<uint32_t>(film_.samples() + s);
        PathPoints points(seed_, statistics_.size(), number, s, settings_.sobol, index);
        const SobolPoint at = points.pixel();
        const Vec3f direction = camera_.direction(x + at.x, y + at.y);
        const float expected = expected_.empty() ? 0.0f : expected_[number];
        const Rgb radiance = tracer.trace(camera_.eye(), direction, points, expected);
        if (isRadiance(radiance)) {
          film.pixel(x, y).add(radiance, index % 2 == 0);
        } else {
          ++rejected;
        }
      }
    }
  }
  counters.rays += tracer.rays();
  counters.shadowRays += tracer.shadowRays();
  counters.rejected += rejected;
}

double Render::weightOfNext() const {
  if (combination_ == AWD_COMBINE_COUNT || experienced_) return 1.0;
  const auto before = static_cast<double>(film_.samples());
  return (before + 2.0) / (before + 8.0);
}

AWDPassStatistics Render::pass(uint32_t samplesPerPixel) {
  if (samplesPerPixel == 0) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "samplesPerPixel is 0: a pass has at least 1 sample");
  }
  const Stopwatch watch;
  PassFilm pass(context_->memory(), film_.width(), film_.height());
  if (used_.roulette == AWD_ROULETTE_ADJOINT) {
    expected_ = expectedLuminance(context_->memory(), film_);
    used_.maxSplit = film_.samples() < kFewestSplit ? 1 : settings_.maxSplit;
  }
  statistics_.reserve(statistics_.size() + 1);
  if (field_) field_->mark();
  Counters counters;
  try {
    const uint32_t tiles = tilesAlong(film_.width()) * tilesAlong(film_.height());
    Progress progress(*context_, "pass", this, tiles);
    context_->parallel().forEach(tiles, [&](std::size_t tile) {
      if (progress.cancelled()) return;
      renderTile(static_cast<uint32_t>(tile), samplesPerPixel, pass, counters);
      progress.step();
    });
    progress.throwIfCancelled();
  } catch (...) {
    if (field_) field_->revert();
    throw;
  }
  film_.merge(pass, samplesPerPixel, weightOfNext());

  AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
  figures.samplesPerPixel = samplesPerPixel;
  figures.samples = uint64_t{samplesPerPixel} * film_.width() * film_.height();
  figures.rays = counters.rays;
  figures.shadowRays = counters.shadowRays;
  figures.rejectedSamples = counters.rejected;
  figures.bytes = film_.bytes();
  if (field_) {
    const AWDFieldStatistics learned = field_->statistics();
    figures.patches = learned.patches;
    figures.coefficients = learned.coefficients;
    figures.bytes += learned.bytes;
  }
  figures.cpuSeconds = watch.cpuSeconds();
  figures.wallSeconds = watch.wallSeconds();
  statistics_.push_back(figures);
  return figures;
}

bool Render::shouldStepAside(double samples) const {
  return field_ && !experienced_ && preset_ != AWD_PRESET_PAPER &&
         static_cast<double>(film_.samples()) + samples < kFewestGuided;
}

void Render::stepAside(bool aside) {
  used_ = settings_;
  learner_ = aside ? nullptr : field_.get();
  if (!aside) return;
  used_.guide = AWD_GUIDE_COSINE;
  if (used_.roulette == AWD_ROULETTE_ADJOINT) used_.roulette = AWD_ROULETTE_ALBEDO;
}

void Render::adapt() {
  const Stopwatch watch;
  const AWDFieldStatistics learned = field_->adapt();
  AWDPassStatistics& figures = statistics_.back();
  figures.rejectedSamples += learned.rejected;
  figures.cpuSeconds += watch.cpuSeconds();
  figures.wallSeconds += watch.wallSeconds();
}

uint32_t Render::samplesToReach(double error) const {
  if (film_.samples() < kFewestTold) return UINT32_MAX;
  const double now = film_.error().upper;
  if (now <= error) return 0;
  // The error goes with the root of the samples at least.
  const double ratio = now / error;
  const double more = static_cast<double>(film_.samples()) * (ratio * ratio - 1.0);
  return more < UINT32_MAX ? std::max(static_cast<uint32_t>(more), 1u) : UINT32_MAX;
}

void Render::passesWithin(const AWDSchedule& budget) {
  const Stopwatch watch;
  double pace = 0.0;  // seconds a sample per pixel took in the last pass, with its adapt
  uint32_t left = budget.totalSamples ? budget.totalSamples : UINT32_MAX;
  stepAside(shouldStepAside(left));
  for (uint32_t k = 0; left > 0; ++k) {
    const double begun = watch.wallSeconds();
    uint32_t samples = std::min(passSize(k), left);
    if (budget.error > 0.0) samples = std::min(samples, samplesToReach(budget.error));
    if (samples == 0) break;
    if (k > 0 && budget.seconds > 0.0) {
      const double fits = (budget.seconds - begun) / pace;
      if (!(fits >= 1.0)) break;
      stepAside(shouldStepAside(fits));
      // A remainder too small for a pass of its own goes along with this one.
      if (fits < 2.0 * samples) samples = static_cast<uint32_t>(std::min<double>(fits, left));
    }
    if (learner_ && !statistics_.empty()) adapt();
    pass(samples);
    left -= samples;
    pace = (watch.wallSeconds() - begun) / samples;
  }
}

void Render::passes(const AWDSchedule& schedule) {
  const auto checkBudget = [](double value, const char* name) {
    if (value >= 0.0 && std::isfinite(value)) return;
    fail(AWD_ERROR_INVALID_ARGUMENT, "schedule->%s is %g: it must be finite and not negative", name,
         value);
  };
  checkBudget(schedule.seconds, "seconds");
  checkBudget(schedule.error, "error");
  // Whatever this schedule decides holds until its end.
  struct Guided {
    Render& render;
    ~Guided() { render.stepAside(false); }
  } const again{*this};
  if (schedule.seconds > 0.0 || schedule.error > 0.0) {
    if (schedule.samplesPerPass || schedule.passCount > 0) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "schedule has %s and samplesPerPass: under such a limit the library divides",
           schedule.seconds > 0.0 ? "seconds" : "error");
    }
    return passesWithin(schedule);
  }
  const bool divides = !schedule.samplesPerPass && schedule.totalSamples > 0;
  stepAside(divides && shouldStepAside(schedule.totalSamples));
  for (const uint32_t samples :
       planPasses(context_->memory(), schedule, preset_, learner_ != nullptr)) {
    if (learner_ && !statistics_.empty()) adapt();
    pass(samples);
  }
}

FilmError Render::error() const {
  if (film_.samples() < 2) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "the film has %llu samples per pixel: its error can be told from 2 on",
         static_cast<unsigned long long>(film_.samples()));
  }
  return film_.error();
}

AWDPassStatistics Render::total() const {
  AWDPassStatistics sum = AWD_PASS_STATISTICS_INIT;
  for (const AWDPassStatistics& pass : statistics_) {
    sum.cpuSeconds += pass.cpuSeconds;
    sum.wallSeconds += pass.wallSeconds;
    sum.samplesPerPixel += pass.samplesPerPixel;
    sum.samples += pass.samples;
    sum.rays += pass.rays;
    sum.shadowRays += pass.shadowRays;
    sum.rejectedSamples += pass.rejectedSamples;
    sum.patches = pass.patches;
    sum.coefficients = pass.coefficients;
    sum.bytes = pass.bytes;
  }
  return sum;
}

uint32_t Render::pixelPatch(uint32_t x, uint32_t y) const {
  if (x >= camera_.width() || y >= camera_.height()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "pixel (%u, %u) is outside the image of %u x %u", x, y,
         camera_.width(), camera_.height());
  }
  const Vec3f direction = camera_.direction(x + 0.5, y + 0.5);
  RayHit hit;
  if (!geometry_->embree().intersect(camera_.eye(), direction, 0.0f,
                                     std::numeric_limits<float>::infinity(), hit)) {
    return AWD_INVALID_ID;
  }
  const Triangle& triangle = geometry_->triangle(hit.triangle);
  const bool back = dot(triangle.normal, direction) > 0.0f;
  if (field_ && field_->isSpatial()) {
    const Vec3f point = Geometry::onPlane(triangle, camera_.eye() + direction * hit.t);
    return field_->findPatch(geometry_->fromFrame(point),
                             back ? -triangle.normal : triangle.normal);
  }
  return triangle.patch | (back ? AWD_PATCH_BACK : 0u);
}

}  // namespace awd

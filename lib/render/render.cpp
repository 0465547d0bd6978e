// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include <atomic>
#include <cmath>

#include "render/expected_luminance.h"
#include "util/error.h"

namespace awd {

namespace {

/// Side of the square of pixels that one thread renders at a time.
constexpr uint32_t kTile = 16;

/// Before so many samples per pixel no path is split: what a pixel is expected to have is too
/// uncertain, and what comes of it too noisy to be worth more of the time.
constexpr uint64_t kFewestSplit = 8;

uint32_t tilesAlong(uint32_t pixels) { return (pixels + kTile - 1) / kTile; }

/// A tile of many samples tells of its progress after so many paths or so many rays of them, some
/// ten milliseconds.
constexpr std::size_t kPathsPerReport = 4096;
constexpr uint64_t kRaysPerReport = 1u << 18;

/// Those at the edge of the image count as if they were whole.
std::size_t pathsOfTile(uint32_t samplesPerPixel) {
  return std::size_t{kTile} * kTile * samplesPerPixel;
}

bool isRadiance(Rgb c) { return isFinite(c) && c.x >= 0.0f && c.y >= 0.0f && c.z >= 0.0f; }

}  // namespace

AWDCombination settleCombination(const AWDRenderDesc& desc) {
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

struct Render::AtomicCounters {
  std::atomic<uint64_t> rays{0}, shadowRays{0}, rejected{0};
};

Ref<Render> Render::make(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field,
                         const AWDRenderDesc& desc) {
  std::pmr::memory_resource* memory = context->memory();
  auto render = Ref<Render>::adopt(
      awd::make<Render>(memory, std::move(context), std::move(geometry), std::move(field), desc));
  if (Field* learner = render->field_.get()) {
    render->experienced_ = learner->statistics().patches > 0;
    const double brightest = render->geometry_->lights().brightest();
    if (brightest > 0.0 && std::isfinite(brightest)) learner->setScale(brightest);
  }
  render->limitField();
  return render;
}

Render::Render(Ref<Context> context, Ref<Geometry> geometry, Ref<Field> field,
               const AWDRenderDesc& desc)
    : context_(std::move(context)),
      geometry_(std::move(geometry)),
      field_(std::move(field)),
      view_(*desc.camera),
      desc_(desc),
      preset_(desc.preset),
      settings_(settle(desc)),
      seed_(desc.seed),
      camera_(*desc.camera, *geometry_),
      combination_(settleCombination(desc)),
      film_(context_->memory(), camera_.width(), camera_.height()),
      expected_(context_->memory()),
      statistics_(context_->memory()) {
  if (desc.maxBytes > 0) {
    const uint64_t film = bytesOfFilms();
    if (film > desc.maxBytes) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->maxBytes is %llu: an image of %u x %u takes %llu bytes by itself",
           static_cast<unsigned long long>(desc.maxBytes), camera_.width(), camera_.height(),
           static_cast<unsigned long long>(film));
    }
  }
  desc_.camera = &view_;
  stepAside(false);
}

uint64_t Render::bytesOfFilms() const {
  const std::size_t pixels = std::size_t{camera_.width()} * camera_.height();
  return film_.bytes() + PassFilm::bytesFor(pixels);
}

void Render::limitField() {
  if (field_ && desc_.maxBytes > 0) field_->limitBytes(desc_.maxBytes - bytesOfFilms());
}

void Render::destroy() noexcept {
  const Ref<Context> context = context_;
  unmake(context->memory(), this);
}

void Render::renderTile(uint32_t tile, uint32_t samplesPerPixel, PassFilm& film,
                        AtomicCounters& counters, Progress& progress) {
  const uint32_t columns = tilesAlong(film.width);
  const uint32_t x0 = tile % columns * kTile;
  const uint32_t y0 = tile / columns * kTile;
  PathTracer tracer(*geometry_, learner_, used_);
  uint64_t rejected = 0;
  std::size_t paths = 0, told = 0;
  uint64_t raysTold = 0;
  for (uint32_t y = y0; y < std::min(y0 + kTile, film.height); ++y) {
    for (uint32_t x = x0; x < std::min(x0 + kTile, film.width); ++x) {
      const uint64_t number = uint64_t{y} * film.width + x;
      for (uint32_t s = 0; s < samplesPerPixel; ++s, ++paths) {
        if (paths - told == kPathsPerReport || tracer.rays() - raysTold >= kRaysPerReport) {
          progress.step(paths - told);
          if (progress.cancelled()) return;
          told = paths;
          raysTold = tracer.rays();
        }
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
  progress.step(pathsOfTile(samplesPerPixel) - told);
}

double Render::weightOfNext() const {
  if (combination_ == AWD_COMBINE_COUNT || experienced_) return 1.0;
  const auto before = static_cast<double>(film_.samples());
  return (before + 2.0) / (before + 8.0);
}

void Render::prepare() {
  if (used_.roulette == AWD_ROULETTE_ADJOINT) {
    expected_ = expectedLuminance(context_->memory(), film_);
    used_.maxSplit = film_.samples() < kFewestSplit ? 1 : settings_.maxSplit;
  }
  statistics_.reserve(statistics_.size() + 1);
  if (field_) field_->mark();
}

Render::Counters Render::renderTiles(uint32_t samplesPerPixel, uint32_t part, uint32_t parts,
                                     PassFilm& film) {
  AtomicCounters counters;
  try {
    const uint32_t all = tilesAlong(film.width) * tilesAlong(film.height);
    // Every so many tiles: parts that lie in one place would differ in the work they make.
    const uint32_t tiles = part < all ? (all - part - 1) / parts + 1 : 0;
    Progress progress(*context_, "pass", this, tiles * pathsOfTile(samplesPerPixel));
    context_->parallel().forEach(tiles, [&](std::size_t i) {
      if (progress.cancelled()) return;
      renderTile(part + static_cast<uint32_t>(i) * parts, samplesPerPixel, film, counters,
                 progress);
    });
    progress.throwIfCancelled();
  } catch (...) {
    if (field_) field_->revert();
    throw;
  }
  return {counters.rays, counters.shadowRays, counters.rejected};
}

AWDPassStatistics& Render::finish(const PassFilm& film, uint32_t samplesPerPixel,
                                  const Counters& counters) {
  film_.merge(film, samplesPerPixel, weightOfNext());

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
  statistics_.push_back(figures);
  return statistics_.back();
}

AWDPassStatistics Render::pass(uint32_t samplesPerPixel) {
  if (samplesPerPixel == 0) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "samplesPerPixel is 0: a pass has at least 1 sample");
  }
  const Stopwatch watch;
  PassFilm film(context_->memory(), film_.width(), film_.height());
  dropPart();
  prepare();
  const Counters counters = renderTiles(samplesPerPixel, 0, 1, film);
  AWDPassStatistics& figures = finish(film, samplesPerPixel, counters);
  figures.cpuSeconds = watch.cpuSeconds();
  figures.wallSeconds = watch.wallSeconds();
  return figures;
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

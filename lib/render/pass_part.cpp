// SPDX-License-Identifier: Apache-2.0
// A pass that several processes render together: each some tiles with all of their samples, so that
// a pixel's sums are made by one process, in the order of its samples, and adding the others' zeros
// changes no bit. Doubles are exchanged by their bits, of which all but one are 0 likewise.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/render.h"
#include "util/digest.h"
#include "util/error.h"

namespace awd {

namespace {

/// Before the pixels: how many parts; which; counters; nanoseconds of all processors.
constexpr std::size_t kHeadSums = 6;
/// A digest and its complement, of which the largest are both one's own only if all are the same;
/// nanoseconds that the slowest took.
constexpr std::size_t kHeadMaxima = 3;
/// Of a pixel.
constexpr std::size_t kNumbers = sizeof(PixelSums) / sizeof(double);
static_assert(kNumbers * sizeof(double) == sizeof(PixelSums));

uint64_t nanoseconds(double seconds) { return static_cast<uint64_t>(std::llround(seconds * 1e9)); }
double seconds(uint64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

/// Tells sums of different parts apart.
uint64_t markOf(uint32_t part) { return mixBits(part + 1); }

}  // namespace

void Render::dropPart() {
  if (!part_) return;
  part_.reset();
  if (field_) field_->revert();
}

const Render::Part& Render::knownPart() const {
  if (!part_) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "no part of a pass has been rendered: awdRenderPassPart does");
  }
  return *part_;
}

std::pmr::vector<uint32_t> Render::exchangedPatches() const {
  std::pmr::vector<uint32_t> patches(context_->memory());
  if (!part_->learns || field_->isSpatial()) return patches;
  const AWDSceneInfo info = geometry_->info();
  for (uint32_t t = 0; t < info.triangles - info.skipped; ++t) {
    const uint32_t front = geometry_->triangle(t).patch;
    patches.push_back(front);
    patches.push_back(front | AWD_PATCH_BACK);
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  return patches;
}

uint64_t Render::partDigest() const {
  Digest digest;
  digest.add(geometry_->digest());
  for (const float* v : {view_.eye, view_.lookDir, view_.up}) digest.add(awd::load(v));
  digest.add(view_.tanHalfFovX);
  for (const uint32_t number :
       {view_.width, view_.height, settings_.shadowRays, settings_.maxLights, settings_.maxSplit,
        part_->samples, part_->parts}) {
    digest.add(number);
  }
  for (const int32_t choice :
       {preset_, settings_.guide, settings_.direct, settings_.roulette, combination_}) {
    digest.add(choice);
  }
  for (const bool flag : {settings_.learnLights, settings_.sobol, experienced_, part_->learns}) {
    digest.add(flag);
  }
  digest.add(seed_);
  for (const AWDPassStatistics& pass : statistics_) digest.add(pass.samplesPerPixel);
  return digest.value();
}

uint32_t Render::passPart(const AWDSchedule& schedule, uint32_t part, uint32_t parts) {
  if (part >= parts) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "part is %u of %u: it must be below parts", part, parts);
  }
  if (schedule.seconds > 0.0) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "schedule->seconds is %g: processes would not agree in the passes that there is time for; "
         "use totalSamples or error",
         schedule.seconds);
  }
  struct Guided {
    Render& render;
    ~Guided() { render.stepAside(false); }
  } const again{*this};
  AWDSchedule rest = schedule;
  rest.resume = 1;
  Run run = begin(rest);
  const uint32_t samples = next(run);
  if (samples == 0) return 0;
  adapt();
  const Stopwatch watch;
  PassFilm film(context_->memory(), film_.width(), film_.height());
  prepare();
  const Counters counters = renderTiles(samples, part, parts, film);
  part_.emplace(Part{samples, part, parts, learner_ != nullptr, std::move(film), counters,
                     watch.cpuSeconds(), watch.wallSeconds()});
  return samples;
}

Field::ExchangeSize Render::exchangeSize() const {
  const Part& part = knownPart();
  Field::ExchangeSize size = {kHeadSums + kNumbers * part.film.pixels.size(), kHeadMaxima};
  if (part.learns) {
    const auto patches = exchangedPatches();
    const Field::ExchangeSize learned = field_->exchangeSize({patches.data(), patches.size()});
    size.sums += learned.sums;
    size.maxima += learned.maxima;
  }
  return size;
}

void Render::exportPass(uint64_t* sums, uint64_t* maxima) const {
  const Part& part = knownPart();
  const uint64_t head[kHeadSums] = {1,
                                    markOf(part.part),
                                    part.counters.rays,
                                    part.counters.shadowRays,
                                    part.counters.rejected,
                                    nanoseconds(part.cpuSeconds)};
  std::copy(head, head + kHeadSums, sums);
  const std::size_t pixels = part.film.pixels.size();
  std::memcpy(sums + kHeadSums, part.film.pixels.data(), pixels * sizeof(PixelSums));
  maxima[0] = partDigest();
  maxima[1] = ~maxima[0];
  maxima[2] = nanoseconds(part.wallSeconds);
  if (!part.learns) return;
  const auto patches = exchangedPatches();
  field_->exportRecords({patches.data(), patches.size()}, sums + kHeadSums + kNumbers * pixels,
                        maxima + kHeadMaxima);
}

AWDPassStatistics Render::importPass(const uint64_t* sums, const uint64_t* maxima) {
  const Part& part = knownPart();
  const uint64_t digest = partDigest();
  if (maxima[0] != digest || maxima[1] != ~digest) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "numbers are not of parts of this pass alone: the processes differ in scene, settings, "
         "schedule, number of parts, or the passes that they have had");
  }
  uint64_t marks = 0;
  for (uint32_t i = 0; i < part.parts; ++i) marks += markOf(i);
  if (sums[0] != part.parts || sums[1] != marks) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "numbers have %llu parts of a pass of %u: each must be in them once",
         static_cast<unsigned long long>(sums[0]), part.parts);
  }
  PassFilm film(context_->memory(), film_.width(), film_.height());
  const std::size_t pixels = film.pixels.size();
  std::memcpy(static_cast<void*>(film.pixels.data()), sums + kHeadSums, pixels * sizeof(PixelSums));
  const auto within = [](const Vec3d& v, double most) {
    return v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0 && v.x <= most && v.y <= most && v.z <= most;
  };
  const double most = PixelSums::most(part.samples);
  for (std::size_t i = 0; i < pixels; ++i) {
    const PixelSums& pixel = film.pixels[i];
    if (within(pixel.sum, most) && within(pixel.evens, most) &&
        within(pixel.squares, PixelSums::mostSquared(part.samples))) {
      continue;
    }
    fail(AWD_ERROR_INVALID_ARGUMENT, "numbers of pixel %zu make no sense", i);
  }
  if (part.learns) {
    const auto patches = exchangedPatches();
    field_->importRecords({patches.data(), patches.size()}, sums + kHeadSums + kNumbers * pixels,
                          maxima + kHeadMaxima);
  }
  AWDPassStatistics& figures = finish(film, part.samples, {sums[2], sums[3], sums[4]});
  figures.cpuSeconds = seconds(sums[5]);
  figures.wallSeconds = seconds(maxima[2]);
  part_.reset();
  return figures;
}

}  // namespace awd

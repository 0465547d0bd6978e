// SPDX-License-Identifier: Apache-2.0
#include "render/schedule.h"

#include <algorithm>

#include "util/error.h"

namespace awd {

namespace {

constexpr uint32_t kPaperPasses[] = {10, 10, 10, 70};
constexpr uint32_t kDefaultSamples = 100;

/// What awd/render.h promises, from AWD_QUALITY_DRAFT on. Most scenes take far fewer samples: there
/// may be so many for the sake of those where light is hard to find.
struct QualityLimits {
  double error;
  uint32_t totalSamples;
};
constexpr QualityLimits kQualities[] = {{0.5, 1024}, {0.25, 4096}, {0.1, 16384}, {0.05, 65536}};

/// The paper's proportions: three passes of a tenth, then the rest.
void dividePaper(uint32_t total, std::pmr::vector<uint32_t>& passes) {
  const uint32_t early = total / 10;
  if (early > 0) passes.assign(3, early);
  passes.push_back(total - 3 * early);
}

/// 1, 1, 1, 2, 2, 2, 4, .. and the rest to the last: early passes are quick, and the last, which
/// has the best densities, takes a sixth of all or more.
void divideDoubling(uint32_t total, std::pmr::vector<uint32_t>& passes) {
  uint32_t left = total;
  for (uint32_t k = 0; left > 0; ++k) {
    const uint32_t size = passSize(k);
    // A remainder too small to be a pass of its own goes along with this one.
    const uint32_t samples = left < 2 * size ? left : size;
    passes.push_back(samples);
    left -= samples;
  }
}

}  // namespace

uint32_t passSize(uint32_t k) { return uint32_t{1} << std::min(k / 3, 30u); }

AWDSchedule qualitySchedule(AWDQuality quality) {
  if (quality < AWD_QUALITY_DRAFT || quality > AWD_QUALITY_REFERENCE) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "quality is %d: not an AWD_QUALITY_...", quality);
  }
  const QualityLimits& limits = kQualities[quality - AWD_QUALITY_DRAFT];
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = limits.totalSamples;
  schedule.error = limits.error;
  return schedule;
}

std::pmr::vector<uint32_t> planPasses(std::pmr::memory_resource* memory,
                                      const AWDSchedule& schedule, AWDPreset preset, bool learns) {
  std::pmr::vector<uint32_t> passes(memory);
  if (schedule.samplesPerPass || schedule.passCount > 0) {
    if (!schedule.samplesPerPass || schedule.passCount == 0 || schedule.totalSamples != 0) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "schedule has samplesPerPass %s, passCount %u and totalSamples %u: give the first two, "
           "or the third alone",
           schedule.samplesPerPass ? "set" : "NULL", schedule.passCount, schedule.totalSamples);
    }
    passes.assign(schedule.samplesPerPass, schedule.samplesPerPass + schedule.passCount);
    const auto empty = std::find(passes.begin(), passes.end(), 0u);
    if (empty != passes.end()) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "schedule->samplesPerPass[%td] is 0: a pass has at least 1 sample",
           empty - passes.begin());
    }
    return passes;
  }
  const uint32_t total = schedule.totalSamples ? schedule.totalSamples : kDefaultSamples;
  if (!learns) {
    passes.push_back(total);
  } else if (preset == AWD_PRESET_PAPER && schedule.totalSamples == 0) {
    passes.assign(std::begin(kPaperPasses), std::end(kPaperPasses));
  } else if (preset == AWD_PRESET_PAPER) {
    dividePaper(total, passes);
  } else {
    divideDoubling(total, passes);
  }
  return passes;
}

}  // namespace awd

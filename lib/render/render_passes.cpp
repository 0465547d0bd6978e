// SPDX-License-Identifier: Apache-2.0
// The passes of a schedule, from its beginning or from where they stand.
#include <cmath>

#include "render/render.h"
#include "render/schedule.h"
#include "util/error.h"

namespace awd {

namespace {

/// With fewer samples per pixel than this in all, what is learned is not worth its time: measured
/// on six scenes, guided passes are less efficient than unguided ones below 4 to 7 samples.
constexpr double kFewestGuided = 6.0;

/// Before so many samples per pixel no error is believed to be small: light that is rare may not
/// have been met at all, and a black image has no error.
constexpr uint64_t kFewestTold = 16;

void check(const AWDSchedule& schedule) {
  const auto checkBudget = [](double value, const char* name) {
    if (value >= 0.0 && std::isfinite(value)) return;
    fail(AWD_ERROR_INVALID_ARGUMENT, "schedule->%s is %g: it must be finite and not negative", name,
         value);
  };
  checkBudget(schedule.seconds, "seconds");
  checkBudget(schedule.error, "error");
  if ((schedule.seconds > 0.0 || schedule.error > 0.0) &&
      (schedule.samplesPerPass || schedule.passCount > 0)) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "schedule has %s and samplesPerPass: under such a limit the library divides",
         schedule.seconds > 0.0 ? "seconds" : "error");
  }
}

}  // namespace

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
  // Before the first pass there is nothing of ours to learn from. Nothing new is recorded since the
  // last adapt if the pass after it was given up, or if the host adapts by itself.
  if (!learner_ || statistics_.empty() || !learner_->hasRecords()) return;
  const Stopwatch watch;
  const AWDFieldStatistics learned = learner_->adapt();
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

void Render::checkBegun(const std::pmr::vector<uint32_t>& plan) const {
  if (statistics_.size() > plan.size()) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "schedule->resume is set: the render has had %zu passes, the schedule has %zu",
         statistics_.size(), plan.size());
  }
  for (std::size_t k = 0; k < statistics_.size(); ++k) {
    const auto had = static_cast<unsigned long long>(statistics_[k].samplesPerPixel);
    if (had == plan[k]) continue;
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "schedule->resume is set: pass %zu of the render had %llu samples per pixel, that of the "
         "schedule has %u",
         k, had, plan[k]);
  }
}

Render::Run Render::begin(const AWDSchedule& schedule) {
  check(schedule);
  Run run = {schedule, std::pmr::vector<uint32_t>(context_->memory()), 0, 0, 0.0, 0.0, {}};
  const bool resumes = schedule.resume != 0;
  if (resumes) run.next = static_cast<uint32_t>(statistics_.size());
  const uint64_t had = resumes ? film_.samples() : 0;
  const uint64_t all = schedule.totalSamples;
  if (isLimited(schedule)) {
    run.left = all == 0 ? UINT32_MAX : static_cast<uint32_t>(all - std::min(all, had));
    if (resumes && !statistics_.empty()) {
      const AWDPassStatistics& last = statistics_.back();
      run.spent = total().wallSeconds;
      run.pace = last.wallSeconds / static_cast<double>(last.samplesPerPixel);
    }
    dropPart();
    stepAside(shouldStepAside(run.left));
    return run;
  }
  const bool divides = !schedule.samplesPerPass && all > 0;
  stepAside(divides && shouldStepAside(static_cast<double>(all - std::min(all, had))));
  run.plan = planPasses(context_->memory(), schedule, preset_, learner_ != nullptr);
  if (resumes) checkBegun(run.plan);
  dropPart();  // not before: a schedule that is refused changes nothing
  return run;
}

uint32_t Render::nextWithin(Run& run) {
  const AWDSchedule& limits = run.schedule;
  uint32_t samples = std::min(passSize(run.next), run.left);
  if (limits.error > 0.0) samples = std::min(samples, samplesToReach(limits.error));
  if (samples > 0 && limits.seconds > 0.0 && run.pace > 0.0) {
    const double fits = (limits.seconds - run.spent - run.watch.wallSeconds()) / run.pace;
    if (!(fits >= 1.0)) return 0;
    stepAside(shouldStepAside(fits));
    // A remainder too small for a pass of its own goes along with this one.
    if (fits < 2.0 * samples) samples = static_cast<uint32_t>(std::min<double>(fits, run.left));
  }
  run.left -= samples;
  return samples;
}

uint32_t Render::next(Run& run) {
  const uint32_t samples = isLimited(run.schedule)      ? nextWithin(run)
                           : run.next < run.plan.size() ? run.plan[run.next]
                                                        : 0;
  ++run.next;
  return samples;
}

void Render::passes(const AWDSchedule& schedule) {
  // Whatever this schedule decides holds until its end.
  struct Guided {
    Render& render;
    ~Guided() { render.stepAside(false); }
  } const again{*this};
  Run run = begin(schedule);
  for (uint32_t done = 0; schedule.maxPasses == 0 || done < schedule.maxPasses; ++done) {
    const uint32_t samples = next(run);
    if (samples == 0) break;
    const Stopwatch watch;
    adapt();
    pass(samples);
    run.pace = watch.wallSeconds() / samples;
  }
}

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
#include "paper_stages.h"

#include <ctime>

#include "paper.h"
#include "support/handles.h"

namespace bench::paper {
namespace {

using awdtest::must;

/// Of the process: adapting by hand is in no pass's own account.
double cpuNow() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void check(AWDResult result) {
  if (result == AWD_ERROR_CANCELLED) throw Cancelled();
  must(result);
}

awdtest::Field fieldOf(const LoadedScene& loaded, const Settings& settings) {
  awdtest::Field field;
  if (settings.render.guide == AWD_GUIDE_ADAPTIVE) {
    must(awdNewSceneField(loaded.scene.get(), &settings.field, field.out()));
  }
  return field;
}

awdtest::Render renderOf(const LoadedScene& loaded, AWDField field, const Settings& settings,
                         uint64_t seed) {
  AWDRenderDesc desc = settings.render;
  desc.camera = &loaded.camera;
  desc.seed = seed;
  awdtest::Render render;
  must(awdNewRender(loaded.scene.get(), field, &desc, render.out()));
  return render;
}

Stage stageOf(const LoadedScene& loaded, AWDRender render, double cpuSeconds) {
  Stage stage;
  uint64_t samples = 0;
  must(awdGetFilmInfo(render, &stage.film.width, &stage.film.height, &samples));
  stage.film.values.resize(std::size_t{3} * stage.film.width * stage.film.height);
  must(awdReadFilm(render, AWD_FILM_RADIANCE, stage.film.values.data(), 0, 0));
  stage.samples = static_cast<uint32_t>(samples);
  stage.cpuSeconds = cpuSeconds;
  if (!loaded.reference.mean.values.empty()) {
    stage.l1 = command::compareImages(stage.film, loaded.reference.mean).l1;
  }
  return stage;
}

}  // namespace

std::vector<Stage> renderStages(const LoadedScene& loaded, const Settings& settings,
                                const std::vector<uint32_t>& passes, std::size_t learning,
                                uint64_t seed, AWDField field) {
  const awdtest::Field own = field ? awdtest::Field() : fieldOf(loaded, settings);
  if (!field) field = own;
  const awdtest::Render render = renderOf(loaded, field, settings, seed);
  std::vector<Stage> stages;
  double cpuSeconds = 0.0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double start = cpuNow();
    check(awdRenderPass(render, passes[i], nullptr));
    if (field && i < learning) check(awdAdaptField(field, nullptr));
    cpuSeconds += cpuNow() - start;
    stages.push_back(stageOf(loaded, render, cpuSeconds));
  }
  return stages;
}

Stage renderWhole(const LoadedScene& loaded, const Settings& settings, uint32_t samples,
                  uint64_t seed) {
  const awdtest::Field field = fieldOf(loaded, settings);
  const awdtest::Render render = renderOf(loaded, field, settings, seed);
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = samples;
  const double start = cpuNow();
  check(awdRenderPasses(render, &schedule));
  return stageOf(loaded, render, cpuNow() - start);
}

command::RgbImage between(const Stage& earlier, const Stage& later) {
  command::RgbImage image = later.film;
  const double before = earlier.samples, after = later.samples;
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    const double sum = after * later.film.values[i] - before * earlier.film.values[i];
    image.values[i] = static_cast<float>(sum / (after - before));
  }
  return image;
}

}  // namespace bench::paper

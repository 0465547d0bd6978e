// SPDX-License-Identifier: Apache-2.0
// Figure 4: noise in bands where piecewise constant pdfs jump, and none with linear B-splines.
#include <cmath>
#include <cstdio>
#include <utility>

#include "paper.h"
#include "paper_floor.h"
#include "paper_methods.h"
#include "paper_stages.h"
#include "png_bytes.h"
#include "support/handles.h"

namespace bench::paper {
namespace {

using awdtest::must;

struct Bands {
  double across = 0.0, inside = 0.0;  ///< median |change of ln variance| over one lamp's side
  double measured = 0.0;              ///< the film's own variance over the predicted one
  std::vector<float> deviation;       ///< predicted, in each pixel
  command::RgbImage film;
};

/// Steps of the lamp's side: a shorter one would see only part of a jump.
void compareSteps(AWDField field, uint32_t patch, uint32_t level, Bands& bands) {
  constexpr double kStep = kLampSide, kFineStep = kLampSide / 3;
  std::vector<double> across, inside;
  for (double x = -0.95; x + kStep < 0.95; x += kFineStep) {
    for (double z = -0.95; z + kStep < 0.95; z += kFineStep) {
      const double here = std::log(momentsAt(field, patch, x, z).variance);
      const uint32_t cell = cellAt(field, patch, level, x, z);
      for (const auto& [dx, dz] : {std::pair{kStep, 0.0}, std::pair{0.0, kStep}}) {
        const double there = std::log(momentsAt(field, patch, x + dx, z + dz).variance);
        const bool same = cell == cellAt(field, patch, level, x + dx, z + dz);
        (same ? inside : across).push_back(std::fabs(there - here));
      }
    }
  }
  bands.across = spreadOf(across).median;
  bands.inside = spreadOf(inside).median;
}

/// The prediction against what a render with the same densities saw.
void compareFilm(const LoadedScene& floor, const Settings& settings, AWDField field, uint32_t patch,
                 uint32_t samples, Bands& bands) {
  AWDRenderDesc desc = settings.render;
  desc.camera = &floor.camera;
  desc.seed = 1000;
  awdtest::Render render;
  must(awdNewRender(floor.scene.get(), field, &desc, render.out()));
  must(awdRenderPass(render, samples, nullptr));
  const uint32_t width = floor.camera.width;
  bands.film = {width, width, std::vector<float>(std::size_t{3} * width * width)};
  must(awdReadFilm(render, AWD_FILM_RADIANCE, bands.film.values.data(), 0, 0));
  std::vector<float> variances(bands.film.values.size());
  must(awdReadFilm(render, AWD_FILM_VARIANCE, variances.data(), 0, 0));
  double seen = 0.0, predicted = 0.0;
  for (uint32_t j = 0; j < width; ++j) {
    for (uint32_t i = 0; i < width; ++i) {
      // The camera is 0.98 above the floor, and looks down with half a field of view of 45 degrees.
      const double x = 0.98 * ((2.0 * i + 1.0) / width - 1.0);
      const double z = 0.98 * ((2.0 * j + 1.0) / width - 1.0);
      const auto [mean, variance] = momentsAt(field, patch, x, z);
      bands.deviation.push_back(static_cast<float>(std::sqrt(variance)));
      // Where the lamp is hit more rarely than that, one hit more or less decides.
      if (variance > mean * mean * samples) continue;
      predicted += variance;
      seen += double{variances[std::size_t{3} * (j * width + i)]} * samples;
    }
  }
  bands.measured = seen / predicted;
}

Bands measure(const Study& study, const LoadedScene& floor, const char* basis) {
  const bool quick = study.options.quick;
  Settings settings = paperSettings(basis);
  settings.render.direct = AWD_DIRECT_NONE;
  awdtest::Field field;
  must(awdNewSceneField(floor.scene.get(), &settings.field, field.out()));
  const uint32_t learn = quick ? 200 : 400;
  renderStages(floor, settings, std::vector<uint32_t>(kLearningPasses, learn), kLearningPasses, 1,
               field);
  const uint32_t patch = floorPatch(floor);
  AWDPatchInfo info = AWD_PATCH_INFO_INIT;
  must(awdGetPatchInfo(field, patch, &info));
  Bands bands;
  compareSteps(field, patch, info.level, bands);
  compareFilm(floor, settings, field, patch, 1000, bands);
  return bands;
}

}  // namespace

void measureBands(Study& study) {
  const LoadedScene floor = floorUnderLamp(study.device, study.options.quick ? 64 : 128);
  study.section.heading("Figure 4: bands of noise");
  study.section.paragraph(
      "A floor of one patch under a small lamp, no shadow rays: the densities learn direct light. "
      "Bands are told without noise: the variance of a sample at a point of the floor is an "
      "integral over the lamp, of the learned density. How far its logarithm changes from a point "
      "to one that lies a lamp's side away is compared where the lamp's middle changes the cell of "
      "the density between the two, and where it doesn't. Bands: far more across than inside. The "
      "prediction is checked against the variance that a render of 1000 samples with these "
      "densities sees, where by the prediction a pixel's standard error is below its mean.");
  ReportTable table = {"Median change of ln variance over a lamp's side",
                       {"basis", "across borders", "inside cells", "ratio", "seen / predicted"},
                       {}};
  std::vector<ReportImage> films, deviations;
  for (const char* basis : {"haar", "linear-bspline", "quadratic-bspline"}) {
    const Bands bands = measure(study, floor, basis);
    const double ratio = bands.across / bands.inside;
    std::printf(
        "bands: %-18s across %.3f, inside %.3f, ratio %.2f; variance seen / predicted %.3f\n",
        basis, bands.across, bands.inside, ratio, bands.measured);
    std::fflush(stdout);
    study.rows.push_back({{"part", "bands"},
                          {"basis", basis},
                          {"across", bands.across},
                          {"inside", bands.inside},
                          {"ratio", ratio},
                          {"variance_seen_to_predicted", bands.measured}});
    table.rows.push_back({basis, shortNumber(bands.across), shortNumber(bands.inside),
                          shortNumber(ratio), shortNumber(bands.measured)});
    films.push_back({basis, pngOf(bands.film, exposureOf(bands.film))});
    deviations.push_back({basis, greyPng(bands.deviation, floor.camera.width)});
  }
  study.section.table(table);
  study.section.images(films, "Figure 4: one pass with what three passes taught.");
  study.section.images(
      deviations, "Standard deviation of a sample as predicted, from 0 (dark) to its maximum.");
}

}  // namespace bench::paper

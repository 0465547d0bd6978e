// SPDX-License-Identifier: Apache-2.0
// Albedo and radiance at the ends of their ranges.
#include <algorithm>
#include <limits>

#include "scene_extremes/extremes.h"
#include "scene_extremes/furnace.h"

namespace awdtest {

namespace {

constexpr uint32_t kSize = 32;

Outcome albedoZero() {
  Findings found;
  const Scene scene = furnace(0.0, 0.7).commit(sceneDevice());
  const AWDCamera view = furnaceCamera(kSize, kSize);
  for (const NamedGuide& guide : kGuides) {
    for (const AWDDirectLight direct : {AWD_DIRECT_AREA, AWD_DIRECT_WEIGHTED, AWD_DIRECT_NONE}) {
      AWDRenderDesc desc = renderDesc(view, guide.guide, 1);
      desc.direct = direct;
      const RenderedFilm rendered = renderedFilm(scene, desc, {2, 2, 5});
      expectUsable(found, rendered, guide.name);
      for (const float value : rendered.film.radiance) {
        found.expect(value == 0.7f, "%s: %.9g", guide.name, value);
      }
      found.expect(rendered.statistics.rays == rendered.statistics.samples, "%s: %llu rays",
                   guide.name, static_cast<unsigned long long>(rendered.statistics.rays));
    }
  }
  return found.outcome("0.7 in all pixels, one ray a path");
}

Outcome albedoOne() {
  Findings found;
  double worst = 0.0;
  SceneBuilder builder;
  std::vector<uint32_t> walls(6, builder.material(grey(1.0)));
  walls[4] = builder.material(grey(0.0), grey(3.0));
  builder.box({0, 0, 0}, {1, 1, 1}, true, walls);
  const Scene scene = builder.commit(sceneDevice());
  const AWDCamera view = furnaceCamera(kSize, kSize);
  for (const NamedGuide& guide : kUsualGuides) {
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, guide.guide, 2), {8, 16, 40});
    expectUsable(found, rendered, guide.name);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), 3.0, 3e-3, guide.name));
  }
  return found.outcome("mean right to %.2g", worst);
}

Outcome materialsRefused() {
  Findings found;
  Scene scene;
  must(awdNewScene(sceneDevice(), scene.out()));
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = HUGE_VALF;
  const auto refuse = [&](const char* what, float albedo, float emission) {
    AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
    desc.albedo[1] = albedo;
    desc.emission[2] = emission;
    const AWDResult result = awdAddMaterial(scene, &desc, nullptr);
    found.expect(result == AWD_ERROR_INVALID_ARGUMENT, "%s %g, %g: %s", what, albedo, emission,
                 awdGetResultString(result));
  };
  for (const float bad : {std::nextafter(1.0f, 2.0f), -1e-30f, nan, infinity, -infinity}) {
    refuse("albedo", bad, 1.0f);
  }
  for (const float bad : {-1e-30f, nan, infinity, -infinity}) refuse("emission", 0.5f, bad);
  const AWDMaterialDesc ends = {sizeof ends, {0.0f, 1.0f, 1e-45f}, {0.0f, 3.4e38f, 1e-45f}};
  found.expect(awdAddMaterial(scene, &ends, nullptr) == AWD_SUCCESS, "the ends: %s",
               awdGetLastErrorMessage());
  return found.outcome("AWD_ERROR_INVALID_ARGUMENT; the ends are taken");
}

Outcome furnaceOf(double radiance) {
  Findings found;
  double worst = 0.0;
  const Scene scene = furnace(0.5, 0.5 * radiance).commit(sceneDevice());
  const double truth = static_cast<double>(static_cast<float>(0.5 * radiance)) * 2.0;
  const AWDCamera view = furnaceCamera(kSize, kSize);
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, guide.guide, 3), {8, 16, 40});
    expectUsable(found, rendered, guide.name);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), truth, 3e-3, guide.name));
  }
  return found.outcome("mean right to %.2g", worst);
}

Outcome faintRadiance() { return furnaceOf(1e-30); }
Outcome brightRadiance() { return furnaceOf(1e30); }

/// A room of indirect light, its lamps times `factor`.
SceneBuilder scaledRoom(float factor) {
  SceneBuilder room;
  const uint32_t white = room.material(grey(0.75)), red = room.material({0.7f, 0.2f, 0.125f}),
                 lamp = room.material(grey(0.0), {8.0f * factor, 6.0f * factor, 5.0f * factor});
  room.box({0, 0, 0}, {4, 3, 4}, true, {white, red, white, white, red, white});
  room.quad({1, 2.5, 1}, {1, 2.5, 1.5}, {1.5, 2.5, 1.5}, {1.5, 2.5, 1}, lamp);
  room.quad({3, 2.5, 3}, {3, 2.5, 3.25}, {3.5, 2.5, 3.25}, {3.5, 2.5, 3}, lamp);
  return room;
}

Outcome scaledRadiance() {
  Findings found;
  const AWDCamera view = lampRoomCamera(kSize);
  for (const NamedGuide& guide : kGuides) {
    for (const AWDTarget target : {AWD_TARGET_MEAN, AWD_TARGET_RMS}) {
      std::vector<float> unit;
      for (const float factor : {1.0f, 0x1p100f, 0x1p-100f}) {
        const Scene scene = scaledRoom(factor).commit(sceneDevice());
        AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
        fieldDesc.target = target;
        Field field;
        if (guide.guide == AWD_GUIDE_ADAPTIVE) {
          must(awdNewSceneField(scene, &fieldDesc, field.out()));
        }
        RenderedFilm rendered =
            renderedFilm(scene, renderDesc(view, guide.guide, 4), {2, 2, 4}, field);
        expectUsable(found, rendered, guide.name);
        for (float& value : rendered.film.radiance) value /= factor;
        if (unit.empty()) unit = rendered.film.radiance;
        size_t apart = 0;
        for (size_t i = 0; i < unit.size(); ++i) apart += unit[i] != rendered.film.radiance[i];
        found.expect(apart == 0, "%s, target %d, times %g: %zu of %zu values differ", guide.name,
                     target, factor, apart, unit.size());
      }
    }
  }
  return found.outcome("the same bits");
}

Outcome overflow() {
  Findings found;
  uint64_t rejected = 0;
  const Scene scene = furnace(0.9, 3e38).commit(sceneDevice());
  const AWDCamera view = furnaceCamera(8, 8);
  for (const NamedGuide& guide : kGuides) {
    RenderedFilm rendered = renderedFilm(scene, renderDesc(view, guide.guide, 5), {4, 4, 8});
    rejected = rendered.statistics.rejectedSamples;
    found.expect(rejected > 0, "%s: nothing rejected", guide.name);
    found.expect(rendered.statistics.samples == 64 * 16, "%s: samples are missing", guide.name);
    rendered.statistics.rejectedSamples = 0;
    expectUsable(found, rendered, guide.name);
  }
  return found.outcome("%llu paths and records rejected",
                       static_cast<unsigned long long>(rejected));
}

}  // namespace

std::vector<Extreme> radianceExtremes() {
  return {
      {"albedo 0 everywhere", "the emission to the bit; no ray beyond the first", albedoZero},
      {"albedo 1, but for one black lamp", "a furnace: the lamp's radiance everywhere", albedoOne},
      {"albedo and emission out of range", "refused", materialsRefused},
      {"furnace of radiance 1e-30", "e / (1 - albedo)", faintRadiance},
      {"furnace of radiance 1e30", "e / (1 - albedo); variances finite", brightRadiance},
      {"radiance times 2^100 and 2^-100", "the same bits, scaled", scaledRadiance},
      {"radiance beyond floats", "rejected, counted; the film finite", overflow},
  };
}

}  // namespace awdtest

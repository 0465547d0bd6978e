// SPDX-License-Identifier: Apache-2.0
#include "awd/render.h"

#include <algorithm>

#include "api/field_maker.h"
#include "api/render_at_work.h"
#include "api/strides.h"
#include "render/schedule.h"

using namespace awd;

namespace {

/// With the scene's box and lights, where these are left open.
Ref<Field> makeSceneField(Scene& scene, AWDFieldDesc desc) {
  const AWDSceneInfo info = scene.geometry().info();
  if (load(desc.lower) == Vec3f{} && load(desc.upper) == Vec3f{}) {
    std::copy(info.lower, info.lower + 3, desc.lower);
    std::copy(info.upper, info.upper + 3, desc.upper);
  }
  const Lights& lights = scene.geometry().lights();
  std::pmr::vector<float> powers(scene.device().context().memory());
  if (desc.lightCount == 0 && lights.groups() > 1 && desc.preset != AWD_PRESET_PAPER) {
    for (uint32_t g = 0; g < lights.groups(); ++g) powers.push_back(lights.groupChance(g));
    desc.lightCount = lights.groups();
    desc.lightPowers = powers.data();
  }
  return makeField(scene.device(), desc);
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdNewRender(AWDScene scene, AWDField field, const AWDRenderDesc* desc,
                                AWDRender* render) noexcept {
  return guard(__func__, [&] {
    clearOutput(render, "render");
    Scene& known = object(scene, "scene");
    AWDRenderDesc settings = readStruct(desc, "desc", "AWD_RENDER_DESC_INIT");
    const AWDCamera camera = readStruct(settings.camera, "desc->camera", "AWD_CAMERA_INIT");
    settings.camera = &camera;
    settle(settings);  // bad settings are told before a field is made
    const Ref<Geometry> geometry = known.shareGeometry();
    if (field && &behind(field)->context() != &known.device().context()) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "field is of another device than scene");
    }
    const uint32_t groups = geometry->lights().groups();
    if (field && settings.lights == AWD_LIGHTS_LEARNED && behind(field)->lights() != groups) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->lights is AWD_LIGHTS_LEARNED: the scene has %u groups of lights, and field was "
           "made with lightCount %u",
           groups, behind(field)->lights());
    }
    Ref<Field> learner;
    if (settings.guide == AWD_GUIDE_ADAPTIVE) {
      AWDFieldDesc own = AWD_FIELD_DESC_INIT;
      own.preset = settings.preset;
      learner = field ? Ref<Field>::share(&idle(field, "field")) : makeSceneField(known, own);
    }
    give(render, Render::make(known.device().shareContext(), geometry, learner, settings));
  });
}

AWDResult AWD_CALL awdNewSceneField(AWDScene scene, const AWDFieldDesc* desc,
                                    AWDField* field) noexcept {
  return guard(__func__, [&] {
    clearOutput(field, "field");
    Scene& known = object(scene, "scene");
    known.geometry();  // fails unless the scene is committed
    AWDFieldDesc settings = AWD_FIELD_DESC_INIT;
    if (desc) settings = readStruct(desc, "desc", "AWD_FIELD_DESC_INIT");
    give(field, makeSceneField(known, settings));
  });
}

void AWD_CALL awdRetainRender(AWDRender render) noexcept {
  if (render) behind(render)->retain();
}

void AWD_CALL awdReleaseRender(AWDRender render) noexcept {
  if (render) behind(render)->release();
}

AWDResult AWD_CALL awdGetRenderField(AWDRender render, AWDField* field) noexcept {
  return guard(__func__, [&] {
    clearOutput(field, "field");
    give(field, object(render, "render").field());
  });
}

AWDResult AWD_CALL awdRenderPass(AWDRender render, uint32_t samplesPerPixel,
                                 AWDPassStatistics* statistics) noexcept {
  return guard(__func__, [&] {
    const RenderAtWork known(object(render, "render"));
    AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
    // A bad output struct must be found before anything is changed.
    if (statistics) writeStruct(statistics, figures, "statistics", "AWD_PASS_STATISTICS_INIT");
    figures = known->pass(samplesPerPixel);
    if (statistics) writeStruct(statistics, figures, "statistics", "AWD_PASS_STATISTICS_INIT");
  });
}

AWDResult AWD_CALL awdRenderPasses(AWDRender render, const AWDSchedule* schedule) noexcept {
  return guard(__func__, [&] {
    AWDSchedule known = AWD_SCHEDULE_INIT;
    if (schedule) known = readStruct(schedule, "schedule", "AWD_SCHEDULE_INIT");
    RenderAtWork(object(render, "render"))->passes(known);
  });
}

AWDResult AWD_CALL awdGetQualitySchedule(AWDQuality quality, AWDSchedule* schedule) noexcept {
  return guard(__func__, [&] {
    writeStruct(schedule, qualitySchedule(quality), "schedule", "AWD_SCHEDULE_INIT");
  });
}

AWDResult AWD_CALL awdGetPassCount(AWDRender render, uint32_t* count) noexcept {
  return guard(__func__, [&] {
    *need(count, "count") = static_cast<uint32_t>(object(render, "render").statistics().size());
  });
}

AWDResult AWD_CALL awdGetPassStatistics(AWDRender render, uint32_t index,
                                        AWDPassStatistics* statistics) noexcept {
  return guard(__func__, [&] {
    const auto& passes = object(render, "render").statistics();
    if (index >= passes.size()) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "index is %u: there are %zu passes", index, passes.size());
    }
    writeStruct(statistics, passes[index], "statistics", "AWD_PASS_STATISTICS_INIT");
  });
}

AWDResult AWD_CALL awdGetRenderStatistics(AWDRender render,
                                          AWDPassStatistics* statistics) noexcept {
  return guard(__func__, [&] {
    writeStruct(statistics, object(render, "render").total(), "statistics",
                "AWD_PASS_STATISTICS_INIT");
  });
}

AWDResult AWD_CALL awdReadFilm(AWDRender render, AWDFilmLayer layer, float* pixels,
                               size_t pixelStride, size_t rowStride) noexcept {
  return guard(__func__, [&] {
    const Film& film = object(render, "render").film();
    if (layer != AWD_FILM_RADIANCE && layer != AWD_FILM_VARIANCE) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "layer is %d: not an AWD_FILM_...", layer);
    }
    const Strides strides(pixelStride, rowStride, 3 * sizeof(float), film.width(), film.height());
    char* row = reinterpret_cast<char*>(need(pixels, "pixels"));
    for (size_t y = 0; y < film.height(); ++y, row += strides.row) {
      for (size_t x = 0; x < film.width(); ++x) {
        const size_t i = y * film.width() + x;
        const Rgb value = layer == AWD_FILM_RADIANCE ? film.mean(i) : film.variance(i);
        std::memcpy(row + x * strides.pixel, &value, 3 * sizeof(float));
      }
    }
  });
}

AWDResult AWD_CALL awdGetFilmInfo(AWDRender render, uint32_t* width, uint32_t* height,
                                  uint64_t* samplesPerPixel) noexcept {
  return guard(__func__, [&] {
    const Film& film = object(render, "render").film();
    if (width) *width = film.width();
    if (height) *height = film.height();
    if (samplesPerPixel) *samplesPerPixel = film.samples();
  });
}

AWDResult AWD_CALL awdGetRenderError(AWDRender render, AWDRenderError* error) noexcept {
  return guard(__func__, [&] {
    const FilmError known = object(render, "render").error();
    writeStruct(error, {sizeof(AWDRenderError), known.error, known.lower, known.upper}, "error",
                "AWD_RENDER_ERROR_INIT");
  });
}

AWDResult AWD_CALL awdGetPixelPatch(AWDRender render, uint32_t x, uint32_t y,
                                    uint32_t* patch) noexcept {
  return guard(__func__,
               [&] { *need(patch, "patch") = object(render, "render").pixelPatch(x, y); });
}

}  // extern "C"

// SPDX-License-Identifier: Apache-2.0
// How the functions of awd/render.h are called.
#include "misuse/functions.h"

namespace awdmisuse {

namespace {

/// Of 4 x 3 pixels.
constexpr size_t kWidth = 4, kHeight = 3;

const AWDRenderDesc* renderDesc(Caller& c, bool mayBeNull) {
  const AWDCamera* camera = c.desc<AWDCamera>(smallCamera(), [&](AWDCamera& wilder) {
    for (int i = 0; i < 3; ++i) {
      c.spoil(wilder.eye[i]);
      c.spoil(wilder.lookDir[i]);
      c.spoil(wilder.up[i]);
    }
    c.spoil(wilder.tanHalfFovX);
    // Never more pixels than there is room for where films are read.
    c.spoil(wilder.width, {0, 1, 3, 65537, UINT32_MAX});
    c.spoil(wilder.height, {0, 1, 2, 65537, UINT32_MAX});
  });
  AWDRenderDesc good = AWD_RENDER_DESC_INIT;
  good.seed = 1;
  return c.desc<AWDRenderDesc>(
      good,
      [&](AWDRenderDesc& desc) {
        desc.camera = camera;
        c.spoil(desc.preset);
        c.spoil(desc.guide);
        c.spoil(desc.direct);
        c.spoil(desc.roulette);
        c.spoil(desc.shadowRays, {1, 4, 1025, UINT32_MAX});
        c.spoil(desc.maxLights);
        c.spoil(desc.combination);
        c.spoil(desc.points);
        c.spoil(desc.maxBytes, {1, 1000, 100000, UINT64_MAX});
        c.spoil(desc.maxSplit, {1, 64, 65, UINT32_MAX});
        c.spoil(desc.lights);
      },
      mayBeNull);
}

const AWDSchedule* schedule(Caller& c) {
  return c.desc<AWDSchedule>(
      AWD_SCHEDULE_INIT,
      [&](AWDSchedule& desc) {
        static const uint32_t kPasses[] = {2, 2, 0};
        if (c.wild() && c.oneOf(2) == 0) {
          desc.totalSamples = 3;
        } else {
          desc.samplesPerPass = kPasses;
          desc.passCount = 2;
        }
        c.spoil(desc.passCount, {0, 1, 3});
        c.spoil(desc.totalSamples, {0, 1, 4});
        if (desc.totalSamples > 0) {
          c.spoil(desc.seconds, {-1.0, 0.001, 1e300});
          c.spoil(desc.error);
        }
        c.spoil(desc.resume);
        c.spoil(desc.maxPasses);
      },
      true);
}

/// Good calls go to a render of its own: one without passes, or of one pass and then perhaps a part
/// of the next.
enum class Had { kNothing, kPass, kPassAndPart };
Caller& atRender(Caller& c, Had had) {
  if (c.wild() || !c.world().renders) return c;
  World& world = c.world();
  const AWDCamera camera = smallCamera();
  const AWDRenderDesc desc = smallRender(camera);
  AWDRender render = nullptr;
  awdNewRender(world.scenes[0], nullptr, &desc, &render);
  if (!render) return c;
  world.renderers.push_back(render);
  const AWDSchedule passes = smallSchedule();
  uint32_t samples = 0;
  if (had != Had::kNothing) awdRenderPass(render, 2, nullptr);
  if (had == Had::kPassAndPart) awdRenderPassPart(render, &passes, 0, 1, &samples);
  return c.first(world.renderers.size() - 1);
}

void addRenderLife(std::vector<Function>& all) {
  const auto add = [&](const char* name, std::function<void(Caller&)> call) {
    all.push_back({name, std::move(call), true});
  };
  add("awdNewSceneField", [](Caller& c) {
    c(awdNewSceneField, Args{c.scene(), fieldDesc(c), c.made<AWDField>()});
  });
  add("awdNewRender", [](Caller& c) {
    const AWDScene scene = c.scene();
    const AWDField field = c.optional(c.field());
    c(awdNewRender, Args{scene, field, renderDesc(c, false), c.made<AWDRender>()});
  });
  add("awdRetainRender", [](Caller& c) { c.retained(awdRetainRender); });
  add("awdReleaseRender", [](Caller& c) { c.released(awdReleaseRender); });
  add("awdGetRenderField", [](Caller& c) {
    c(awdGetRenderField, Args{c.render(), c.made<AWDField>()});
  });
  add("awdSaveRender", [](Caller& c) {
    c(awdSaveRender, Args{atRender(c, Had::kPass).render(), c.outPath()});
  });
  add("awdLoadRender", [](Caller& c) {
    const AWDScene scene = c.scene();
    const char* path = c.path(c.world().renderFile);
    const AWDField field = c.optional(c.field());
    c(awdLoadRender, Args{scene, path, field, renderDesc(c, true), c.made<AWDRender>()});
  });
}

void addPasses(std::vector<Function>& all) {
  const auto add = [&](const char* name, std::function<void(Caller&)> call) {
    all.push_back({name, std::move(call), true});
  };
  const auto passStatistics = [](Caller& c, bool mayBeNull) {
    return c.outStruct<AWDPassStatistics>(AWD_PASS_STATISTICS_INIT, mayBeNull);
  };
  add("awdRenderPass", [=](Caller& c) {
    c(awdRenderPass,
      Args{c.render(), c.number<uint32_t>(1, {0, 1, 2, 3}), passStatistics(c, true)});
  });
  add("awdRenderPasses", [](Caller& c) { c(awdRenderPasses, Args{c.render(), schedule(c)}); });
  add("awdRenderPassPart", [](Caller& c) {
    c(awdRenderPassPart, Args{atRender(c, Had::kNothing).render(), schedule(c),
                              c.number<uint32_t>(0, {0, 1, UINT32_MAX}),
                              c.number<uint32_t>(1, {0, 1, 2, UINT32_MAX}), c.out<uint32_t>(1)});
  });
  add("awdExportPass", [](Caller& c) {
    const AWDRender render = atRender(c, Had::kPassAndPart).render();
    const size_t capacity = c.count(1 << 16);
    c(awdExportPass,
      Args{render, c.out<uint64_t>(capacity), capacity, c.out<size_t>(1), c.out<size_t>(1)});
  });
  add("awdImportPass", [=](Caller& c) {
    const AWDRender render = atRender(c, Had::kPassAndPart).render();
    size_t count = 0;
    const uint64_t* numbers = c.bytes(c.world().passNumbers, count);
    c(awdImportPass, Args{render, numbers, count, passStatistics(c, true)});
  });
  add("awdGetQualitySchedule", [](Caller& c) {
    c(awdGetQualitySchedule,
      Args{c.number<int32_t>(AWD_QUALITY_DRAFT), c.outStruct<AWDSchedule>(AWD_SCHEDULE_INIT)});
  });
}

void addResults(std::vector<Function>& all) {
  const auto add = [&](const char* name, std::function<void(Caller&)> call) {
    all.push_back({name, std::move(call), true});
  };
  add("awdGetPassCount", [](Caller& c) {
    c(awdGetPassCount, Args{c.render(), c.out<uint32_t>(1)});
  });
  add("awdGetPassStatistics", [](Caller& c) {
    c(awdGetPassStatistics, Args{c.render(), c.number<uint32_t>(0),
                                 c.outStruct<AWDPassStatistics>(AWD_PASS_STATISTICS_INIT)});
  });
  add("awdGetRenderStatistics", [](Caller& c) {
    c(awdGetRenderStatistics,
      Args{c.render(), c.outStruct<AWDPassStatistics>(AWD_PASS_STATISTICS_INIT)});
  });
  add("awdReadFilm", [](Caller& c) {
    const AWDRender render = c.render();
    const int32_t layer = c.number<int32_t>(AWD_FILM_VARIANCE);
    const size_t pixel = c.number<size_t>(16, {0, 1, 12, 13, SIZE_MAX});
    const size_t row = c.number<size_t>(70, {0, 1, 48, 64, SIZE_MAX});
    c(awdReadFilm, Args{render, layer, c.out<float>(kHeight * 100), pixel, row});
  });
  add("awdGetFilmInfo", [](Caller& c) {
    c(awdGetFilmInfo, Args{c.render(), c.out<uint32_t>(1, true), c.out<uint32_t>(1, true),
                           c.out<uint64_t>(1, true)});
  });
  add("awdGetRenderError", [](Caller& c) {
    c(awdGetRenderError, Args{c.render(), c.outStruct<AWDRenderError>(AWD_RENDER_ERROR_INIT)});
  });
  add("awdGetPixelPatch", [](Caller& c) {
    c(awdGetPixelPatch, Args{c.render(), c.number<uint32_t>(kWidth - 1),
                             c.number<uint32_t>(kHeight - 1), c.out<uint32_t>(1)});
  });
}

}  // namespace

void addRenderFunctions(std::vector<Function>& all) {
  addRenderLife(all);
  addPasses(all);
  addResults(all);
}

}  // namespace awdmisuse

// SPDX-License-Identifier: Apache-2.0
#include "misuse/structs.h"

#include <cstring>
#include <fstream>
#include <iterator>

#include "support/handles.h"

namespace awdmisuse {

namespace {

using awdtest::must;

template <class T>
std::vector<char> bytesOf(const T& value) {
  std::vector<char> bytes(sizeof value);
  std::memcpy(bytes.data(), static_cast<const void*>(&value), sizeof value);
  return bytes;
}

// --- what can be seen of objects
// ------------------------------------------------------------------

template <class Add>
void addField(AWDField field, Add&& add) {
  size_t size = 0;
  must(awdSaveField(field, nullptr, 0, &size));
  std::vector<char> bytes(size);
  must(awdSaveField(field, bytes.data(), size, &size));
  add(bytes.data(), size);
}

template <class Add>
void addFilm(AWDRender render, Add&& add) {
  uint32_t width = 0, height = 0, passes = 0;
  must(awdGetFilmInfo(render, &width, &height, nullptr));
  std::vector<float> film(size_t{3} * width * height);
  must(awdReadFilm(render, AWD_FILM_RADIANCE, film.data(), 0, 0));
  add(film.data(), film.size() * sizeof(float));
  must(awdGetPassCount(render, &passes));
  add(&passes, sizeof passes);
}

template <class Add>
void addScene(AWDScene scene, Add&& add) {
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  add(&info, sizeof info);
  const AWDCamera camera = smallCamera();
  const AWDRenderDesc desc = smallRender(camera);
  awdtest::Render render;
  must(awdNewRender(scene, nullptr, &desc, render.out()));
  must(awdRenderPass(render, 2, nullptr));
  addFilm(render, add);
}

// --- good ones
// ------------------------------------------------------------------------------------

AWDDensityDesc densityWithAll() {
  static const AWDDensityAxis kAxes[2] = {{"m2", AWD_LEVEL(1), AWD_LEVEL(2)}, {"haar", 0, 0}};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 2;
  desc.structure = AWD_STRUCTURE_GRID;
  desc.axes = kAxes;
  desc.estimator = AWD_ESTIMATOR_RATIO;
  desc.target = AWD_TARGET_RMS;
  desc.sampler = AWD_SAMPLER_COMPONENT;
  desc.combination = AWD_COMBINE_CROSS_VARIANCE;
  desc.tau = 0.05;
  desc.shrinkage = 0.25;
  desc.passSamples = 100;
  desc.maxCoefficients = 64;
  desc.refitBytes = 100000;
  return desc;
}

AWDFieldDesc fieldWithAll() {
  static const float kPowers[] = {1.0f, 3.0f};
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.preset = AWD_PRESET_PAPER;
  desc.map = AWD_MAP_COSINE;
  desc.basis = "m2";
  desc.startLevel = AWD_LEVEL(1);
  desc.maxLevel = AWD_LEVEL(2);
  desc.tau = 0.02;
  desc.estimator = AWD_ESTIMATOR_LUMPED;
  desc.shrinkage = 0.25;
  desc.patches = AWD_PATCHES_SPATIAL;
  for (int i = 0; i < 3; ++i) desc.upper[i] = 2.0f;
  desc.patchSamples = 100;
  desc.alpha = 0.3;
  desc.maxBytes = 1 << 20;
  desc.lightCount = 2;
  desc.lightPowers = kPowers;
  desc.target = AWD_TARGET_RMS;
  return desc;
}

AWDRenderDesc renderWithAll() {
  static const AWDCamera kCamera = smallCamera();
  AWDRenderDesc desc = smallRender(kCamera);
  desc.preset = AWD_PRESET_PAPER;
  desc.guide = AWD_GUIDE_COSINE;
  desc.direct = AWD_DIRECT_WEIGHTED;
  desc.roulette = AWD_ROULETTE_THROUGHPUT;
  desc.shadowRays = 2;
  desc.maxLights = 3;
  desc.seed = 7;
  desc.combination = AWD_COMBINE_EXPERIENCE;
  desc.points = AWD_POINTS_SOBOL;
  desc.maxBytes = 1 << 20;
  desc.maxSplit = 2;
  desc.lights = AWD_LIGHTS_POWER;
  return desc;
}

AWDMaterialDesc materialWithAll() {
  AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
  for (int i = 0; i < 3; ++i) desc.albedo[i] = desc.emission[i] = 0.25f * static_cast<float>(i + 1);
  return desc;
}

AWDMeshDesc meshWithAll() {
  static const uint32_t kPatches[] = {5, 6, 7};
  AWDMeshDesc desc = smallMesh();
  desc.patches = {kPatches, 0u, 0u, 3u, AWD_FORMAT_UINT, 0u};
  desc.material = 1;
  return desc;
}

AWDSchedule scheduleWithAll() {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = 4;
  schedule.seconds = 1000.0;
  schedule.error = 1e-9;
  schedule.maxPasses = 2;
  return schedule;
}

// --- what comes of them
// ---------------------------------------------------------------------------

Seen seeDevice(World&, const void* desc) {
  awdtest::Device device;
  return seen(awdNewDevice(static_cast<const AWDDeviceDesc*>(desc), device.out()), [&](auto&& add) {
    const std::vector<double> bits = referenceBits(device);
    add(bits.data(), bits.size() * sizeof(double));
  });
}

Seen seeDensity(World& world, const void* desc) {
  AWDDensity density = nullptr;
  return seen(awdNewDensity(world.devices[0], static_cast<const AWDDensityDesc*>(desc), &density),
              [&](auto&& add) {
                size_t size = 0;
                must(awdSaveDensity(density, nullptr, 0, &size));
                std::vector<char> bytes(size);
                must(awdSaveDensity(density, bytes.data(), size, &size));
                awdReleaseDensity(density);
                add(bytes.data(), size);
              });
}

Seen seeField(World& world, const void* desc) {
  awdtest::Field field;
  return seen(awdNewField(world.devices[0], static_cast<const AWDFieldDesc*>(desc), field.out()),
              [&](auto&& add) { addField(field, add); });
}

Seen seeMaterial(World& world, const void* desc) {
  awdtest::Scene scene;
  must(awdNewScene(world.devices[0], scene.out()));
  uint32_t number = 0;
  const auto* known = static_cast<const AWDMaterialDesc*>(desc);
  return seen(awdAddMaterial(scene, known, &number), [&](auto&& add) {
    must(awdAddMaterial(scene, known, &number));
    const AWDMeshDesc mesh = smallMesh();
    must(awdAddMesh(scene, &mesh, nullptr));
    must(awdCommitScene(scene));
    addScene(scene, add);
  });
}

Seen seeMesh(World& world, const void* desc) {
  awdtest::Scene scene;
  must(awdNewScene(world.devices[0], scene.out()));
  const AWDMaterialDesc material = materialWithAll();
  for (int i = 0; i < 2; ++i) must(awdAddMaterial(scene, &material, nullptr));
  AWDResult result = awdAddMesh(scene, static_cast<const AWDMeshDesc*>(desc), nullptr);
  if (result == AWD_SUCCESS) result = awdCommitScene(scene);
  return seen(result, [&](auto&& add) { addScene(scene, add); });
}

Seen seeRenderOf(World& world, const AWDRenderDesc& desc) {
  awdtest::Render render;
  return seen(awdNewRender(world.scenes[0], nullptr, &desc, render.out()), [&](auto&& add) {
    must(awdRenderPass(render, 8, nullptr));
    must(awdRenderPass(render, 8, nullptr));
    addFilm(render, add);
  });
}

Seen seeRender(World& world, const void* desc) {
  awdtest::Render render;
  const auto* known = static_cast<const AWDRenderDesc*>(desc);
  return seen(awdNewRender(world.scenes[0], nullptr, known, render.out()), [&](auto&& add) {
    must(awdRenderPass(render, 8, nullptr));
    must(awdRenderPass(render, 8, nullptr));
    addFilm(render, add);
  });
}

Seen seeCamera(World& world, const void* camera) {
  const AWDRenderDesc desc = smallRender(*static_cast<const AWDCamera*>(camera));
  return seeRenderOf(world, desc);
}

Seen seeSchedule(World& world, const void* desc) {
  const AWDCamera camera = smallCamera();
  const AWDRenderDesc renderDesc = smallRender(camera);
  awdtest::Render render;
  must(awdNewRender(world.scenes[0], nullptr, &renderDesc, render.out()));
  return seen(awdRenderPasses(render, static_cast<const AWDSchedule*>(desc)),
              [&](auto&& add) { addFilm(render, add); });
}

Seen seePng(World& world, const void* desc) {
  const std::string path = world.folder.path("growth.png");
  return seen(awdWriteImagePNG(world.images[0], path.c_str(), static_cast<const AWDPNGDesc*>(desc)),
              [&](auto&& add) {
                std::ifstream file(path, std::ios::binary);
                const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
                add(bytes.data(), bytes.size());
              });
}

AWDDeviceDesc deviceWithAll() {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;
  desc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  desc.log = [](void*, int32_t, const char*) {};
  desc.logUser = &desc;
  desc.progress = [](void*, const AWDProgress* progress) -> int32_t {
    return progress->structSize == sizeof(AWDProgress);
  };
  desc.alloc = [](void*, size_t size, size_t alignment) -> void* {
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  };
  desc.free = [](void*, void* ptr, size_t, size_t) { std::free(ptr); };
  desc.allocUser = desc.progressUser = desc.parallelForUser = nullptr;
  desc.logUser = nullptr;
  desc.parallelFor = [](void*, size_t count, AWDTaskFn task, void* data) {
    for (size_t i = 0; i < count; ++i) task(data, i);
  };
  static const char* const kFolders[] = {"/nowhere"};
  desc.basisPaths = kFolders;
  desc.basisPathCount = 1;
  return desc;
}

AWDPNGDesc pngWithAll() {
  AWDPNGDesc desc = AWD_PNG_DESC_INIT;
  desc.exposure = 1.5f;
  return desc;
}

/// An output of a function of one handle.
template <class H, class T>
Output of(const char* name, AWDResult (*function)(H, T*) noexcept, bool changes = false) {
  return {name, sizeof(T),
          [function](World& world, void* out) {
            return function(world.pool<H>()[0], static_cast<T*>(out));
          },
          changes};
}

/// Of one handle and a number.
template <class H, class N, class T>
Output of(const char* name, AWDResult (*function)(H, N, T*) noexcept, N number,
          bool changes = false) {
  return {name, sizeof(T),
          [function, number](World& world, void* out) {
            return function(world.pool<H>()[0], number, static_cast<T*>(out));
          },
          changes};
}

}  // namespace

const std::vector<Input>& allInputs() {
  static const std::vector<Input> kAll = {
      {"AWDDeviceDesc", bytesOf(deviceWithAll()), seeDevice},
      {"AWDDensityDesc", bytesOf(densityWithAll()), seeDensity},
      {"AWDFieldDesc", bytesOf(fieldWithAll()), seeField},
      {"AWDMaterialDesc", bytesOf(materialWithAll()), seeMaterial},
      {"AWDMeshDesc", bytesOf(meshWithAll()), seeMesh},
      {"AWDCamera", bytesOf(smallCamera()), seeCamera},
      {"AWDRenderDesc", bytesOf(renderWithAll()), seeRender},
      {"AWDSchedule", bytesOf(scheduleWithAll()), seeSchedule},
      {"AWDPNGDesc", bytesOf(pngWithAll()), seePng},
  };
  return kAll;
}

const std::vector<Output>& allOutputs() {
  static const std::vector<Output> kAll = {
      of("AWDBasisInfo", awdGetBasisInfo, size_t{0}),
      of("AWDDensityEstimate", awdGetDensityEstimate),
      of("AWDDensityInfo", awdGetDensityInfo),
      of("AWDDensityAxisInfo", awdGetDensityAxisInfo, 0u),
      of("AWDDensityReport", awdAdaptDensity, true),
      of("AWDFieldStatistics", awdGetFieldStatistics),
      of("AWDFieldStatistics", awdAdaptField, true),
      of("AWDPatchInfo", awdGetPatchInfo, 0u),
      of("AWDSceneInfo", awdGetSceneInfo),
      of("AWDPassStatistics", awdGetPassStatistics, 0u),
      of("AWDPassStatistics", awdGetRenderStatistics),
      of("AWDPassStatistics", awdRenderPass, 2u, true),
      of("AWDRenderError", awdGetRenderError),
      {"AWDSchedule", sizeof(AWDSchedule),
       [](World&, void* out) {
         return awdGetQualitySchedule(AWD_QUALITY_FINE, static_cast<AWDSchedule*>(out));
       }},
      {"AWDPassStatistics", sizeof(AWDPassStatistics),
       [](World& world, void* out) {
         const AWDRender render = world.renderers[0];
         const AWDSchedule schedule = smallSchedule();
         uint32_t samples = 0;
         size_t sums = 0, maxima = 0;
         AWDSchedule rest = schedule;
         uint32_t passes = 0;
         must(awdGetPassCount(render, &passes));
         static const std::vector<uint32_t> kSizes(1000, 2);
         rest.samplesPerPass = kSizes.data();
         rest.passCount = passes + 1;
         must(awdRenderPassPart(render, &rest, 0, 1, &samples));
         must(awdExportPass(render, nullptr, 0, &sums, &maxima));
         std::vector<uint64_t> numbers(sums + maxima);
         must(awdExportPass(render, numbers.data(), numbers.size(), &sums, &maxima));
         return awdImportPass(render, numbers.data(), numbers.size(),
                              static_cast<AWDPassStatistics*>(out));
       },
       true},
  };
  return kAll;
}

const std::vector<Fixed>& allFixed() {
  static const std::vector<Fixed> kAll = {
      {"AWDDensityAxis", sizeof(AWDDensityAxis), 16},
      {"AWDBuffer", sizeof(AWDBuffer), 40},
      {"AWDRay", sizeof(AWDRay), 32},
      {"AWDHit", sizeof(AWDHit), 40},
      {"AWDDirectionSample", sizeof(AWDDirectionSample), 32},
      {"AWDPathVertex", sizeof(AWDPathVertex), 76},
  };
  return kAll;
}

}  // namespace awdmisuse

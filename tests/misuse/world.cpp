// SPDX-License-Identifier: Apache-2.0
#include "misuse/world.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "support/handles.h"

namespace awdmisuse {

namespace {

using awdtest::must;

constexpr size_t kMostBytes = size_t{64} << 20;

const float kVertices[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1};
const uint32_t kIndices[] = {0, 1, 2, 0, 2, 3, 0, 5, 4};
const uint32_t kMaterials[] = {0, 0, 1};

AWDScene smallScene(AWDDevice device) {
  AWDScene scene = nullptr;
  must(awdNewScene(device, &scene));
  AWDMaterialDesc material = AWD_MATERIAL_DESC_INIT;
  material.albedo[0] = material.albedo[1] = material.albedo[2] = 0.5f;
  must(awdAddMaterial(scene, &material, nullptr));
  material.emission[0] = material.emission[1] = material.emission[2] = 2.0f;
  must(awdAddMaterial(scene, &material, nullptr));
  const AWDMeshDesc mesh = smallMesh();
  must(awdAddMesh(scene, &mesh, nullptr));
  must(awdCommitScene(scene));
  return scene;
}

AWDDensity smallDensity(AWDDevice device, AWDDensityStructure structure) {
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 2;
  desc.structure = structure;
  desc.maxCoefficients = 1024;
  AWDDensity density = nullptr;
  must(awdNewDensity(device, &desc, &density));
  return density;
}

std::vector<double> densityBits(AWDDevice device) {
  const AWDDensity density = smallDensity(device, AWD_STRUCTURE_TREE);
  double uniforms[64], points[64], values[32];
  for (int i = 0; i < 64; ++i) uniforms[i] = (i * 37 % 64 + 0.5) / 64.0;
  must(awdSampleDensity(density, 32, uniforms, points, nullptr, nullptr));
  for (int i = 0; i < 32; ++i) values[i] = points[2 * i] * points[2 * i];
  must(awdRecordDensity(density, 32, points, nullptr, nullptr, values));
  must(awdAdaptDensity(density, nullptr));
  must(awdSampleDensity(density, 32, uniforms, points, values, nullptr));
  awdReleaseDensity(density);
  std::vector<double> bits(std::begin(points), std::end(points));
  bits.insert(bits.end(), std::begin(values), std::end(values));
  return bits;
}

}  // namespace

AWDDeviceDesc SmallMemory::desc(uint32_t threads) {
  inner_ = counter_.desc(threads);
  AWDDeviceDesc result = inner_;
  result.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  // An old host's desc ends before allocUser.
  result.alloc = [](void* user, size_t size, size_t alignment) -> void* {
    if (!user) return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    const AWDDeviceDesc& inner = static_cast<SmallMemory*>(user)->inner_;
    return size > kMostBytes ? nullptr : inner.alloc(inner.allocUser, size, alignment);
  };
  result.free = [](void* user, void* ptr, size_t size, size_t alignment) {
    if (!user) return std::free(ptr);
    const AWDDeviceDesc& inner = static_cast<SmallMemory*>(user)->inner_;
    inner.free(inner.allocUser, ptr, size, alignment);
  };
  result.allocUser = this;
  return result;
}

AWDMeshDesc smallMesh() {
  AWDMeshDesc desc = AWD_MESH_DESC_INIT;
  desc.vertices = {kVertices, 0u, 0u, 6u, AWD_FORMAT_FLOAT3, 0u};
  desc.indices = {kIndices, 0u, 0u, 3u, AWD_FORMAT_UINT3, 0u};
  desc.materials = {kMaterials, 0u, 0u, 3u, AWD_FORMAT_UINT, 0u};
  return desc;
}

AWDCamera smallCamera() {
  AWDCamera camera = AWD_CAMERA_INIT;
  camera.eye[0] = camera.eye[1] = 0.5f;
  camera.eye[2] = 2.0f;
  camera.width = 4;
  camera.height = 3;
  return camera;
}

AWDSchedule smallSchedule() {
  static const uint32_t kPasses[] = {2, 2};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = kPasses;
  schedule.passCount = 2;
  return schedule;
}

AWDRenderDesc smallRender(const AWDCamera& camera) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.camera = &camera;
  desc.seed = 1;
  return desc;
}

std::vector<double> referenceBits(AWDDevice device) {
  std::vector<double> bits = densityBits(device);
  if (!AWD_TEST_RENDERER) return bits;
  const awdtest::Scene scene(smallScene(device));
  const AWDCamera camera = smallCamera();
  const AWDRenderDesc desc = smallRender(camera);
  awdtest::Render render;
  must(awdNewRender(scene, nullptr, &desc, render.out()));
  const uint32_t passes[] = {1, 2};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = passes;
  schedule.passCount = 2;
  must(awdRenderPasses(render, &schedule));
  float film[3 * 4 * 3];
  must(awdReadFilm(render, AWD_FILM_RADIANCE, film, 0, 0));
  bits.insert(bits.end(), std::begin(film), std::end(film));
  return bits;
}

World::World() : renders(AWD_TEST_RENDERER), modulePath(AWD_TEST_MODULE) {
  AWDDeviceDesc desc = memory.desc(1);
  for (int i = 0; i < 2; ++i) {
    if (i == 1) {
      desc = others.desc(1);
      desc.progressUser = this;
      desc.progress = [](void* user, const AWDProgress*) -> int32_t {
        long& left = static_cast<World*>(user)->cancelAfter;
        return left < 0 || left-- > 0;
      };
    }
    AWDDevice device = nullptr;
    must(awdNewDevice(&desc, &device));
    devices.push_back(device);
    makeObjects(device);
  }
  saveObjects();
}

World::World(World& shared)
    : fieldFile(shared.fieldFile),
      renderFile(shared.renderFile),
      imageFile(shared.imageFile),
      rubbishFile(shared.rubbishFile),
      fieldBytes(shared.fieldBytes),
      densityBytes(shared.densityBytes),
      statisticsBytes(shared.statisticsBytes),
      fieldNumbers(shared.fieldNumbers),
      passNumbers(shared.passNumbers),
      registered(shared.registered),
      renders(shared.renders),
      modulePath(shared.modulePath),
      devices(shared.devices),
      scenes(shared.scenes),
      fields(shared.fields),
      densities(shared.densities),
      renderers(shared.renderers),
      images(shared.images) {
  const auto share = [](const auto& pool) {
    for (const auto handle : pool) retain(handle);
  };
  share(devices), share(scenes), share(fields), share(densities), share(renderers), share(images);
}

void World::makeObjects(AWDDevice device) {
  AWDField field = nullptr;
  AWDFieldDesc spatial = AWD_FIELD_DESC_INIT;
  for (float& upper : spatial.upper) upper = 2.0f;
  if (renders) scenes.push_back(smallScene(device));
  must(renders ? awdNewSceneField(scenes.back(), nullptr, &field)
               : awdNewField(device, &spatial, &field));
  fields.push_back(field);
  AWDFieldDesc own = AWD_FIELD_DESC_INIT;
  const float powers[] = {1.0f, 2.0f, 0.0f};
  own.lightCount = 3;
  own.lightPowers = powers;
  own.patches = AWD_PATCHES_HOST;
  must(awdNewField(device, &own, &field));
  fields.push_back(field);
  densities.push_back(smallDensity(device, AWD_STRUCTURE_GRID));
  densities.push_back(smallDensity(device, AWD_STRUCTURE_TREE));
  if (!renders) return;
  const AWDCamera camera = smallCamera();
  const AWDRenderDesc desc = smallRender(camera);
  AWDRender render = nullptr;
  must(awdNewRender(scenes.back(), nullptr, &desc, &render));
  renderers.push_back(render);
  must(awdRenderPass(render, 2, nullptr));
  AWDImage image = nullptr;
  must(awdNewFilmImage(render, &image));
  must(awdSetImageMetadata(image, "key", "value"));
  images.push_back(image);
}

void World::saveObjects() {
  fieldFile = folder.path("field.awd");
  renderFile = folder.path("render.awd");
  imageFile = folder.path("image.exr");
  rubbishFile = folder.path("rubbish");
  std::ofstream(rubbishFile) << std::string(1000, 'r');
  must(awdWriteField(fields[1], fieldFile.c_str()));
  if (renders) saveRender();
  size_t size = 0, maxima = 0;
  must(awdSaveField(fields[1], nullptr, 0, &size));
  fieldBytes.resize(size);
  must(awdSaveField(fields[1], fieldBytes.data(), size, &size));
  must(awdSaveDensity(densities[0], nullptr, 0, &size));
  densityBytes.resize(size);
  must(awdSaveDensity(densities[0], densityBytes.data(), size, &size));
  must(awdExportDensityStatistics(densities[0], nullptr, 0, &size));
  statisticsBytes.resize(size);
  must(awdExportDensityStatistics(densities[0], statisticsBytes.data(), size, &size));
  must(awdExportField(fields[1], nullptr, 0, nullptr, 0, &size, &maxima));
  fieldNumbers.resize(size + maxima);
  must(awdExportField(fields[1], nullptr, 0, fieldNumbers.data(), size + maxima, &size, &maxima));
  void* library = dlopen(modulePath.c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto entry =
      reinterpret_cast<AWDBasisModuleFn>(library ? dlsym(library, "awdBasisModule_v1") : nullptr);
  if (!entry) throw std::runtime_error("no module at " + modulePath);
  const AWDBasisHost host = {sizeof host, AWD_BASIS_ABI, AWD_VERSION};
  module = *entry(&host);
  family = *module.families[0];
  family.name = "misuse";
  module.familyCount = 1;
  module.families = families;
}

void World::saveRender() {
  must(awdSaveRender(renderers[0], renderFile.c_str()));
  must(awdWriteImageEXR(images[0], imageFile.c_str()));
  size_t size = 0, maxima = 0;
  const AWDSchedule schedule = smallSchedule();
  uint32_t samples = 0;
  must(awdRenderPassPart(renderers[0], &schedule, 0, 1, &samples));
  must(awdExportPass(renderers[0], nullptr, 0, &size, &maxima));
  passNumbers.resize(size + maxima);
  must(awdExportPass(renderers[0], passNumbers.data(), size + maxima, &size, &maxima));
}

void World::release() {
  const auto drop = [](auto& pool, size_t kept) {
    while (pool.size() > kept) {
      awdmisuse::release(pool.back());
      pool.pop_back();
    }
  };
  drop(renderers, 0), drop(images, 0), drop(fields, 0), drop(densities, 0), drop(scenes, 0);
  drop(devices, 1);
}

size_t World::references() const {
  return devices.size() + scenes.size() + fields.size() + densities.size() + renderers.size() +
         images.size();
}

World::~World() {
  release();
  for (const AWDDevice device : devices) awdReleaseDevice(device);
}

}  // namespace awdmisuse

// SPDX-License-Identifier: Apache-2.0
#include "render_shots.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "camera_choice.h"
#include "scene_loader.h"
#include "support/handles.h"
#include "support/random.h"
#include "upload.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using awdtest::must;

constexpr uint64_t kReferenceSeed = 1000003;

/// Null: cancelled.
awdtest::Render renderOf(const LoadedScene& loaded, AWDField field, const Settings& settings) {
  awdtest::Render render;
  must(awdNewRender(loaded.scene.get(), field, &settings.render, render.out()));
  const AWDResult result = awdRenderPasses(render, &settings.schedule);
  if (result == AWD_ERROR_CANCELLED) return {};
  must(result);
  return render;
}

void set(Settings& settings, const LoadedScene& loaded, uint32_t samples, uint64_t seed) {
  settings.render.camera = &loaded.camera;
  settings.render.seed = seed;
  settings.schedule.totalSamples = samples;
}

/// 95 % interval of the median of ratios, by bootstrap.
Spread ratioSpread(const std::vector<double>& ratios) {
  constexpr int kResamples = 2000;
  awdtest::Random random(1);
  std::vector<double> medians, resample(ratios.size());
  for (int i = 0; i < kResamples; ++i) {
    for (double& ratio : resample) {
      ratio =
          ratios[static_cast<std::size_t>(random.uniform() * static_cast<double>(ratios.size()))];
    }
    medians.push_back(spreadOf(resample).median);
  }
  std::sort(medians.begin(), medians.end());
  return {spreadOf(ratios).median, medians[kResamples / 40], medians[kResamples - kResamples / 40]};
}

}  // namespace

awd::Device newRenderDevice(uint32_t threads, Cancelled cancelled) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = threads;
  desc.progress = [](void* user, const AWDProgress*) -> int32_t {
    return reinterpret_cast<Cancelled>(user)() ? 0 : 1;
  };
  desc.progressUser = reinterpret_cast<void*>(cancelled);
  awd::Device device = awd::Device::create(desc);
  device.loadBasisModule(AWD_BENCH_CUBIC);
  return device;
}

std::map<std::string, std::string> sceneFiles(const std::string& moreScenes) {
  std::map<std::string, std::string> files;
  for (const std::string& root : {std::string(AWD_BENCH_SCENES), moreScenes}) {
    if (root.empty()) continue;
    if (!fs::is_directory(root)) throw std::runtime_error("no folder of scenes: " + root);
    for (const fs::directory_entry& folder : fs::directory_iterator(root)) {
      if (!folder.is_directory()) continue;
      for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
        const std::string extension = file.path().extension().string();
        if (extension != ".obj" && extension != ".gltf" && extension != ".glb") continue;
        files[folder.path().filename().string()] = file.path().string();
      }
    }
  }
  return files;
}

LoadedScene loadScene(const awd::Device& device, const std::string& name, const std::string& file,
                      uint32_t width) {
  LoadedScene loaded;
  loaded.name = name;
  loaded.file = file;
  const command::SceneData data = command::loadScene(file);
  loaded.camera = command::chooseCamera({}, file, data);
  command::resize(loaded.camera, width, {});
  loaded.scene = command::uploadScene(device, data, file);
  must(awdCommitScene(loaded.scene.get()));
  return loaded;
}

bool takeReference(const awd::Device& device, const std::string& folder, uint32_t samples,
                   LoadedScene& loaded) {
  if (auto committed = committedReference(device.get(), loaded.file, loaded.camera)) {
    loaded.reference = std::move(*committed);
    return true;
  }
  const std::string name = "reference-" + loaded.name + "-" + std::to_string(loaded.camera.width) +
                           "x" + std::to_string(loaded.camera.height) + "-" +
                           std::to_string(samples) + ".exr";
  const std::string path = (fs::path(folder) / name).string();
  if (!fs::exists(path)) {
    Settings settings;
    settings.render.guide = AWD_GUIDE_COSINE;
    set(settings, loaded, samples, kReferenceSeed);
    const awdtest::Render render = renderOf(loaded, nullptr, settings);
    if (!render) return false;
    awdtest::Image film;
    must(awdNewFilmImage(render, film.out()));
    must(awdWriteImageEXR(film, path.c_str()));
  }
  loaded.reference = readFilm(device.get(), path);
  return true;
}

bool shoot(const LoadedScene& loaded, Settings settings, uint32_t samples, uint64_t seed,
           Shot& shot) {
  set(settings, loaded, samples, seed);
  std::vector<uint32_t> passes;
  if (settings.equalPasses > 0) {
    const uint32_t count = std::min(settings.equalPasses, samples);
    passes.assign(count, samples / count);
    passes.back() += samples % count;
    settings.schedule.samplesPerPass = passes.data();
    settings.schedule.passCount = count;
    settings.schedule.totalSamples = 0;
  }
  awdtest::Field field;
  if (settings.render.guide == AWD_GUIDE_ADAPTIVE) {
    must(awdNewSceneField(loaded.scene.get(), &settings.field, field.out()));
  }
  const awdtest::Render render = renderOf(loaded, field, settings);
  if (!render) return false;
  command::RgbImage image = {loaded.camera.width, loaded.camera.height, {}};
  image.values.resize(loaded.reference.mean.values.size());
  must(awdReadFilm(render, AWD_FILM_RADIANCE, image.values.data(), 0, 0));
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  must(awdGetRenderStatistics(render, &statistics));
  const command::Metrics metrics =
      command::compareImages(image, loaded.reference.mean, loaded.reference.variance);
  shot = {metrics.relMse,
          metrics.relMseTrimmed,
          metrics.l1,
          statistics.cpuSeconds,
          static_cast<double>(statistics.rays),
          static_cast<double>(statistics.patches),
          static_cast<double>(statistics.coefficients),
          static_cast<double>(statistics.bytes),
          std::move(image)};
  return true;
}

double efficiency(const Shot& shot) { return 1.0 / (shot.relMseTrimmed * shot.cpuSeconds); }
double untrimmedEfficiency(const Shot& shot) { return 1.0 / (shot.relMse * shot.cpuSeconds); }
double l1Efficiency(const Shot& shot) { return 1.0 / (shot.l1 * shot.l1 * shot.cpuSeconds); }
double rayRate(const Shot& shot) { return shot.rays / shot.cpuSeconds; }

Spread spreadOf(const std::vector<Shot>& shots, Figure figure) {
  std::vector<double> values(shots.size());
  std::transform(shots.begin(), shots.end(), values.begin(), figure);
  return spreadOf(values);
}

std::optional<Spread> ratioOf(const std::vector<Shot>& shots, const std::vector<Shot>& base,
                              Figure figure) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(shots.size(), base.size()); ++i) {
    const double above = figure(shots[i]), below = figure(base[i]);
    if (!(above > 0.0 && below > 0.0)) return std::nullopt;
    ratios.push_back(above / below);
  }
  if (ratios.empty()) return std::nullopt;
  return ratioSpread(ratios);
}

}  // namespace bench

// SPDX-License-Identifier: Apache-2.0
#include "refit_scenes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "camera_choice.h"
#include "metrics.h"
#include "scene_loader.h"
#include "support/handles.h"
#include "upload.h"

namespace bench::refit {
namespace {

namespace fs = std::filesystem;
using awdtest::must;
using command::RgbImage;

constexpr uint32_t kWidth = 64, kQuickWidth = 32;  // pixels
constexpr uint64_t kReferenceSeed = 1000003;
/// Ceres takes so much longer that it gets the first seeds and one basis alone.
constexpr int kCeresSeeds = 2;
constexpr const char* kBases[] = {"haar", "linear-bspline"};

struct Loaded {
  std::string name;
  command::Scene scene;
  AWDCamera camera = AWD_CAMERA_INIT;
  RgbImage reference;
  double referenceError = 0.0;  // relMSE of the reference by its own account; 0: not known
};

/// Scene files by the names of their folders.
std::map<std::string, std::string> sceneFiles(const SceneOptions& options) {
  std::map<std::string, std::string> files;
  for (const std::string& root : {std::string(AWD_BENCH_SCENES), options.moreScenes}) {
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
  if (options.quick) {
    for (auto file = files.begin(); file != files.end();) {
      file = file->first == "verification" ? std::next(file) : files.erase(file);
    }
  }
  return files;
}

RgbImage readImage(AWDDevice device, const std::string& path, const char* const (&channels)[3]) {
  awdtest::Image file;
  must(awdReadImage(device, path.c_str(), file.out()));
  RgbImage image;
  must(awdGetImageInfo(file, &image.width, &image.height, nullptr));
  image.values.resize(std::size_t{3} * image.width * image.height);
  for (std::size_t c = 0; c < 3; ++c) {
    must(awdGetImageChannel(file, channels[c], &image.values[c], 3 * sizeof(float),
                            std::size_t{3} * image.width * sizeof(float)));
  }
  return image;
}

/// relMSE of an image whose pixels vary that much.
double errorOf(const RgbImage& image, const RgbImage& variance) {
  RgbImage off = image;
  for (std::size_t i = 0; i < off.values.size(); ++i)
    off.values[i] += std::sqrt(variance.values[i]);
  return command::compareImages(off, image).relMse;
}

awdtest::Render newRender(const Loaded& loaded, AWDField field, AWDGuide guide, uint64_t seed) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.camera = &loaded.camera;
  desc.guide = guide;
  desc.seed = seed;
  awdtest::Render render;
  must(awdNewRender(loaded.scene.get(), field, &desc, render.out()));
  return render;
}

/// False: cancelled.
bool renderSamples(AWDRender render, uint32_t samples) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = samples;
  const AWDResult result = awdRenderPasses(render, &schedule);
  if (result == AWD_ERROR_CANCELLED) return false;
  must(result);
  return true;
}

/// Sets the reference; false: cancelled while it was made.
bool takeReference(AWDDevice device, const std::string& sceneFile, const SceneOptions& options,
                   Loaded& loaded) {
  constexpr const char* kColors[] = {"R", "G", "B"};
  constexpr const char* kVariances[] = {"variance.R", "variance.G", "variance.B"};
  const fs::path committed = fs::path(sceneFile).parent_path() / "reference.exr";
  if (fs::exists(committed)) {
    loaded.reference = readImage(device, committed.string(), kColors);
    const RgbImage size = {loaded.camera.width, loaded.camera.height, {}};
    const auto ratio = command::sizeRatio(loaded.reference, size);
    if (!ratio) throw std::runtime_error(committed.string() + ": no multiple of the image's size");
    if (*ratio > 1) loaded.reference = command::boxFilter(loaded.reference, *ratio);
    return true;
  }
  const std::string name = "reference-" + loaded.name + "-" + std::to_string(loaded.camera.width) +
                           "x" + std::to_string(loaded.camera.height) + "-" +
                           std::to_string(options.referenceSamples) + ".exr";
  const std::string path = (fs::path(options.folder) / name).string();
  if (!fs::exists(path)) {
    const awdtest::Render render = newRender(loaded, nullptr, AWD_GUIDE_COSINE, kReferenceSeed);
    if (!renderSamples(render, options.referenceSamples)) return false;
    awdtest::Image film;
    must(awdNewFilmImage(render, film.out()));
    must(awdWriteImageEXR(film, path.c_str()));
  }
  loaded.reference = readImage(device, path, kColors);
  loaded.referenceError = errorOf(loaded.reference, readImage(device, path, kVariances));
  return true;
}

struct Shot {
  double relMse, relMseTrimmed, l1, cpuSeconds;
};

/// What is compared in a scene: no basis means unguided.
struct Guided {
  const char* basis;
  const Method* method;
};

const char* nameOf(const Guided& guided) { return guided.method ? guided.method->name : "cosine"; }

bool isCeres(const Guided& guided) {
  return guided.method && guided.method->solver && std::string(guided.method->solver) == "ceres";
}

/// False: cancelled.
bool shoot(AWDDevice device, const Loaded& loaded, const Guided& guided, uint32_t samples,
           uint64_t seed, Shot& shot) {
  awdtest::Field field;
  if (guided.method) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.basis = guided.basis;
    desc.estimator = guided.method->estimator;
    desc.refitSolver = guided.method->solver;
    must(awdNewField(device, &desc, field.out()));
  }
  const awdtest::Render render =
      newRender(loaded, field, guided.method ? AWD_GUIDE_ADAPTIVE : AWD_GUIDE_COSINE, seed);
  if (!renderSamples(render, samples)) return false;
  RgbImage image = {loaded.camera.width, loaded.camera.height, {}};
  image.values.resize(loaded.reference.values.size());
  must(awdReadFilm(render, AWD_FILM_RADIANCE, image.values.data(), 0, 0));
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  must(awdGetRenderStatistics(render, &statistics));
  const command::Metrics metrics = command::compareImages(image, loaded.reference);
  shot = {metrics.relMse, metrics.relMseTrimmed, metrics.l1, statistics.cpuSeconds};
  return true;
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

double efficiency(const Shot& shot) { return 1.0 / (shot.relMseTrimmed * shot.cpuSeconds); }

Row rowOf(const Loaded& loaded, const Guided& guided, uint32_t samples,
          const std::vector<Shot>& shots, const std::vector<Shot>& cosine,
          const std::vector<Shot>& paper) {
  Row row = {{"part", "render"},
             {"scene", loaded.name},
             {"basis", guided.method ? guided.basis : ""},
             {"method", nameOf(guided)},
             {"samples_per_pixel", samples},
             {"seeds", shots.size()},
             {"reference_relmse", loaded.referenceError}};
  const auto spread = [&](double Shot::*figure) {
    std::vector<double> values(shots.size());
    std::transform(shots.begin(), shots.end(), values.begin(),
                   [figure](const Shot& shot) { return shot.*figure; });
    return spreadOf(values);
  };
  setSpread(row, "relmse", spread(&Shot::relMse));
  setSpread(row, "relmse_trimmed", spread(&Shot::relMseTrimmed));
  setSpread(row, "l1", spread(&Shot::l1));
  setSpread(row, "cpu_seconds", spread(&Shot::cpuSeconds));
  const auto against = [&](const std::string& name, const std::vector<Shot>& base) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(shots.size(), base.size()); ++i) {
      ratios.push_back(efficiency(shots[i]) / efficiency(base[i]));
    }
    if (!ratios.empty()) setSpread(row, name, ratioSpread(ratios));
  };
  against("efficiency_to_cosine", cosine);
  against("efficiency_to_paper", paper);
  return row;
}

}  // namespace

std::vector<Row> measureScenes(const std::vector<Method>& methods, SceneOptions options,
                               const SceneWatch& watch, Cancelled cancelled) {
  if (options.quick) {
    options.samples = {4, 16};
    options.seeds = 2;
  }
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;  // CPU time of what is measured and of nothing else
  desc.progress = [](void* user, const AWDProgress*) -> int32_t {
    return reinterpret_cast<Cancelled>(user)() ? 0 : 1;
  };
  desc.progressUser = reinterpret_cast<void*>(cancelled);
  command::Device device;
  must(awdNewDevice(&desc, device.out()));

  std::vector<Guided> all = {{"", nullptr}};
  for (const char* basis : kBases) {
    for (const Method& method : methods) all.push_back({basis, &method});
  }
  const std::map<std::string, std::string> files = sceneFiles(options);
  const std::size_t images =
      files.size() * all.size() * options.samples.size() * static_cast<std::size_t>(options.seeds);
  std::size_t done = 0;
  std::vector<Row> rows;
  for (const auto& [name, file] : files) {
    if (!watch(done, images)) return rows;
    Loaded loaded;
    loaded.name = name;
    const command::SceneData data = command::loadScene(file);
    loaded.camera = command::chooseCamera({}, file, data);
    command::resize(loaded.camera, options.quick ? kQuickWidth : kWidth, {});
    loaded.scene = command::uploadScene(device, data, file);
    must(awdCommitScene(loaded.scene.get()));
    if (!takeReference(device.get(), file, options, loaded)) return rows;
    for (const uint32_t samples : options.samples) {
      std::vector<std::vector<Shot>> shots(all.size());
      for (int seed = 1; seed <= options.seeds; ++seed) {
        for (std::size_t i = 0; i < all.size(); ++i) {
          if (!watch(done++, images)) return rows;
          if (isCeres(all[i]) && (seed > kCeresSeeds || all[i].basis == kBases[0])) continue;
          Shot shot = {};
          if (!shoot(device.get(), loaded, all[i], samples, static_cast<uint64_t>(seed), shot)) {
            return rows;
          }
          shots[i].push_back(shot);
        }
      }
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (shots[i].empty()) continue;
        const auto paper = std::find_if(all.begin(), all.end(), [&](const Guided& guided) {
          return guided.basis == all[i].basis && guided.method &&
                 guided.method->estimator == AWD_ESTIMATOR_PAPER;
        });
        rows.push_back(rowOf(loaded, all[i], samples, shots[i], shots[0],
                             paper == all.end()
                                 ? std::vector<Shot>()
                                 : shots[static_cast<std::size_t>(paper - all.begin())]));
      }
    }
  }
  return rows;
}

}  // namespace bench::refit

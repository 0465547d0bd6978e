// SPDX-License-Identifier: Apache-2.0
#include "refit_scenes.h"

#include <algorithm>
#include <map>

namespace bench::refit {
namespace {

constexpr uint32_t kWidth = 64, kQuickWidth = 32;  // pixels
/// Ceres takes so much longer that it gets the first seeds and one basis alone.
constexpr int kCeresSceneSeeds = 2;
constexpr const char* kBases[] = {"haar", "linear-bspline"};

/// What is compared in a scene: no basis means unguided.
struct Guided {
  const char* basis;
  const Method* method;
};

const char* nameOf(const Guided& guided) { return guided.method ? guided.method->name : "cosine"; }

bool isCeres(const Guided& guided) {
  return guided.method && guided.method->solver && std::string(guided.method->solver) == "ceres";
}

Settings settingsOf(const Guided& guided) {
  Settings settings;
  settings.render.guide = guided.method ? AWD_GUIDE_ADAPTIVE : AWD_GUIDE_COSINE;
  if (!guided.method) return settings;
  settings.field.basis = guided.basis;
  settings.field.estimator = guided.method->estimator;
  settings.field.refitSolver = guided.method->solver;
  return settings;
}

Row rowOf(const LoadedScene& loaded, const Guided& guided, uint32_t samples,
          const std::vector<Shot>& shots, const std::vector<Shot>& cosine,
          const std::vector<Shot>& paper) {
  Row row = {{"part", "render"},
             {"scene", loaded.name},
             {"basis", guided.method ? guided.basis : ""},
             {"method", nameOf(guided)},
             {"samples_per_pixel", samples},
             {"seeds", shots.size()},
             {"reference_relmse", loaded.reference.relMse}};
  setSpread(row, "relmse", spreadOf(shots, [](const Shot& shot) { return shot.relMse; }));
  setSpread(row, "relmse_trimmed",
            spreadOf(shots, [](const Shot& shot) { return shot.relMseTrimmed; }));
  setSpread(row, "l1", spreadOf(shots, [](const Shot& shot) { return shot.l1; }));
  setSpread(row, "cpu_seconds", spreadOf(shots, [](const Shot& shot) { return shot.cpuSeconds; }));
  if (const auto ratio = ratioOf(shots, cosine, efficiency)) {
    setSpread(row, "efficiency_to_cosine", *ratio);
  }
  if (const auto ratio = ratioOf(shots, paper, efficiency)) {
    setSpread(row, "efficiency_to_paper", *ratio);
  }
  return row;
}

}  // namespace

std::vector<Row> measureScenes(const std::vector<Method>& methods, SceneOptions options,
                               const SceneWatch& watch, Cancelled cancelled) {
  if (options.quick) {
    options.samples = {4, 16};
    options.seeds = 2;
  }
  // One thread: CPU time of what is measured and of nothing else.
  const awd::Device device = newRenderDevice(1, cancelled);
  std::vector<Guided> all = {{"", nullptr}};
  for (const char* basis : kBases) {
    for (const Method& method : methods) all.push_back({basis, &method});
  }
  std::map<std::string, std::string> files = sceneFiles(options.moreScenes);
  if (options.quick) files = {{"verification", files.at("verification")}};
  const std::size_t images =
      files.size() * all.size() * options.samples.size() * static_cast<std::size_t>(options.seeds);
  std::size_t done = 0;
  std::vector<Row> rows;
  for (const auto& [name, file] : files) {
    if (!watch(done, images)) return rows;
    LoadedScene loaded = loadScene(device, name, file, options.quick ? kQuickWidth : kWidth);
    if (!takeReference(device, options.folder, options.referenceSamples, loaded)) return rows;
    for (const uint32_t samples : options.samples) {
      std::vector<std::vector<Shot>> shots(all.size());
      for (int seed = 1; seed <= options.seeds; ++seed) {
        for (std::size_t i = 0; i < all.size(); ++i) {
          if (!watch(done++, images)) return rows;
          if (isCeres(all[i]) && (seed > kCeresSceneSeeds || all[i].basis == kBases[0])) continue;
          Shot shot = {};
          if (!shoot(loaded, settingsOf(all[i]), samples, static_cast<uint64_t>(seed), shot)) {
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

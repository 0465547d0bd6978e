// SPDX-License-Identifier: Apache-2.0
// Table 1 and figures 3, 5 and 6: the error of four pdfs, by samples and by CPU time.
#include <cstdio>

#include "paper.h"
#include "paper_methods.h"
#include "paper_quality_report.h"
#include "paper_stages.h"

namespace bench::paper {
namespace {

/// Ten samples a pass while learning; then as long as that, up to twice the table's number.
const std::vector<uint32_t> kPasses = {10, 10, 10, 20, 50, 100};
const std::vector<uint32_t> kQuickPasses = {10, 10, 10, 70};

std::vector<Stage> stagesOf(const LoadedScene& loaded, const Method& method,
                            const std::vector<uint32_t>& passes, uint64_t seed) {
  const Settings settings = settingsOf(method);
  if (!method.ownSchedule) {
    return renderStages(loaded, settings, passes, method.learns ? kLearningPasses : 0, seed);
  }
  // It divides samples by their whole number: each number is an image of its own.
  std::vector<Stage> stages;
  uint32_t samples = 0;
  for (const uint32_t pass : passes) {
    stages.push_back(renderWhole(loaded, settings, samples += pass, seed));
  }
  return stages;
}

/// All methods after each other within a seed: what else the machine does meets them alike.
QualityOf measure(const Study& study, const LoadedScene& loaded) {
  QualityOf quality;
  quality.scene = loaded.name;
  quality.reference = loaded.reference.mean;
  quality.referenceRelMse = loaded.reference.relMse;
  const auto& passes = study.options.quick ? kQuickPasses : kPasses;
  for (int seed = 1; seed <= study.options.seeds; ++seed) {
    for (std::size_t m = 0; m < methods().size(); ++m) {
      const Method& method = methods()[m];
      const auto stages = stagesOf(loaded, method, passes, static_cast<uint64_t>(seed));
      if (seed == 1) {
        quality.curves.push_back({});
        quality.curves.back().resize(stages.size());
      }
      for (std::size_t i = 0; i < stages.size(); ++i) {
        CurvePoint& point = quality.curves[m][i];
        point.samples = stages[i].samples;
        point.l1.push_back(stages[i].l1);
        point.cpuSeconds.push_back(stages[i].cpuSeconds);
        if (seed == 1 && point.samples == kTableSamples) quality.images.push_back(stages[i].film);
      }
    }
    std::printf("quality: %s, seed %d of %d\n", loaded.name.c_str(), seed, study.options.seeds);
    std::fflush(stdout);
  }
  return quality;
}

}  // namespace

void measureQuality(Study& study) {
  std::vector<std::string> scenes = study.options.only;
  if (scenes.empty()) {
    for (const auto& [name, file] : sceneFiles("")) {
      if (!study.options.quick || name == "verification" || name == "cornell-box") {
        scenes.push_back(name);
      }
    }
  }
  std::vector<QualityOf> all;
  for (const std::string& scene : scenes) {
    all.push_back(measure(study, loadReferenced(study, scene)));
    addRows(all.back(), study.rows);
  }
  writeQuality(all, study);
}

}  // namespace bench::paper

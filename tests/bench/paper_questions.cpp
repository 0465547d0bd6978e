// SPDX-License-Identifier: Apache-2.0
// What the paper's conclusion leaves open: other bases, whether to refine and to keep details,
// samples a pass, and scenes of more triangles.
#include <algorithm>
#include <cstdio>

#include "paper.h"
#include "paper_cut.h"
#include "paper_methods.h"
#include "paper_stages.h"
#include "wavelets.h"

namespace bench::paper {
namespace {

/// A change of Haar in the preset paper, 3 x 10 and 70 samples.
struct Variation {
  const char* question;
  std::string name;
  Settings settings;
  std::vector<uint32_t> passes;
};

struct Outcome {
  std::vector<double> l1, cpuSeconds;
};

const std::vector<uint32_t> kPasses = {10, 10, 10, 70};

std::vector<Variation> variations() {
  std::vector<Variation> all = {{"", "haar, 3 x 10 + 70", paperSettings("haar"), kPasses}};
  for (const char* basis :
       {"linear-bspline", "quadratic-bspline", "cubic-bspline", "f2", "m2", "m3"}) {
    all.push_back({"function basis", basis, paperSettings(basis), kPasses});
  }
  for (const uint32_t level : {2u, 3u, 4u, 5u}) {
    Settings settings = paperSettings("haar");
    settings.field.startLevel = settings.field.maxLevel = AWD_LEVEL(level);
    all.push_back({"not refined", "haar, level " + std::to_string(level), settings, kPasses});
  }
  for (const uint32_t samples : {1u, 3u, 20u, 30u}) {
    const uint32_t learning = kLearningPasses * samples;
    all.push_back(
        {"samples a pass",
         "haar, 3 x " + std::to_string(samples) + " + " + std::to_string(kTableSamples - learning),
         paperSettings("haar"),
         {samples, samples, samples, kTableSamples - learning}});
  }
  return all;
}

double median(const Outcome& above, const Outcome& below, bool byTime) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.l1.size(); ++i) {
    const double error = above.l1[i] / below.l1[i];
    ratios.push_back(byTime ? error * error * above.cpuSeconds[i] / below.cpuSeconds[i] : error);
  }
  return spreadOf(ratios).median;
}

void measureVariations(Study& study, const std::string& scene) {
  const LoadedScene loaded = loadReferenced(study, scene);
  const std::vector<Variation> all = variations();
  std::vector<Outcome> outcomes(all.size());
  for (int seed = 1; seed <= study.options.seeds; ++seed) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Stage stage = renderStages(loaded, all[i].settings, all[i].passes, kLearningPasses,
                                       static_cast<uint64_t>(seed))
                              .back();
      outcomes[i].l1.push_back(stage.l1);
      outcomes[i].cpuSeconds.push_back(stage.cpuSeconds);
    }
  }
  ReportTable table = {
      "100 samples a pixel on " + scene +
          ", medians over seeds; error and CPU time to equal "
          "error (L1 squared x CPU s) relative to the first line, of the same seed",
      {"question", "what", "L1", "CPU s", "error", "time to equal error"},
      {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Spread l1 = spreadOf(outcomes[i].l1), cpuSeconds = spreadOf(outcomes[i].cpuSeconds);
    const double error = median(outcomes[i], outcomes[0], false);
    const double time = median(outcomes[i], outcomes[0], true);
    std::printf("questions: %s, %-22s L1 %.4f, error %.3f, time to equal error %.3f\n",
                scene.c_str(), all[i].name.c_str(), l1.median, error, time);
    Row row = {{"part", "questions"},
               {"question", all[i].question},
               {"scene", scene},
               {"method", all[i].name},
               {"seeds", outcomes[i].l1.size()}};
    setSpread(row, "l1", l1);
    setSpread(row, "cpu_seconds", cpuSeconds);
    row["error_to_haar"] = error;
    row["time_to_equal_error_to_haar"] = time;
    study.rows.push_back(std::move(row));
    table.rows.push_back({all[i].question, all[i].name, shortNumber(l1.median),
                          shortNumber(cpuSeconds.median), shortNumber(error), shortNumber(time)});
  }
  std::fflush(stdout);
  study.section.table(table);
}

void measureTriangles(Study& study) {
  const bool quick = study.options.quick;
  const LoadedScene whole = loadReferenced(study, "cornell-box");
  ReportTable table = {
      "CPU time that cosine needs for the error of the other, cornell-box with triangles cut "
      "into n x n equal ones; above 1 guiding pays. Planar pieces, and with them the paper's "
      "patches, stay what they are.",
      {"triangles", "haar, preset paper", "our defaults", "cosine, CPU s", "haar, CPU s"},
      {}};
  for (const uint32_t n :
       quick ? std::vector<uint32_t>{1, 16} : std::vector<uint32_t>{1, 8, 40, 167}) {
    const LoadedScene loaded = cutScene(study.device, whole, n);
    Outcome outcomes[3];
    for (int seed = 1; seed <= study.options.seeds; ++seed) {
      const auto number = static_cast<uint64_t>(seed);
      const Stage stages[] = {
          renderStages(loaded, settingsOf(methods()[kCosine]), kPasses, 0, number).back(),
          renderStages(loaded, paperSettings("haar"), kPasses, kLearningPasses, number).back(),
          renderWhole(loaded, {}, kTableSamples, number)};
      for (std::size_t i = 0; i < 3; ++i) {
        outcomes[i].l1.push_back(stages[i].l1);
        outcomes[i].cpuSeconds.push_back(stages[i].cpuSeconds);
      }
    }
    AWDSceneInfo info = AWD_SCENE_INFO_INIT;
    awdGetSceneInfo(loaded.scene.get(), &info);
    const double haar = median(outcomes[0], outcomes[1], true);
    const double defaults = median(outcomes[0], outcomes[2], true);
    const double cosineTime = spreadOf(outcomes[0].cpuSeconds).median;
    const double haarTime = spreadOf(outcomes[1].cpuSeconds).median;
    std::printf("questions: %llu triangles, cosine's time to the error of haar %.3f, ours %.3f\n",
                static_cast<unsigned long long>(info.triangles), haar, defaults);
    std::fflush(stdout);
    study.rows.push_back({{"part", "questions"},
                          {"question", "triangles"},
                          {"scene", loaded.name},
                          {"triangles", info.triangles},
                          {"seeds", outcomes[0].l1.size()},
                          {"cosine_time_to_haar", haar},
                          {"cosine_time_to_defaults", defaults},
                          {"cosine_cpu_seconds", cosineTime},
                          {"haar_cpu_seconds", haarTime}});
    table.rows.push_back({std::to_string(info.triangles), shortNumber(haar), shortNumber(defaults),
                          shortNumber(cosineTime), shortNumber(haarTime)});
  }
  study.section.table(table);
}

/// Over the functions of `wavelets`: the constant, which needs one coefficient, left out.
void measureDetails(Study& study) {
  const std::size_t samples = study.options.quick ? 2000 : 20000;
  ReportTable table = {
      "Details kept or dropped: trees of 32 x 32 boxes that have learned a ramp, a bump, a disc "
      "and a ridge from " +
          std::to_string(samples) +
          " samples each. Without details below their standard error, boxes halved where that "
          "promises most, of what there is with all details and no more: geometric means over the "
          "functions, and the worst.",
      {"basis", "coefficients", "variance", "worst variance"},
      {}};
  const std::vector<Row> rows = measureWavelets(study.device.get(), samples);
  for (const char* basis : {"haar", "f2", "m2", "m3"}) {
    std::vector<double> coefficients, variances;
    for (const Row& row : rows) {
      if (row["basis"] != basis || row["function"] == "constant") continue;
      coefficients.push_back(row["coefficients_after"].get<double>() /
                             row["coefficients"].get<double>());
      variances.push_back(row["variance_after"].get<double>() / row["variance"].get<double>());
    }
    const double left = geometricMean(coefficients), variance = geometricMean(variances);
    const double worst = *std::max_element(variances.begin(), variances.end());
    std::printf(
        "questions: details of %s dropped: %.3f of the coefficients, %.3f of the variance\n", basis,
        left, variance);
    study.rows.push_back({{"part", "questions"},
                          {"question", "details dropped"},
                          {"method", basis},
                          {"samples", samples},
                          {"coefficients_ratio", left},
                          {"variance_ratio", variance},
                          {"worst_variance_ratio", worst}});
    table.rows.push_back({basis, shortNumber(left), shortNumber(variance), shortNumber(worst)});
  }
  std::fflush(stdout);
  study.section.table(table);
}

}  // namespace

void measureQuestions(Study& study) {
  study.section.heading("What the paper leaves open");
  study.section.paragraph(
      "Other function bases (f2, m2 and m3 are tree wavelets'; cubic B-splines are those of "
      "examples/cubic-bspline), densities of a fixed level against refined ones, wavelet details "
      "kept or dropped, samples of the learning passes, and scenes of more triangles.");
  if (study.options.quick) {
    measureVariations(study, "verification");
  } else {
    for (const char* scene : {"cornell-box", "ceiling-lamp"}) measureVariations(study, scene);
  }
  measureDetails(study);
  measureTriangles(study);
}

}  // namespace bench::paper

// SPDX-License-Identifier: Apache-2.0
#include "render_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "failure.h"

namespace command {

namespace {

/// In the order of AWD_ESTIMATOR_...
const std::vector<std::string> kEstimators = {"default", "paper", "mixture", "ratio",
                                              "quasi",   "refit", "lumped"};

/// In the order of AWD_QUALITY_..., which begin with 1.
const std::vector<std::string> kQualities = {"draft", "normal", "fine", "reference"};

/// CLI::PositiveNumber takes NaN.
const CLI::Validator kPositive(
    [](const std::string& text) {
      double number = 0.0;
      const bool good =
          CLI::detail::lexical_cast(text, number) && number > 0.0 && std::isfinite(number);
      return good ? std::string() : text + " is not a positive number";
    },
    "POSITIVE");

/// Of 64 bits; CLI11 would take what is more for the largest.
const CLI::Validator kSeed(
    [](const std::string& text) {
      uint64_t number = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      const bool good = error == std::errc() && end == text.data() + text.size();
      return good ? std::string() : text + " is not a whole number from 0 to 2^64 - 1";
    },
    "SEED");

awd::Schedule scheduleOf(const std::string& quality) {
  const auto found = std::find(kQualities.begin(), kQualities.end(), quality);
  return awd::qualitySchedule(static_cast<AWDQuality>(found - kQualities.begin() + 1));
}

}  // namespace

void RenderOptions::describe(CLI::App& command) {
  const CLI::Range sides(1, 65536);
  command.add_option("SCENE", scene, "Scene: .obj, .gltf or .glb")->required();
  command.add_option("-o,--output", output, "OpenEXR file to write")->required();
  command.add_option("--camera", camera,
                     "JSON with eye, look_dir, up, tan_half_fov_x, width, height.\n"
                     "Without it: <scene>.camera.json beside the scene, or the\n"
                     "scene's own camera, or a view of the whole scene");
  command.add_option("--width", width, "Pixels; without the other side the ratio is kept")
      ->check(sides);
  command.add_option("--height", height, "Likewise")->check(sides);
  command.add_option("--guide", guide, "Where indirect rays go")
      ->capture_default_str()
      ->check(CLI::IsMember({"uniform", "cosine", "adaptive"}));
  command.add_option("--basis", basis, "Basis of adaptive densities, see `awd bases`");
  command.add_option("--level", level, "Finest level of adaptive densities")
      ->check(CLI::Range(0, 20));
  command.add_option("--estimator", estimator, "How adaptive densities learn, see awd/types.h")
      ->capture_default_str()
      ->check(CLI::IsMember(kEstimators));
  command.add_option("--refit-solver", refitSolver,
                     "ceres or descent, with --estimator refit. Without it: the refit\n"
                     "module's first");
  command.add_option("--preset", preset, "paper: Pietrek and Peter 1999 to the letter")
      ->capture_default_str()
      ->check(CLI::IsMember({"paper", "default"}));
  command.add_option("--passes", passes, "Number of passes, with --spp")
      ->check(CLI::Range(1, 100000));
  command.add_option("--spp", spp,
                     "Samples per pixel of each pass, N1,...,NK, or one number for\n"
                     "all. Without it and --samples: the preset's schedule");
  command.add_option("--samples", samples, "Samples per pixel in all, divided by the library")
      ->check(CLI::Range(1u, std::numeric_limits<uint32_t>::max()));
  command
      .add_option("--seconds", seconds,
                  "As many samples as there is time for, divided by the library")
      ->check(kPositive);
  command
      .add_option("--error", error,
                  "As many samples as it takes until the root mean square error is at\n"
                  "most this share of the mean radiance, 95 times of 100")
      ->check(kPositive);
  command
      .add_option("--quality", quality,
                  "draft, normal, fine or reference: --error 0.5, 0.25, 0.1 or 0.05, with\n"
                  "1024, 4096, 16384 or 65536 samples per pixel at most; says so if they\n"
                  "are not enough")
      ->check(CLI::IsMember(kQualities));
  command.add_option("--memory", memory, "MiB that film and field may take together")
      ->check(kPositive);
  command.add_option("--seed", seed, "Another seed, another noise")
      ->capture_default_str()
      ->check(kSeed);
  command.add_option("--threads", device.threads, "0: all that there are")
      ->check(CLI::Range(0, 65536));
  command.add_option("--points", points, "What paths are drawn from")
      ->capture_default_str()
      ->check(CLI::IsMember({"default", "random", "sobol"}));
  command.add_option("--shadow-rays", shadowRays, "Per light and vertex")
      ->check(CLI::Range(1, 1024));
  command.add_option("--direct", direct, "How light is found, see awd/render.h")
      ->capture_default_str()
      ->check(CLI::IsMember({"default", "area", "weighted", "none"}));
  command.add_option("--lights", lights, "How shadow rays choose among several lights")
      ->capture_default_str()
      ->check(CLI::IsMember({"default", "power", "learned"}));
  command.add_option("--max-split", maxSplit, "Rays into which a path may split, 1: none")
      ->check(CLI::Range(1, 64));
  command.add_option("--field", fieldIn,
                     "Begin with what another render of the scene, smaller perhaps, has\n"
                     "learned, from this file");
  command.add_option("--save-field", fieldOut, "Write what has been learned to this file");
  command.add_option("--checkpoint", checkpoint,
                     "Write all that it takes to go on to this file after each pass, and if\n"
                     "it is there go on from it: with the same scene and options");
  command.add_option("--json", json, "Write statistics of each pass and of all to this file");
  command
      .add_option("--pdf", pdfTexts,
                  "PATCH:FILE.png: the density of a patch in the last pass. PATCH\n"
                  "is a number, with b after it for the back side, or X,Y for the\n"
                  "patch under a pixel. May be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--basis-path", device.basisPaths,
                  "Look for bases in this folder first. May be repeated")
      ->allow_extra_args(false);
}

void RenderOptions::finish() {
  schedule = makeSchedule(passes, spp, samples);
  if ((seconds || error) && (spp || passes)) {
    throw UsageError(std::string(seconds ? "--seconds" : "--error") +
                     " divides into passes by itself: it can't be used with " +
                     std::string(spp ? "--spp" : "--passes"));
  }
  schedule.seconds = seconds.value_or(0.0);
  schedule.error = error.value_or(0.0);
  if (quality) {
    if (spp || passes || samples || error) {
      throw UsageError(
          "--quality is an error and a number of samples by itself: it can't be used "
          "with --" +
          std::string(spp       ? "spp"
                      : passes  ? "passes"
                      : samples ? "samples"
                                : "error"));
    }
    const awd::Schedule limits = scheduleOf(*quality);
    schedule.totalSamples = limits.totalSamples;
    schedule.error = limits.error;
  }
  for (const std::string& text : pdfTexts) pdfs.emplace_back(text);
  if (!pdfs.empty() && !isAdaptive()) {
    throw UsageError("--pdf shows adaptive densities: there are none with --guide " + guide);
  }
  if ((fieldIn || fieldOut) && !isAdaptive()) {
    throw UsageError(std::string(fieldIn ? "--field" : "--save-field") +
                     " is of adaptive densities: there are none with --guide " + guide);
  }
  if (!isAdaptive() && (basis || level || estimator != "default")) {
    throw UsageError(std::string(basis   ? "--basis"
                                 : level ? "--level"
                                         : "--estimator") +
                     " is of adaptive densities: there are none with --guide " + guide);
  }
  if (fieldIn && (basis || level || estimator != "default")) {
    throw UsageError(std::string("--field knows its own ") +
                     (basis   ? "basis"
                      : level ? "level"
                              : "estimator") +
                     ": it can't be used with --" +
                     (basis   ? "basis"
                      : level ? "level"
                              : "estimator"));
  }
  if (refitSolver && estimator != "refit") {
    throw UsageError("--refit-solver needs --estimator refit, not " + estimator);
  }
}

AWDGuide RenderOptions::guideValue() const {
  if (guide == "uniform") return AWD_GUIDE_UNIFORM;
  return guide == "cosine" ? AWD_GUIDE_COSINE : AWD_GUIDE_ADAPTIVE;
}

AWDPreset RenderOptions::presetValue() const {
  return preset == "paper" ? AWD_PRESET_PAPER : AWD_PRESET_DEFAULT;
}

AWDPoints RenderOptions::pointsValue() const {
  if (points == "random") return AWD_POINTS_RANDOM;
  return points == "sobol" ? AWD_POINTS_SOBOL : AWD_POINTS_DEFAULT;
}

AWDDirectLight RenderOptions::directValue() const {
  if (direct == "area") return AWD_DIRECT_AREA;
  if (direct == "weighted") return AWD_DIRECT_WEIGHTED;
  return direct == "none" ? AWD_DIRECT_NONE : AWD_DIRECT_DEFAULT;
}

AWDLightChoice RenderOptions::lightsValue() const {
  if (lights == "power") return AWD_LIGHTS_POWER;
  return lights == "learned" ? AWD_LIGHTS_LEARNED : AWD_LIGHTS_DEFAULT;
}

AWDEstimator RenderOptions::estimatorValue() const {
  const auto found = std::find(kEstimators.begin(), kEstimators.end(), estimator);
  return static_cast<AWDEstimator>(found - kEstimators.begin());
}

}  // namespace command

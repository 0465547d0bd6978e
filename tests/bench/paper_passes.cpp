// SPDX-License-Identifier: Apache-2.0
// Figure 1: three passes, and what the ground patch has learned after each.
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "paper.h"
#include "paper_methods.h"
#include "paper_stages.h"
#include "png_bytes.h"
#include "scene_loader.h"
#include "support/handles.h"

namespace bench::paper {
namespace {

using awdtest::must;

constexpr float kGround[3] = {0.0f, 0.001f, 0.0f};  // just above the middle of the ground patch
constexpr float kUp[3] = {0.0f, 1.0f, 0.0f};
constexpr uint32_t kPdfSize = 64;
constexpr uint32_t kSteps = 128;  // of the quadrature, in cos(theta); twice as many in phi

/// Share of the patch's density that falls on a material, seen from the middle of the ground.
double shareOn(const LoadedScene& loaded, AWDField field, uint32_t patch, uint32_t material) {
  constexpr double kPi = 3.14159265358979323846;
  double share = 0.0;
  for (uint32_t i = 0; i < kSteps; ++i) {
    const double cosine = (i + 0.5) / kSteps, sine = std::sqrt(1.0 - cosine * cosine);
    for (uint32_t k = 0; k < 2 * kSteps; ++k) {
      const double phi = kPi * (k + 0.5) / kSteps;
      AWDRay ray = {{kGround[0], kGround[1], kGround[2]},
                    0.0f,
                    {static_cast<float>(sine * std::cos(phi)), static_cast<float>(cosine),
                     static_cast<float>(sine * std::sin(phi))},
                    std::numeric_limits<float>::infinity()};
      AWDHit hit;
      must(awdIntersect(loaded.scene.get(), &ray, 1, &hit));
      if (hit.mesh == AWD_INVALID_ID || hit.material != material) continue;
      float pdf = 0.0f;
      must(awdGetFieldPdf(field, patch, kUp, ray.direction, &pdf));
      share += pdf * kPi / (kSteps * kSteps);
    }
  }
  return share;
}

uint32_t materialNamed(const LoadedScene& loaded, const std::string& name) {
  const command::SceneData data = command::loadScene(loaded.file);
  for (uint32_t i = 0; i < data.materials.size(); ++i) {
    if (data.materials[i].name == name) return i;
  }
  throw std::runtime_error(loaded.file + ": no material " + name);
}

}  // namespace

void measurePasses(Study& study) {
  const LoadedScene loaded = loadReferenced(study, "verification");
  const Settings settings = paperSettings("linear-bspline");
  awdtest::Field field;
  must(awdNewSceneField(loaded.scene.get(), &settings.field, field.out()));
  uint32_t patch = AWD_INVALID_ID;
  must(awdGetPointPatch(loaded.scene.get(), kGround, &patch));
  const uint32_t reflector = materialNamed(loaded, "reflector");

  study.section.heading("Figure 1: a pdf adapts");
  const double start = shareOn(loaded, field, patch, reflector);
  study.rows.push_back(
      {{"part", "passes"}, {"scene", loaded.name}, {"pass", 0}, {"share_on_reflector", start}});
  ReportTable table = {
      "Three passes of 10 samples on verification, linear B-splines: the error of each pass's "
      "own image, and the share of the ground patch's density after it that falls on the "
      "reflector, seen from the middle. Light comes from the lit part of the reflector alone.",
      {"after pass", "L1 of its image", "share on the reflector"},
      {{"0", "–", shortNumber(start)}}};
  std::vector<ReportImage> films, pdfs;
  for (uint32_t pass = 1; pass <= kLearningPasses; ++pass) {
    // A render of its own for each pass, from what the field has learned in those before.
    const Stage stage = renderStages(loaded, settings, {kLearningSamples}, 1, pass, field).front();
    const double share = shareOn(loaded, field, patch, reflector);
    const std::string number = std::to_string(pass);
    table.rows.push_back({number, shortNumber(stage.l1), shortNumber(share)});
    study.rows.push_back({{"part", "passes"},
                          {"scene", loaded.name},
                          {"pass", pass},
                          {"l1", stage.l1},
                          {"share_on_reflector", share}});
    std::printf("passes: after pass %u, L1 %.4f, share of the pdf on the reflector %.3f\n", pass,
                stage.l1, share);
    films.push_back({"pass " + number, pngOf(stage.film, exposureOf(loaded.reference.mean))});
    std::vector<float> pixels(std::size_t{kPdfSize} * kPdfSize);
    must(awdGetPatchPdf(field, patch, kPdfSize, pixels.data(), 0));
    pdfs.push_back({"after pass " + number, greyPng(pixels, kPdfSize)});
  }
  study.section.table(table);
  study.section.images(films, "Figure 1, above: the image of each pass by itself.");
  study.section.images(pdfs,
                       "Figure 1, below: the pdf of the ground patch on the unit square, theta to "
                       "the right and phi downwards, each from 0 (dark) to its maximum.");
}

}  // namespace bench::paper

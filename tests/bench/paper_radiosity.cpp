// SPDX-License-Identifier: Apache-2.0
// The paper's kind of reference, and whether it and ours agree.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "paper.h"
#include "png_bytes.h"
#include "radiosity.h"
#include "scene_loader.h"

namespace bench::paper {
namespace {

/// So many that the edges of a visible lamp are not missed by more than the noise.
constexpr uint32_t kRaysPerPixelSide = 16;

using Mean = std::array<double, 3>;

Mean meanOf(const command::RgbImage& image) {
  Mean mean = {};
  for (std::size_t i = 0; i < image.values.size(); ++i) mean[i % 3] += image.values[i];
  for (double& value : mean) value *= 3.0 / static_cast<double>(image.values.size());
  return mean;
}

/// Standard error of the mean of an image by its pixels' variances; 0 where they aren't known.
Mean noiseOf(const command::RgbImage& variance) {
  Mean noise = {};
  for (std::size_t i = 0; i < variance.values.size(); ++i) noise[i % 3] += variance.values[i];
  const double pixels = static_cast<double>(variance.values.size()) / 3.0;
  for (double& value : noise) value = std::sqrt(value) / std::max(pixels, 1.0);
  return noise;
}

/// Images of one element size, by seed.
struct Solution {
  std::size_t elements = 0;
  std::vector<Mean> means;
  command::RgbImage image;  ///< of the first seed

  double mean(std::size_t c) const {
    double sum = 0.0;
    for (const Mean& mean : means) sum += mean[c];
    return sum / static_cast<double>(means.size());
  }
  /// Standard error of that, by the seeds.
  double noise(std::size_t c) const {
    double squares = 0.0;
    for (const Mean& one : means) squares += (one[c] - mean(c)) * (one[c] - mean(c));
    const auto n = static_cast<double>(means.size());
    return std::sqrt(squares / (n * (n - 1.0)));
  }
};

Solution solve(const LoadedScene& loaded, const command::SceneData& data, double edge,
               uint32_t rays, uint64_t seeds) {
  Solution solution;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    const Radiosity radiosity(loaded.scene.get(), data, {edge, rays, seed});
    const command::RgbImage image = radiosity.image(loaded.camera, kRaysPerPixelSide);
    solution.means.push_back(meanOf(image));
    solution.elements = radiosity.elements();
    if (seed == 1) solution.image = image;
  }
  return solution;
}

}  // namespace

void measureRadiosity(Study& study) {
  const bool quick = study.options.quick;
  const double edge = quick ? 0.5 : 0.3;
  const uint32_t rays = quick ? 2048 : 8192;
  const uint64_t seeds = quick ? 2 : 3;
  study.section.heading("Radiosity as reference");
  study.section.paragraph(
      "As in the paper: surfaces cut into elements of constant radiance, form factors counted by "
      "rays, the equations solved by Eigen. Its error is stated as the change from elements of "
      "twice the edge, which is no less than what is left if the error falls at least with the "
      "edge, and twice the standard error by seeds. The path-traced reference's is twice its "
      "standard error. They agree where the difference of mean radiance is not above the sum.");
  ReportTable table = {
      "Mean radiance of the image",
      {"scene", "channel", "elements", "radiosity", "error", "path tracing", "error", "agree"},
      {}};
  std::vector<ReportImage> images;
  for (const char* name : {"cornell-box", "verification"}) {
    const LoadedScene loaded = loadReferenced(study, name);
    const command::SceneData data = command::loadScene(loaded.file);
    const Solution coarse = solve(loaded, data, 2.0 * edge, rays, seeds);
    const Solution fine = solve(loaded, data, edge, rays, seeds);
    const Mean reference = meanOf(loaded.reference.mean);
    const Mean noise = noiseOf(loaded.reference.variance);
    const double l1 = command::compareImages(fine.image, loaded.reference.mean).l1;
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::fabs(fine.mean(c) - coarse.mean(c)) +
                           2.0 * std::hypot(fine.noise(c), coarse.noise(c));
      const double difference = fine.mean(c) - reference[c];
      const bool agree = std::fabs(difference) <= error + 2.0 * noise[c];
      const std::string channel(1, "RGB"[c]);
      std::printf("radiosity: %s %s, %zu elements: %.5f +- %.5f, path tracing %.5f +- %.5f: %s\n",
                  name, channel.c_str(), fine.elements, fine.mean(c), error, reference[c],
                  2.0 * noise[c], agree ? "agree" : "DISAGREE");
      std::fflush(stdout);
      table.rows.push_back({name, channel, std::to_string(fine.elements), shortNumber(fine.mean(c)),
                            shortNumber(error), shortNumber(reference[c]),
                            shortNumber(2.0 * noise[c]), agree ? "yes" : "no"});
      study.rows.push_back({{"part", "radiosity"},
                            {"scene", name},
                            {"channel", channel},
                            {"elements", fine.elements},
                            {"edge", edge},
                            {"rays", rays},
                            {"radiosity", fine.mean(c)},
                            {"radiosity_coarse", coarse.mean(c)},
                            {"radiosity_error", error},
                            {"path_tracing", reference[c]},
                            {"path_tracing_error", 2.0 * noise[c]},
                            {"difference", difference},
                            {"agree", agree},
                            {"l1_of_images", l1}});
    }
    const float exposure = exposureOf(loaded.reference.mean);
    images.push_back({std::string(name) + ", radiosity", pngOf(fine.image, exposure)});
    images.push_back(
        {std::string(name) + ", path tracing", pngOf(loaded.reference.mean, exposure)});
  }
  study.section.table(table);
  study.section.images(images, "Radiosity and path tracing.");
}

}  // namespace bench::paper

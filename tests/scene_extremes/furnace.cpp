// SPDX-License-Identifier: Apache-2.0
#include "scene_extremes/furnace.h"

#include <algorithm>

namespace awdtest {

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

AWDDevice sceneDevice() {
  static const Device shared = newDevice();
  return shared;
}

RenderedFilm renderedFilm(AWDScene scene, const AWDRenderDesc& desc,
                          const std::vector<uint32_t>& passes, AWDField field) {
  const Render render = newRender(scene, desc, field);
  runPasses(render, passes);
  RenderedFilm result = {readFilm(render), AWD_PASS_STATISTICS_INIT};
  must(awdGetRenderStatistics(render, &result.statistics));
  return result;
}

AWDCamera furnaceCamera(uint32_t width, uint32_t height) {
  return camera({0.4, 0.55, 0.35}, {0.9, 0.3, 0.8}, {0, 1, 0}, 0.8, width, height);
}

SceneBuilder furnace(double albedo, double emission) {
  SceneBuilder builder;
  builder.box({0, 0, 0}, {1, 1, 1}, true, {builder.material(grey(albedo), grey(emission))});
  return builder;
}

void expectUsable(Findings& found, const RenderedFilm& rendered, const std::string& name) {
  for (const float value : rendered.film.radiance) {
    found.expect(std::isfinite(value) && value >= 0.0f, "%s: radiance %g", name.c_str(), value);
  }
  for (const float value : rendered.film.variance) {
    found.expect(std::isfinite(value) && value >= 0.0f, "%s: variance %g", name.c_str(), value);
  }
  found.expect(rendered.statistics.rejectedSamples == 0, "%s: %llu samples rejected", name.c_str(),
               static_cast<unsigned long long>(rendered.statistics.rejectedSamples));
}

Estimate pixelMean(const Film& film) {
  const double n = static_cast<double>(film.radiance.size() / 3);
  double mean = 0.0, squares = 0.0;
  for (size_t i = 0; i < film.radiance.size(); i += 3) mean += film.radiance[i] / n;
  for (size_t i = 0; i < film.radiance.size(); i += 3) {
    squares += (film.radiance[i] - mean) * (film.radiance[i] - mean);
  }
  return {mean, std::sqrt(squares / (n - 1.0) / n)};
}

double expectMean(Findings& found, Estimate estimate, double truth, double share,
                  const std::string& name) {
  found.expect(estimate.error < share * truth, "%s: a standard error of %g", name.c_str(),
               estimate.error / truth);
  // The films are of floats.
  found.expect(std::fabs(estimate.mean - truth) < 5.0 * estimate.error + 1e-6 * truth,
               "%s: %g, not %g, with a standard error of %g", name.c_str(), estimate.mean, truth,
               estimate.error);
  return std::fabs(estimate.mean / truth - 1.0);
}

double rectangleAbove(double a, double b, double h) {
  const double x = a / h, y = b / h;
  const double alongX = std::sqrt(1.0 + x * x), alongY = std::sqrt(1.0 + y * y);
  return 2.0 / kPi * (x / alongX * std::atan(y / alongX) + y / alongY * std::atan(x / alongY));
}

}  // namespace awdtest

// SPDX-License-Identifier: Apache-2.0
// Fields that have learned something, and what can be read of their densities.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "support/handles.h"
#include "support/random.h"
#include "support/vec.h"

namespace awdtest {

constexpr double kPi = 3.14159265358979323846;

struct Normal {
  explicit Normal(Vec3 v)
      : values{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)} {}
  Vec3 exact() const { return normalise({values[0], values[1], values[2]}); }
  float values[3];
};

inline std::vector<Normal> someNormals() {
  std::vector<Normal> result;
  for (const Vec3 v : {Vec3{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
    result.emplace_back(v);
  }
  Random random(77);
  for (int i = 0; i < 4; ++i) {
    const double z = 2.0 * random.uniform() - 1.0, phi = 2.0 * kPi * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    result.emplace_back(Vec3{r * std::cos(phi), r * std::sin(phi), z});
  }
  return result;
}

inline AWDDirectionSample draw(AWDField field, uint32_t patch, const float normal[3],
                               Random& random) {
  const double uniforms[3] = {random.uniform(), random.uniform(), random.uniform()};
  AWDDirectionSample sample;
  must(awdSampleField(field, patch, normal, uniforms, &sample));
  return sample;
}

/// |d omega / d(u,v)| of the map at a direction whose angle with the normal is theta.
inline double solidAngle(AWDHemisphereMap map, double cosTheta) {
  if (map == AWD_MAP_SPHERICAL) {
    return kPi * kPi * std::sqrt(std::max(0.0, 1.0 - cosTheta * cosTheta));
  }
  return kPi / cosTheta;
}

inline double cosine(const AWDDirectionSample& sample, const float normal[3]) {
  return dot({sample.direction[0], sample.direction[1], sample.direction[2]},
             {normal[0], normal[1], normal[2]});
}

/// A pass of `samples` records, of a function given on the square, without the adapt.
inline void recordPass(AWDField field, uint32_t patch, size_t samples, Random& random,
                       const std::function<double(double, double)>& onSquare) {
  const float up[3] = {0, 0, 1};
  for (size_t i = 0; i < samples; ++i) {
    const AWDDirectionSample sample = draw(field, patch, up, random);
    const double value = onSquare(sample.square[0], sample.square[1]);
    must(awdRecordField(field, patch, &sample, value / static_cast<double>(sample.solidAngle)));
  }
}

struct Coefficients {
  uint32_t axisCount = 0, level = 0;
  uint64_t samples = 0, learned = 0;
  std::vector<double> c;

  /// Of Haar: all weights are 1 / axisCount on both axes.
  double integral() const {
    double sum = 0.0;
    for (const double x : c) sum += x;
    return sum / (double(axisCount) * axisCount);
  }
};

inline Coefficients coefficientsOf(AWDField field, uint32_t patch) {
  AWDPatchInfo info = AWD_PATCH_INFO_INIT;
  must(awdGetPatchInfo(field, patch, &info));
  Coefficients result;
  result.axisCount = info.axisCount;
  result.level = info.level;
  result.samples = info.samples;
  result.learned = info.learned;
  result.c.resize(size_t{info.axisCount} * info.axisCount);
  must(awdGetPatchCoefficients(field, patch, result.c.data(), result.c.size()));
  return result;
}

/// With the paper's basis and estimator, if not told otherwise.
inline AWDFieldDesc fieldDesc(AWDHemisphereMap map, uint32_t startLevel, uint32_t maxLevel,
                              double tau = 0.0) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.map = map;
  desc.startLevel = AWD_LEVEL(startLevel);
  desc.maxLevel = AWD_LEVEL(maxLevel);
  desc.tau = tau;
  desc.basis = "haar";
  desc.estimator = AWD_ESTIMATOR_PAPER;
  return desc;
}

inline AWDFieldStatistics adapt(AWDField field) {
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  must(awdAdaptField(field, &figures));
  return figures;
}

/// Three passes on a bright spot over a dim slope: a density with a contrast of about 100.
inline void train(AWDField field, uint32_t patch) {
  Random random(patch + 5);
  for (int pass = 0; pass < 3; ++pass) {
    recordPass(field, patch, 20000, random, [](double u, double v) {
      const double du = u - 0.7, dv = v - 0.3;
      return 0.05 + 0.2 * u * v + 5.0 * std::exp(-80.0 * (du * du + dv * dv));
    });
    adapt(field);
  }
}

inline double pdf(AWDField field, uint32_t patch, const float normal[3], Vec3 direction) {
  const Normal d(direction);
  float result = -1.0f;
  must(awdGetFieldPdf(field, patch, normal, d.values, &result));
  return static_cast<double>(result);
}

}  // namespace awdtest

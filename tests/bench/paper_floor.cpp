// SPDX-License-Identifier: Apache-2.0
#include "paper_floor.h"

#include <algorithm>
#include <cmath>

#include "support/scenes.h"

namespace bench::paper {
namespace {

using awdtest::must;
using awdtest::Vec3;

constexpr double kPi = 3.14159265358979323846;
constexpr double kAlbedo = 0.7, kEmission = 500.0;
constexpr int kSteps = 12;  // of the quadrature, along each side of the lamp
constexpr float kUp[3] = {0.0f, 1.0f, 0.0f};

struct Direction {
  float values[3];
};

Direction towards(Vec3 v) {
  const Vec3 unit = normalise(v);
  return {{static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)}};
}

}  // namespace

LoadedScene floorUnderLamp(const awd::Device& device, uint32_t width) {
  awdtest::SceneBuilder builder;
  const uint32_t floor = builder.material(awdtest::grey(kAlbedo));
  const uint32_t lamp = builder.material(awdtest::grey(0.0), awdtest::grey(kEmission));
  builder.quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, floor);
  const double h = kLampSide / 2;
  builder.quad({-h, 1, -h}, {h, 1, -h}, {h, 1, h}, {-h, 1, h}, lamp);
  LoadedScene loaded;
  loaded.name = "floor";
  awdtest::Scene scene = builder.commit(device.get());
  awdRetainScene(scene);
  loaded.scene = awd::Scene::adopt(scene);
  loaded.camera.eye[1] = 0.98f;
  loaded.camera.lookDir[1] = -1.0f;
  loaded.camera.lookDir[2] = 0.0f;
  loaded.camera.up[1] = 0.0f;
  loaded.camera.up[2] = -1.0f;
  loaded.camera.tanHalfFovX = 1.0f;
  loaded.camera.width = loaded.camera.height = width;
  return loaded;
}

uint32_t floorPatch(const LoadedScene& floor) {
  uint32_t patch = AWD_INVALID_ID;
  const float point[3] = {0.0f, 0.001f, 0.0f};
  must(awdGetPointPatch(floor.scene.get(), point, &patch));
  return patch;
}

Moments momentsAt(AWDField field, uint32_t patch, double x, double z) {
  double mean = 0.0, squares = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; k < kSteps; ++k) {
      const Vec3 way = {kLampSide * ((i + 0.5) / kSteps - 0.5) - x, 1.0,
                        kLampSide * ((k + 0.5) / kSteps - 0.5) - z};
      const double distance = length(way), cosine = 1.0 / distance;
      const double solidAngle =
          kLampSide * kLampSide / (kSteps * kSteps) * cosine / (distance * distance);
      const double value = kAlbedo / kPi * kEmission * cosine;
      float pdf = 0.0f;
      must(awdGetFieldPdf(field, patch, kUp, towards(way).values, &pdf));
      mean += value * solidAngle;
      squares += value * value / pdf * solidAngle;
    }
  }
  // A path goes on by roulette with the chance of the albedo, and is divided by it.
  return {mean, squares / kAlbedo - mean * mean};
}

uint32_t cellAt(AWDField field, uint32_t patch, uint32_t level, double x, double z) {
  AWDDirectionSample sample;
  must(awdMapDirection(field, patch, kUp, towards({-x, 1.0, -z}).values, &sample));
  const uint32_t cells = 1u << level;
  const auto cell = [&](float u) {
    return std::min(static_cast<uint32_t>(u * static_cast<float>(cells)), cells - 1);
  };
  return cell(sample.square[0]) * cells + cell(sample.square[1]);
}

}  // namespace bench::paper

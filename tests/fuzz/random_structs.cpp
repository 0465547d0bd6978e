// SPDX-License-Identifier: Apache-2.0
#include "random_structs.h"

#include <algorithm>

namespace fuzz {

namespace {

const char* const kBases[] = {nullptr, "haar",           "f2",
                              "m2",    "linear-bspline", "quadratic-bspline-periodic",
                              "none",  "../haar",        "%s%n"};

const char* basis(Bytes& bytes) { return kBases[bytes.below(sizeof kBases / sizeof *kBases)]; }
/// Small ones, or those around which arithmetic breaks.
uint32_t level(Bytes& bytes) { return bytes.below(8) ? bytes.below(4) : bytes.integer(); }
void read3(Bytes& bytes, float (&v)[3]) {
  for (float& x : v) x = real32(bytes);
}

}  // namespace

float real32(Bytes& bytes) {
  const double real = bytes.real();
  // Beyond its range a double has no float, and converting it is undefined.
  constexpr double kMost = std::numeric_limits<float>::max();
  if (std::isfinite(real) && std::abs(real) > kMost) return real > 0 ? 3e38f : -3e38f;
  return static_cast<float>(real);
}

int32_t choice(Bytes& bytes, uint32_t known) {
  const uint32_t kind = bytes.byte();
  return static_cast<int32_t>(kind < 250 ? kind % known : bytes.integer());
}

size_t structSize(Bytes& bytes, size_t known) {
  const uint32_t kind = bytes.byte();
  if (kind < 246) return known;
  // Never more than there is, unless refused before it is read.
  return kind < 253 ? bytes.below(static_cast<uint32_t>(std::min<size_t>(known, 255)) + 1)
                    : size_t{5000} + bytes.integer();
}

AWDCamera readCamera(Bytes& bytes) {
  AWDCamera camera = AWD_CAMERA_INIT;
  camera.structSize = structSize(bytes, sizeof camera);
  camera.width = 1 + bytes.below(4);
  camera.height = 1 + bytes.below(4);
  const uint32_t what = bytes.byte();
  camera.eye[0] = camera.eye[1] = camera.eye[2] = 1.5f;
  if (what & 1) read3(bytes, camera.eye);
  if (what & 2) read3(bytes, camera.lookDir);
  if (what & 4) read3(bytes, camera.up);
  if (what & 8) camera.tanHalfFovX = real32(bytes);
  if ((what & 0xf0) == 0x10) camera.width = bytes.integer();
  if ((what & 0xf0) == 0x20) camera.height = bytes.integer();
  return camera;
}

AWDMaterialDesc readMaterial(Bytes& bytes) {
  AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
  desc.structSize = structSize(bytes, sizeof desc);
  const uint32_t what = bytes.byte();
  for (float& x : desc.albedo) x = what & 1 ? real32(bytes) : static_cast<float>(what) / 255.0f;
  if (what & 2) read3(bytes, desc.emission);
  return desc;
}

AWDRay readRay(Bytes& bytes) {
  AWDRay ray = {};
  read3(bytes, ray.origin);
  read3(bytes, ray.direction);
  ray.tnear = bytes.below(4) ? 0.0f : real32(bytes);
  ray.tfar = bytes.below(4) ? std::numeric_limits<float>::infinity() : real32(bytes);
  return ray;
}

AWDRenderDesc readRenderDesc(Bytes& bytes, const AWDCamera* camera) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.structSize = structSize(bytes, sizeof desc);
  desc.camera = bytes.byte() == 255 ? nullptr : camera;
  desc.preset = choice(bytes, 2);
  desc.guide = choice(bytes, 3);
  desc.direct = choice(bytes, 4);
  desc.roulette = choice(bytes, 4);
  desc.combination = choice(bytes, 4);
  desc.points = choice(bytes, 3);
  desc.lights = choice(bytes, 3);
  const uint32_t what = bytes.byte();
  if (what & 1) desc.shadowRays = bytes.below(8) ? bytes.below(5) : bytes.integer();
  if (what & 2) desc.maxLights = bytes.integer();
  if (what & 4) desc.maxSplit = bytes.integer();
  if (what & 8) desc.maxBytes = uint64_t{bytes.integer()} << bytes.below(33);
  desc.seed = bytes.byte();
  // A thousand shadow rays a vertex are a matter of time alone.
  if (desc.shadowRays > 64 && desc.shadowRays <= 1024) desc.shadowRays = 64;
  return desc;
}

AWDFieldDesc readFieldDesc(Bytes& bytes, float* powers) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.structSize = structSize(bytes, sizeof desc);
  const uint32_t what = bytes.byte(), more = bytes.byte();
  desc.preset = choice(bytes, 2);
  desc.map = choice(bytes, 5);
  desc.patches = choice(bytes, 3);
  desc.estimator = choice(bytes, 7);
  desc.target = choice(bytes, 3);
  if (what & 1) desc.basis = basis(bytes);
  if (what & 2) desc.startLevel = level(bytes);
  if (what & 4) desc.maxLevel = level(bytes);
  if (what & 8) desc.tau = bytes.real();
  if (what & 16) desc.shrinkage = bytes.real();
  if (what & 32) desc.alpha = static_cast<float>(bytes.below(16)) / 8.0f - 0.5f;
  if (what & 64) desc.maxBytes = uint64_t{bytes.integer()} << bytes.below(33);
  if (what & 128) desc.patchSamples = bytes.integer();
  for (float& x : desc.upper) x = 1.0f;
  if (more & 1) read3(bytes, desc.lower);
  if (more & 2) read3(bytes, desc.upper);
  if (more & 4) desc.alpha = real32(bytes);
  if (more & 8) desc.lightCount = bytes.below(8) ? bytes.below(5) : bytes.integer();
  if (more & 16) {
    for (uint32_t i = 0; i < AWD_MOST_FIELD_LIGHTS; ++i) powers[i] = i < 5 ? real32(bytes) : 1.0f;
    desc.lightPowers = powers;
  }
  if (more & 32) desc.refitSolver = "../ceres";
  return desc;
}

AWDDensityDesc readDensityDesc(Bytes& bytes, AWDDensityAxis* axes) {
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.structSize = structSize(bytes, sizeof desc);
  desc.dimensions = bytes.below(16) ? 1 + bytes.below(AWD_MAX_DIMENSIONS) : bytes.integer();
  desc.structure = choice(bytes, 3);
  desc.estimator = choice(bytes, 7);
  desc.target = choice(bytes, 3);
  desc.sampler = choice(bytes, 3);
  desc.combination = choice(bytes, 3);
  const uint32_t what = bytes.byte();
  if (what & 1) desc.tau = bytes.real();
  if (what & 2) desc.shrinkage = bytes.real();
  if (what & 4) desc.passSamples = uint64_t{bytes.integer()} << bytes.below(33);
  desc.maxCoefficients = 200;
  if (what & 8) desc.maxCoefficients = uint64_t{bytes.integer()} << bytes.below(33);
  if (what & 16) desc.refitBytes = bytes.integer();
  if (what & 32) {
    for (uint32_t a = 0; a < AWD_MAX_DIMENSIONS; ++a) {
      axes[a].basis = basis(bytes);
      axes[a].startLevel = bytes.below(2) ? 0 : level(bytes);
      axes[a].maxLevel = bytes.below(2) ? 0 : level(bytes);
    }
    desc.axes = axes;
  }
  return desc;
}

}  // namespace fuzz

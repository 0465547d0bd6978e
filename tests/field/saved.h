// SPDX-License-Identifier: Apache-2.0
// Fields of every kind, what is recorded in them, and their bytes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "field/trained.h"

namespace awdtest {

using Bytes = std::vector<char>;

inline Bytes saved(AWDField field) {
  size_t size = 0;
  must(awdSaveField(field, nullptr, 0, &size));
  Bytes bytes(size);
  must(awdSaveField(field, bytes.data(), bytes.size(), &size));
  return bytes;
}

inline Field loaded(AWDDevice device, const Bytes& bytes) {
  Field field;
  must(awdLoadField(device, bytes.data(), bytes.size(), field.out()));
  return field;
}

/// Without printing thousands of bytes when they differ.
inline bool sameBytes(AWDField a, AWDField b) { return saved(a) == saved(b); }

struct FieldCase {
  const char* name;
  AWDFieldDesc desc;
  bool spatial() const { return desc.patches == AWD_PATCHES_SPATIAL; }
};

inline AWDFieldDesc spatialDesc() {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.patches = AWD_PATCHES_SPATIAL;
  desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
  desc.patchSamples = 40;
  return desc;
}

inline std::vector<FieldCase> fieldCases() {
  const auto with = [](AWDEstimator estimator, const char* basis) {
    AWDFieldDesc desc = fieldDesc(AWD_MAP_DEFAULT, 1, 2);
    desc.estimator = estimator;
    desc.basis = basis;
    return desc;
  };
  AWDFieldDesc paper = AWD_FIELD_DESC_INIT, small = spatialDesc(), lights = spatialDesc();
  lights.lightCount = 3;
  AWDFieldDesc squares = spatialDesc();
  squares.target = AWD_TARGET_RMS;
  paper.preset = AWD_PRESET_PAPER;
  small.maxBytes = 200000;
  return {
      {"host", AWD_FIELD_DESC_INIT},
      {"spatial", spatialDesc()},
      {"capped", small},
      {"lights", lights},
      {"squares", squares},
      {"paper", paper},
      {"ratio", with(AWD_ESTIMATOR_RATIO, "quadratic-bspline")},
      {"quasi", with(AWD_ESTIMATOR_QUASI, "m2")},
#ifdef AWD_TEST_REFIT
      {"refit", with(AWD_ESTIMATOR_REFIT, "haar")},
#endif
  };
}

/// A sample with what came from it.
struct Fed {
  uint32_t patch;
  AWDDirectionSample sample;
  double value;
  uint32_t light = AWD_INVALID_ID;  ///< of which half as much came
};

inline Fed drawFed(AWDField field, bool spatial, Random& random) {
  static const std::vector<Normal> normals = someNormals();
  const Normal& normal = normals[random.bits() % normals.size()];
  Fed fed = {static_cast<uint32_t>(random.bits() % 3), {}, 0.0};
  const uint64_t light = random.bits() % 3;
  if (spatial) {
    const auto coordinate = [&] { return static_cast<float>(std::pow(random.uniform(), 2.0)); };
    const float position[3] = {coordinate(), coordinate(), 0.25f};
    must(awdFindPatch(field, position, normal.values, &fed.patch));
  }
  fed.sample = draw(field, fed.patch, normal.values, random);
  fed.value = random.uniform() * static_cast<double>(fed.sample.square[0]);
  float chance;
  if (!awdGetLightChance(field, fed.patch, 0, &chance)) fed.light = static_cast<uint32_t>(light);
  return fed;
}

inline void recordFed(AWDField field, const Fed& fed) {
  must(awdRecordField(field, fed.patch, &fed.sample, fed.value));
  if (fed.light != AWD_INVALID_ID) {
    must(awdRecordLight(field, fed.patch, fed.light, fed.value / (1.0 + fed.light)));
  }
}

inline void feed(AWDField field, bool spatial, Random& random, size_t samples) {
  for (size_t i = 0; i < samples; ++i) recordFed(field, drawFed(field, spatial, random));
}

/// After two passes.
inline Field trainedField(AWDDevice device, const FieldCase& c) {
  Field field = newField(device, &c.desc);
  Random random(17);
  for (int pass = 0; pass < 2; ++pass) {
    feed(field, c.spatial(), random, 1500);
    adapt(field);
  }
  return field;
}

}  // namespace awdtest

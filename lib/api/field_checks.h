// SPDX-License-Identifier: Apache-2.0
// What a field can take from a host.
#pragma once

#include <cmath>

#include "api/guard.h"
#include "guide/field.h"

namespace awd {

/// Directions and normals must be unit vectors to this accuracy...
constexpr float kUnitTolerance = 1e-3f;
/// ...and are used as they are to this one: in a frame of other lengths a pdf would not be that of
/// its sample.
constexpr float kUnitAsIs = 1e-5f;

inline Vec3f unitVector(const float v[3], const char* argument) {
  const Vec3f vector = load(need(v, argument));
  const float square = dot(vector, vector);
  if (!(std::abs(square - 1.0f) <= 2.0f * kUnitTolerance)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "%s is (%g, %g, %g): it must be a unit vector", argument,
         vector.x, vector.y, vector.z);
  }
  return std::abs(square - 1.0f) <= 2.0f * kUnitAsIs ? vector : vector * (1.0f / std::sqrt(square));
}

inline Vec3f finitePoint(const float v[3], const char* argument) {
  const Vec3f point = load(need(v, argument));
  if (!isFinite(point)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "%s is (%g, %g, %g): it must be finite", argument, point.x,
         point.y, point.z);
  }
  return point;
}

inline void checkUniforms(const double uniforms[3]) {
  need(uniforms, "uniforms");
  for (int i = 0; i < 3; ++i) {
    if (!(uniforms[i] >= 0.0 && uniforms[i] < 1.0)) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "uniforms[%d] is %g: it must be in [0,1)", i, uniforms[i]);
    }
  }
}

inline void checkSpatial(const Field& field) {
  if (field.isSpatial()) return;
  fail(AWD_ERROR_INVALID_OPERATION,
       "the field has the host's patches: AWD_PATCHES_SPATIAL makes its own");
}

/// What the field's estimator goes by.
inline void checkSample(const Field& field, const AWDDirectionSample& sample) {
  if (!(sample.solidAngle > 0.0f && std::isfinite(sample.solidAngle))) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "sample->solidAngle is %g: the sample must come from awdSampleField", sample.solidAngle);
  }
  if (field.settings().learning.estimator == AWD_ESTIMATOR_PAPER) return;
  const float* at = sample.square;
  if (!(at[0] >= 0.0f && at[0] <= 1.0f && at[1] >= 0.0f && at[1] <= 1.0f)) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "sample->square is (%g, %g): the sample must come from awdSampleField", at[0], at[1]);
  }
  if (!(sample.pdf >= 0.0f && std::isfinite(sample.pdf))) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "sample->pdf is %g: the sample must come from awdSampleField",
         sample.pdf);
  }
}

/// Calls body(i) for `count` items; an error says at which it was.
template <class Body>
void forEachItem(size_t count, Body&& body) {
  for (size_t i = 0; i < count; ++i) {
    try {
      body(i);
    } catch (const Error& error) {
      fail(error.code(), "%s (item %zu)", error.what(), i);
    }
  }
}

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// What a path brought, recorded from its end on.
#include <cmath>

#include "guide/field.h"

namespace awd {

namespace {

Vec3d exact(const float v[3]) { return convert<double>(load(v)); }

/// As that of Rgb, with the range of doubles.
double luminance(Vec3d c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

bool isPositive(float x) { return x > 0.0f && std::isfinite(x); }

/// Whether all that recording goes by makes sense.
bool canBeRecorded(const AWDDirectionSample& sample) {
  const float* at = sample.square;
  return isPositive(sample.pdf) && isPositive(sample.solidAngle) && at[0] >= 0.0f &&
         at[0] <= 1.0f && at[1] >= 0.0f && at[1] <= 1.0f;
}

}  // namespace

Vec3d Field::recordPath(const AWDPathVertex* vertices, std::size_t count, Vec3d background) {
  Vec3d radiance = background;
  for (std::size_t i = count; i-- > 0;) {
    const AWDPathVertex& vertex = vertices[i];
    const AWDDirectionSample& sample = vertex.sample;
    Vec3d leaving = exact(vertex.emitted) + exact(vertex.direct);
    if (vertex.continuation > 0.0f) {
      const Vec3d reflected = exact(vertex.scattering) * radiance;
      if (vertex.patch != AWD_INVALID_ID) {
        if (canBeRecorded(sample)) {
          record(vertex.patch, sample, luminance(reflected));
        } else {
          reject(vertex.patch);
        }
      }
      const double chance =
          static_cast<double>(sample.pdf) * static_cast<double>(vertex.continuation);
      const Vec3d part = reflected * (1.0 / chance);
      if (isPositive(sample.pdf) && isFinite(part)) leaving += part;
    }
    radiance = leaving;
  }
  return radiance;
}

}  // namespace awd

/* SPDX-License-Identifier: Apache-2.0
 *
 * Vectors of three floats: places, directions and colours.
 */
#ifndef VECTOR_H
#define VECTOR_H

#include <math.h>

typedef struct Vector {
  float x, y, z;
} Vector;

static inline Vector makeVector(float x, float y, float z) {
  const Vector v = {x, y, z};
  return v;
}

static inline Vector add(Vector a, Vector b) { return makeVector(a.x + b.x, a.y + b.y, a.z + b.z); }

static inline Vector subtract(Vector a, Vector b) {
  return makeVector(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline Vector scale(float s, Vector a) { return makeVector(s * a.x, s * a.y, s * a.z); }

/* Component by component, as light is filtered by an albedo. */
static inline Vector multiply(Vector a, Vector b) {
  return makeVector(a.x * b.x, a.y * b.y, a.z * b.z);
}

static inline float dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline Vector cross(Vector a, Vector b) {
  return makeVector(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline Vector normalize(Vector a) { return scale(1.0f / sqrtf(dot(a, a)), a); }

static inline float largest(Vector a) { return fmaxf(a.x, fmaxf(a.y, a.z)); }

static inline float luminance(Vector a) { return 0.2126f * a.x + 0.7152f * a.y + 0.0722f * a.z; }

#endif

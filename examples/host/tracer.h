/* SPDX-License-Identifier: Apache-2.0
 *
 * A path tracer for diffuse scenes: roulette by albedo, one shadow ray a vertex if wanted, and
 * directions either by the cosine or from a field of libawd.
 */
#ifndef TRACER_H
#define TRACER_H

#include "awd/awd.h"
#include "film.h"
#include "random.h"
#include "scene.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Tracer {
  const Scene* scene;
  int shadowRays; /* 0: the lamp is found by paths that hit it */
  AWDField field; /* NULL: directions by the cosine */
  Random random;
  uint64_t scattered; /* rays that left a surface */
  uint64_t lampHits;  /* of these: that met the shining side of the lamp */
} Tracer;

/* Adds `samples` to each pixel. Of a field, whatever its rays bring is recorded. */
AWDResult renderSamples(Tracer* tracer, Film* film, uint64_t samples);

/* Adds `samples` to each pixel, in passes between which a field of its own learns. */
AWDResult renderGuided(Tracer* tracer, AWDDevice device, Film* film, uint64_t samples);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: Apache-2.0
 *
 * A scene rendered unguided and guided, both against a reference.
 */
#ifndef COMPARISON_H
#define COMPARISON_H

#include "tracer.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Settings {
  int size;
  uint64_t samples, referenceSamples; /* of each pixel, at least 2 */
  uint64_t seed;                      /* same seed, same bits */
  const char* out;                    /* file for unguided, guided, reference; NULL: none */
} Settings;

typedef struct Shot {
  Difference difference; /* from the reference */
  double seconds;        /* of all processors, learning included */
  uint64_t scattered, lampHits;
} Shot;

typedef struct Comparison {
  Shot unguided, guided;
} Comparison;

/* NULL, or why it can't be done. The reference is rendered unguided and with shadow rays. */
const char* compareGuiding(const Scene* scene, int shadowRays, const Settings* settings,
                           Comparison* comparison);

/* A whole command: reads options, whose defaults are in `settings`, compares, prints. Returns the
   exit code: 0 done, 1 failed, 2 misused. `name` begins each message, `about` the help. */
int runCommand(const char* name, const char* about, int count, char** arguments, const Scene* scene,
               int shadowRays, Settings settings);

#ifdef __cplusplus
}
#endif

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "comparison.h"

#include <time.h>

enum { UNGUIDED, GUIDED, REFERENCE, FILMS };

static AWDResult render(const Scene* scene, int shadowRays, AWDDevice device, uint64_t samples,
                        uint64_t seed, Film* film, Shot* shot) {
  Tracer tracer = {scene, shadowRays, NULL, {1}, 0, 0};
  const clock_t start = clock();
  AWDResult result;
  seedRandom(&tracer.random, seed);
  result =
      device ? renderGuided(&tracer, device, film, samples) : renderSamples(&tracer, film, samples);
  shot->seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  shot->scattered = tracer.scattered;
  shot->lampHits = tracer.lampHits;
  return result;
}

static const char* compareOnFilms(const Scene* scene, int shadowRays, const Settings* settings,
                                  AWDDevice device, Film* films, Comparison* comparison) {
  Shot reference;
  AWDResult result = render(scene, shadowRays, NULL, settings->samples, 3 * settings->seed,
                            &films[UNGUIDED], &comparison->unguided);
  if (result == AWD_SUCCESS) {
    result = render(scene, shadowRays, device, settings->samples, 3 * settings->seed + 1,
                    &films[GUIDED], &comparison->guided);
  }
  if (result == AWD_SUCCESS) {
    result = render(scene, 1, NULL, settings->referenceSamples, 3 * settings->seed + 2,
                    &films[REFERENCE], &reference);
  }
  if (result != AWD_SUCCESS) return awdGetLastErrorMessage();
  if (!compareFilms(&films[UNGUIDED], &films[REFERENCE], &comparison->unguided.difference) ||
      !compareFilms(&films[GUIDED], &films[REFERENCE], &comparison->guided.difference)) {
    return "out of memory";
  }
  if (settings->out && !writeFilms(films, FILMS, settings->out)) return "can't write the image";
  return NULL;
}

const char* compareGuiding(const Scene* scene, int shadowRays, const Settings* settings,
                           Comparison* comparison) {
  Film films[FILMS];
  AWDDevice device = NULL;
  const char* error = NULL;
  int i;
  if (awdNewDevice(NULL, &device) != AWD_SUCCESS) return awdGetLastErrorMessage();
  for (i = 0; i < FILMS; ++i) {
    if (!makeFilm(&films[i], settings->size)) error = "out of memory";
  }
  if (!error) {
    error = compareOnFilms(scene, shadowRays, settings, device, films, comparison);
  }
  for (i = 0; i < FILMS; ++i) releaseFilm(&films[i]);
  awdReleaseDevice(device);
  return error;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "tracer.h"

static const float kPi = 3.14159265f;

/* Roulette ends paths long before; no albedo of ours lets one in 1e7 come so far. */
#define MOST_VERTICES 64

static void store(Vector v, float* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

static int isLit(const Scene* scene, const Hit* hit) {
  return hit->quad == scene->lamp && dot(hit->normal, scene->quads[scene->lamp].normal) > 0.0f;
}

/* Light of the lamp that a surface reflects, by one shadow ray. */
static Vector reflectLamp(Tracer* tracer, const Hit* hit, Vector albedo) {
  const Scene* scene = tracer->scene;
  const Quad* lamp = &scene->quads[scene->lamp];
  const Vector dark = {0.0f, 0.0f, 0.0f};
  const Vector across = scale((float)nextUniform(&tracer->random), lamp->a);
  const Vector along = scale((float)nextUniform(&tracer->random), lamp->b);
  const Vector point = add(lamp->corner, add(across, along));
  const Vector way = subtract(point, hit->position), normalOfArea = cross(lamp->a, lamp->b);
  const float squared = dot(way, way);
  /* Cosines times lengths, and times the lamp's area. */
  const float here = dot(hit->normal, way), there = -dot(normalOfArea, way);
  if (hit->quad == scene->lamp || here <= 0.0f || there <= 0.0f) return dark;
  if (!seesLamp(scene, hit->position, hit->quad, point)) return dark;
  return scale(here * there / (kPi * squared * squared), multiply(albedo, scene->emission));
}

/* The plain way: pdf cos / pi, on a disk below the hemisphere. */
static Vector sampleCosine(Random* random, Vector normal, float* pdf) {
  const float angle = 2.0f * kPi * (float)nextUniform(random);
  const double squared = nextUniform(random);
  const float radius = (float)sqrt(squared), height = (float)sqrt(1.0 - squared);
  const Vector axis =
      fabsf(normal.x) < 0.6f ? makeVector(1.0f, 0.0f, 0.0f) : makeVector(0.0f, 1.0f, 0.0f);
  const Vector u = normalize(cross(axis, normal)), v = cross(normal, u);
  const Vector inPlane = add(scale(radius * cosf(angle), u), scale(radius * sinf(angle), v));
  *pdf = height / kPi;
  return add(inPlane, scale(height, normal));
}

/* From what the field knows of this place. */
static AWDResult sampleGuided(Tracer* tracer, const Hit* hit, AWDPathVertex* vertex) {
  double uniforms[3];
  float position[3], normal[3];
  AWDResult result;
  int i;
  store(hit->position, position);
  store(hit->normal, normal);
  for (i = 0; i < 3; ++i) uniforms[i] = nextUniform(&tracer->random);
  result = awdFindPatch(tracer->field, position, normal, &vertex->patch);
  if (result != AWD_SUCCESS) return result;
  return awdSampleField(tracer->field, vertex->patch, normal, uniforms, &vertex->sample);
}

/* Radiance seen from the camera in a direction. */
static AWDResult tracePath(Tracer* tracer, Vector direction, Vector* radiance) {
  static const AWDPathVertex kEmpty = {AWD_INVALID_ID, 0.0f,   {{0.0f}, 0.0f, {0.0f}, 0, 0.0f},
                                       {0.0f},         {0.0f}, {0.0f}};
  const Scene* scene = tracer->scene;
  AWDPathVertex vertices[MOST_VERTICES];
  Vector origin = scene->eye, weight = {1.0f, 1.0f, 1.0f};
  size_t count = 0;
  int from = -1, goesOn = 1;
  *radiance = makeVector(0.0f, 0.0f, 0.0f);
  while (goesOn) {
    const Hit hit = intersect(scene, origin, direction, from);
    Vector albedo, emitted = {0.0f, 0.0f, 0.0f}, direct = {0.0f, 0.0f, 0.0f}, scattering;
    AWDPathVertex* vertex = &vertices[count];
    float continuation, pdf;
    if (hit.quad < 0) break;
    ++count;
    albedo = scene->quads[hit.quad].albedo;
    if (isLit(scene, &hit)) {
      if (count > 1) ++tracer->lampHits;
      /* What shadow rays found already must not count twice. */
      if (count == 1 || !tracer->shadowRays) emitted = scene->emission;
    }
    if (tracer->shadowRays) direct = reflectLamp(tracer, &hit, albedo);
    *radiance = add(*radiance, multiply(weight, add(emitted, direct)));
    continuation = count < MOST_VERTICES ? largest(albedo) : 0.0f;
    goesOn = nextUniform(&tracer->random) < continuation;
    if (tracer->field) {
      *vertex = kEmpty;
      store(emitted, vertex->emitted);
      store(direct, vertex->direct);
    }
    if (!goesOn) break;

    ++tracer->scattered;
    if (tracer->field) {
      const AWDResult result = sampleGuided(tracer, &hit, vertex);
      if (result != AWD_SUCCESS) return result;
      direction = makeVector(vertex->sample.direction[0], vertex->sample.direction[1],
                             vertex->sample.direction[2]);
      pdf = vertex->sample.pdf;
    } else {
      direction = sampleCosine(&tracer->random, hit.normal, &pdf);
    }
    scattering = scale(fmaxf(dot(direction, hit.normal), 0.0f) / kPi, albedo);
    if (tracer->field) {
      vertex->continuation = continuation;
      store(scattering, vertex->scattering);
    }
    /* A ray along the surface, of pdf 0, brings nothing. */
    weight = pdf > 0.0f ? scale(1.0f / (pdf * continuation), multiply(weight, scattering))
                        : makeVector(0.0f, 0.0f, 0.0f);
    origin = hit.position;
    from = hit.quad;
  }
  /* Nothing comes from beyond the scene: no background. The radiance is known already. */
  return tracer->field ? awdRecordFieldPath(tracer->field, count, vertices, NULL, NULL)
                       : AWD_SUCCESS;
}

AWDResult renderSamples(Tracer* tracer, Film* film, uint64_t samples) {
  const double width = 1.0 / film->size;
  uint64_t s;
  int x, y;
  for (y = 0; y < film->size; ++y) {
    for (x = 0; x < film->size; ++x) {
      for (s = 0; s < samples; ++s) {
        const double u = nextUniform(&tracer->random), v = nextUniform(&tracer->random);
        const Vector direction = lookThrough(tracer->scene, width * (x + u), width * (y + v));
        Vector radiance;
        const AWDResult result = tracePath(tracer, direction, &radiance);
        if (result != AWD_SUCCESS) return result;
        addSample(film, y * film->size + x, radiance);
      }
    }
  }
  film->samples += samples;
  return AWD_SUCCESS;
}

/* Passes of 1, 1, 1, 2, 2, 2, 4, ... samples. During one the field stays as it is, so each is
   unbiased, and so is their sum. */
static AWDResult renderPasses(Tracer* tracer, Film* film, uint64_t samples) {
  uint64_t size = 1, left = samples;
  int pass;
  for (pass = 1;; ++pass) {
    AWDResult result;
    if (size > left) size = left;
    result = renderSamples(tracer, film, size);
    left -= size;
    if (result != AWD_SUCCESS || left == 0) return result;
    result = awdAdaptField(tracer->field, NULL);
    if (result != AWD_SUCCESS) return result;
    if (pass % 3 == 0) size *= 2;
  }
}

AWDResult renderGuided(Tracer* tracer, AWDDevice device, Film* film, uint64_t samples) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  AWDResult result;
  store(tracer->scene->lower, desc.lower);
  store(tracer->scene->upper, desc.upper);
  result = awdNewField(device, &desc, &tracer->field);
  if (result == AWD_SUCCESS) {
    result = awdSetFieldScale(tracer->field, luminance(tracer->scene->emission));
  }
  if (result == AWD_SUCCESS) result = renderPasses(tracer, film, samples);
  awdReleaseField(tracer->field);
  tracer->field = NULL;
  return result;
}

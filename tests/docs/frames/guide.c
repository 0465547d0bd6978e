/* SPDX-License-Identifier: Apache-2.0
 *
 * The renderer that examples/host/GUIDE.md guides step by step, and what it is asked to do.
 * sources: examples/host/scene.c
 */
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "scene.h"

#define SIZE 16   /* of the image, on both axes */
#define LIGHTS 2u /* the lamp's halves */
#define MOST_VERTICES 64

static const float kPi = 3.14159265f;

typedef struct Renderer {
  const Scene* scene;
  struct AWDFieldImpl* field;
  Random random;
  float share;    /* of the field, beside the BSDF */
  float expected; /* radiance of a pixel, as far as it is known */
  int furnace;
  int recursive;
  uint64_t samples; /* of each pixel so far */
  Vector film[SIZE * SIZE];
} Renderer;

typedef struct Rows {
  Renderer renderer;
  Vector* film;
  uint64_t seed;
  int first, last;
  int32_t result;
} Rows;

static void toArray(Vector v, float* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

static Vector toVector(const float* v) { return makeVector(v[0], v[1], v[2]); }

static Vector albedoAt(const Renderer* r, const Hit* hit) {
  return r->furnace ? makeVector(0.5f, 0.5f, 0.5f) : r->scene->quads[hit->quad].albedo;
}

/* But for what shadow rays find. */
static Vector emittedAt(const Renderer* r, const Hit* hit, int depth) {
  const Scene* scene = r->scene;
  if (r->furnace) return makeVector(1.0f, 1.0f, 1.0f);
  return depth == 0 && hit->quad == scene->lamp &&
                 dot(hit->normal, scene->quads[scene->lamp].normal) > 0.0f
             ? scene->emission
             : makeVector(0.0f, 0.0f, 0.0f);
}

static Vector sampleLight(Renderer* r, const Hit* hit, uint32_t light) {
  const Scene* scene = r->scene;
  const Quad* lamp = &scene->quads[scene->lamp];
  const float s = 0.5f * ((float)light + (float)nextUniform(&r->random));
  const float t = (float)nextUniform(&r->random);
  const Vector point = add(lamp->corner, add(scale(s, lamp->a), scale(t, lamp->b)));
  const Vector way = subtract(point, hit->position);
  const float squared = dot(way, way), here = dot(hit->normal, way);
  const float there = -0.5f * dot(cross(lamp->a, lamp->b), way); /* times the area */
  if (r->furnace || hit->quad == scene->lamp || here <= 0.0f || there <= 0.0f ||
      !seesLamp(scene, hit->position, hit->quad, point)) {
    return makeVector(0.0f, 0.0f, 0.0f);
  }
  return scale(here * there / (kPi * squared * squared),
               multiply(albedoAt(r, hit), scene->emission));
}

static float bsdfPdf(const float normal[3], const float direction[3]) {
  const float c = dot(toVector(normal), toVector(direction));
  return c > 0.0f ? c / kPi : 0.0f;
}

static void sampleBsdf(Random* random, const float normal[3], float direction[3]) {
  const Vector n = toVector(normal);
  const float angle = 2.0f * kPi * (float)nextUniform(random);
  const double squared = nextUniform(random);
  const float radius = (float)sqrt(squared), height = (float)sqrt(1.0 - squared);
  const Vector axis =
      fabsf(n.x) < 0.6f ? makeVector(1.0f, 0.0f, 0.0f) : makeVector(0.0f, 1.0f, 0.0f);
  const Vector u = normalize(cross(axis, n)), v = cross(n, u);
  toArray(normalize(add(add(scale(radius * cosf(angle), u), scale(radius * sinf(angle), v)),
                        scale(height, n))),
          direction);
}

static float meanOf(const Renderer* r) {
  float sum = 0.0f;
  int i;
  for (i = 0; i < SIZE * SIZE; ++i) sum += luminance(r->film[i]);
  return sum / (float)(SIZE * SIZE) / (float)r->samples;
}

typedef struct Wave {
  size_t count;
  float* positions;
  float* normals;
  double* uniforms;
  uint32_t* patches;
  struct AWDDirectionSample* samples;
  double* values;
} Wave;

static int32_t renderPixel(Renderer* r, int x, int y);
static int32_t renderSample(Renderer* r, int threads);
static int32_t renderHalf(Renderer* r, int half);

/* @functions */

/* Into the first pixel of a film of its own: rows have copies of the renderer. */
static AWDResult renderPixel(Renderer* r, int x, int y) {
  const double across = (x + nextUniform(&r->random)) / SIZE;
  const double down = (y + nextUniform(&r->random)) / SIZE;
  const Vector direction = lookThrough(r->scene, across, down);
  Vector* pixel = &r->film[y * SIZE + x];
  Vector seen;
  if (r->recursive) {
    TRY(shade(r, r->scene->eye, direction, -1, 1.0f, 0, &seen));
  } else {
    TRY(tracePath(r, r->scene->eye, direction, &seen));
  }
  *pixel = add(*pixel, seen);
  return AWD_SUCCESS;
}

static void setRows(Rows* rows, const Renderer* r, int first, int last) {
  rows->renderer = *r;
  rows->seed = (r->random.state >> 8) + r->samples;
  rows->first = first;
  rows->last = last;
  rows->result = AWD_SUCCESS;
}

static AWDResult takeRows(Renderer* r, const Rows* rows) {
  const size_t begin = (size_t)rows->first * SIZE, end = (size_t)rows->last * SIZE;
  memcpy(r->film + begin, rows->renderer.film + begin, (end - begin) * sizeof *r->film);
  return rows->result;
}

static AWDResult renderSample(Renderer* r, int threads) {
  Rows* rows = (Rows*)malloc((size_t)threads * sizeof *rows);
  pthread_t* handles = (pthread_t*)malloc((size_t)threads * sizeof *handles);
  AWDResult result = AWD_SUCCESS;
  int i;
  if (!rows || !handles) abort();
  for (i = 0; i < threads; ++i) {
    setRows(&rows[i], r, SIZE * i / threads, SIZE * (i + 1) / threads);
    if (pthread_create(&handles[i], NULL, renderRows, &rows[i]) != 0) abort();
  }
  for (i = 0; i < threads; ++i) {
    AWDResult ofRows;
    pthread_join(handles[i], NULL);
    ofRows = takeRows(r, &rows[i]);
    if (ofRows != AWD_SUCCESS) result = ofRows;
  }
  ++r->samples;
  free(handles);
  free(rows);
  return result;
}

static AWDResult renderHalf(Renderer* r, int half) {
  static Rows rows;
  setRows(&rows, r, half ? SIZE / 2 : 0, half ? SIZE : SIZE / 2);
  renderRows(&rows);
  return takeRows(r, &rows);
}

/* --- what is asked of it --------------------------------------------------------------------- */

#define CHECK(condition)                                                                           \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      printf("line %d: not so: %s\n", __LINE__, #condition);                                       \
      exit(1);                                                                                     \
    }                                                                                              \
  } while (0)

static void need(AWDResult result) {
  if (result == AWD_SUCCESS) return;
  printf("%s\n", awdGetLastErrorMessage());
  exit(1);
}

static AWDDevice device;
static Scene scene;

static Renderer* start(uint64_t seed, float share) {
  Renderer* r = (Renderer*)calloc(1, sizeof *r);
  CHECK(r);
  r->scene = &scene;
  r->share = share;
  r->expected = 1.0f;
  seedRandom(&r->random, seed);
  need(makeField(device, &scene, &r->field));
  return r;
}

static void finish(Renderer* r) {
  awdReleaseField(r->field);
  free(r);
}

/* Mean brightness by passes of one sample after those that taught the field; and its variance. */
static double brightness(Renderer* r, int learning, double* variance) {
  enum { PASSES = 64 };
  double sum = 0.0, squares = 0.0;
  int i;
  if (learning) {
    need(renderPasses(r, 1, learning));
    need(awdAdaptField(r->field, NULL));
  }
  for (i = 0; i < PASSES; ++i) {
    double mean;
    memset(r->film, 0, sizeof r->film);
    need(renderSample(r, 1));
    mean = (double)meanOf(r) * (double)r->samples;
    sum += mean;
    squares += mean * mean;
  }
  sum /= PASSES;
  *variance = (squares / PASSES - sum * sum) / (PASSES - 1);
  return sum;
}

/* Null hypothesis: guided and unguided have one mean. One alarm of 16,000 would be false. */
static void checkUnbiased(int recursive, float share) {
  Renderer* plain = start(1, share);
  Renderer* guided = start(2, share);
  double ofPlain, ofGuided, first, second;
  plain->recursive = guided->recursive = recursive;
  first = brightness(plain, 0, &ofPlain);
  second = brightness(guided, 63, &ofGuided);
  CHECK(first > 0.0 && second > 0.0);
  CHECK(fabs(first - second) < 4.0 * sqrt(ofPlain + ofGuided));
  CHECK(ofGuided < ofPlain); /* seen with these seeds: it has learned */
  finish(guided);
  finish(plain);
}

static size_t saved(const Renderer* r, char** bytes) {
  size_t size = 0;
  need(awdSaveField(r->field, NULL, 0, &size));
  *bytes = (char*)malloc(size);
  CHECK(*bytes);
  need(awdSaveField(r->field, *bytes, size, &size));
  return size;
}

static void checkSame(const Renderer* a, const Renderer* b) {
  char *ofA, *ofB;
  const size_t size = saved(a, &ofA);
  CHECK(saved(b, &ofB) == size && memcmp(ofA, ofB, size) == 0);
  CHECK(memcmp(a->film, b->film, sizeof a->film) == 0);
  free(ofA);
  free(ofB);
}

static void checkThreadsAndParts(void) {
  Renderer* one = start(3, 0.8f);
  Renderer* three = start(3, 0.8f);
  int givenUp = 1;
  need(renderPasses(one, 1, 7));
  need(renderPasses(three, 3, 7));
  checkSame(one, three);
  need(awdAdaptField(one->field, NULL));
  need(awdAdaptField(three->field, NULL));
  need(renderInParts(one, device, "guide.field"));
  need(renderSample(three, 1));
  need(awdAdaptField(three->field, NULL));
  checkSame(one, three);
  memcpy(three->film, one->film, sizeof one->film);
  need(tryPass(three, 1, &givenUp));
  memcpy(three->film, one->film, sizeof one->film);
  givenUp = 0;
  need(tryPass(three, 1, &givenUp));
  CHECK(remove("guide.field") == 0);
  finish(three);
  finish(one);
}

static void checkFurnace(int recursive) {
  Renderer* r = start(4, 0.7f);
  float mean = 0.0f;
  r->recursive = recursive;
  need(furnace(r, 2, &mean));
  CHECK(fabsf(mean - 2.0f) < 0.02f);
  finish(r);
}

/* One chosen shadow ray has the mean of one to each light; what a single ray brings varies little.
 */
static void checkLights(void) {
  enum { RAYS = 4000 };
  const float position[3] = {3.2f, 2.5f, 3.3f}, normal[3] = {0.0f, -1.0f, 0.0f};
  const Hit ceiling = {1, {3.2f, 2.5f, 3.3f}, {0.0f, -1.0f, 0.0f}};
  Renderer* r = start(6, 1.0f);
  double chosen = 0.0, all = 0.0;
  uint32_t patch;
  int i;
  need(awdFindPatch(r->field, position, normal, &patch));
  for (i = 0; i < RAYS; ++i) {
    Vector direct;
    if (i == RAYS / 2) need(awdAdaptField(r->field, NULL));
    need(shadowRay(r, &ceiling, patch, &direct));
    chosen += (double)luminance(direct);
    all += (double)luminance(add(sampleLight(r, &ceiling, 0), sampleLight(r, &ceiling, 1)));
  }
  CHECK(all > 0.0 && fabs(chosen / all - 1.0) < 0.05);
  finish(r);
}

static void checkWave(void) {
  enum { COUNT = 5 };
  float positions[3 * COUNT], normals[3 * COUNT];
  double uniforms[3 * COUNT], values[COUNT];
  uint32_t patches[COUNT];
  AWDDirectionSample samples[COUNT];
  Wave wave = {COUNT, positions, normals, uniforms, patches, samples, values};
  Renderer* r = start(5, 1.0f);
  AWDFieldStatistics statistics = AWD_FIELD_STATISTICS_INIT;
  int i;
  for (i = 0; i < COUNT; ++i) {
    toArray(makeVector(0.5f + 0.1f * (float)i, 0.0f, 1.0f), positions + 3 * i);
    toArray(makeVector(0.0f, 1.0f, 0.0f), normals + 3 * i);
    uniforms[3 * i] = uniforms[3 * i + 1] = uniforms[3 * i + 2] = (i + 0.5) / COUNT;
    values[i] = 1.0;
  }
  need(scatterWave(r->field, &wave));
  for (i = 0; i < COUNT; ++i) {
    AWDDirectionSample single;
    need(awdSampleField(r->field, patches[i], normals + 3 * i, uniforms + 3 * i, &single));
    CHECK(memcmp(&single, &samples[i], sizeof single) == 0);
  }
  need(recordWave(r->field, &wave));
  need(awdAdaptField(r->field, &statistics));
  CHECK(statistics.samples == COUNT);
  finish(r);
}

int main(void) {
  need(awdNewDevice(NULL, &device));
  makeRoom(&scene);
  checkUnbiased(0, 0.8f);
  checkUnbiased(1, 1.0f);
  checkThreadsAndParts();
  checkFurnace(0);
  checkFurnace(1);
  checkLights();
  checkWave();
  awdReleaseDevice(device);
  return 0;
}

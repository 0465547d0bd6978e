/* SPDX-License-Identifier: Apache-2.0 */
#include "scene.h"

static int addQuad(Scene* scene, Vector corner, Vector a, Vector b, Vector albedo) {
  Quad* quad = &scene->quads[scene->count];
  const Vector normal = cross(a, b);
  const float area = sqrtf(dot(normal, normal));
  quad->corner = corner;
  quad->a = a;
  quad->b = b;
  quad->normal = scale(1.0f / area, normal);
  quad->alongA = scale(1.0f / area, cross(b, quad->normal));
  quad->alongB = scale(1.0f / area, cross(quad->normal, a));
  quad->albedo = albedo;
  return scene->count++;
}

/* A rectangle across axis 0, 1 or 2: two opposite corners of a box without thickness. */
static int addRectangle(Scene* scene, int axis, Vector lower, Vector upper, Vector albedo) {
  const Vector size = subtract(upper, lower);
  const Vector x = makeVector(size.x, 0.0f, 0.0f), y = makeVector(0.0f, size.y, 0.0f);
  const Vector z = makeVector(0.0f, 0.0f, size.z);
  return axis == 0   ? addQuad(scene, lower, y, z, albedo)
         : axis == 1 ? addQuad(scene, lower, z, x, albedo)
                     : addQuad(scene, lower, x, y, albedo);
}

/* A box that stands on the floor: nobody sees its underside. */
static void addBox(Scene* scene, Vector lower, Vector upper, Vector albedo) {
  const Vector l = lower, u = upper;
  addRectangle(scene, 0, l, makeVector(l.x, u.y, u.z), albedo);
  addRectangle(scene, 0, makeVector(u.x, l.y, l.z), u, albedo);
  addRectangle(scene, 1, makeVector(l.x, u.y, l.z), u, albedo);
  addRectangle(scene, 2, l, makeVector(u.x, u.y, l.z), albedo);
  addRectangle(scene, 2, makeVector(l.x, l.y, u.z), u, albedo);
}

static void setCamera(Scene* scene, Vector eye, Vector target, float halfWidth) {
  const Vector forward = normalize(subtract(target, eye));
  const Vector right = normalize(cross(forward, makeVector(0.0f, 1.0f, 0.0f)));
  scene->eye = eye;
  scene->forward = forward;
  scene->right = scale(halfWidth, right);
  scene->up = scale(halfWidth, cross(right, forward));
}

void makeRoom(Scene* scene) {
  const Vector white = makeVector(0.7f, 0.7f, 0.7f), grey = makeVector(0.4f, 0.4f, 0.38f);
  const Vector red = makeVector(0.4f, 0.15f, 0.12f), blue = makeVector(0.15f, 0.22f, 0.4f);
  const Vector wood = makeVector(0.4f, 0.3f, 0.2f);
  const Vector black = makeVector(0.0f, 0.0f, 0.0f);
  scene->count = 0;
  scene->lower = makeVector(0.0f, 0.0f, 0.0f);
  scene->upper = makeVector(4.0f, 2.5f, 4.0f);

  addRectangle(scene, 1, makeVector(0.0f, 0.0f, 0.0f), makeVector(4.0f, 0.0f, 4.0f), wood);
  addRectangle(scene, 1, makeVector(0.0f, 2.5f, 0.0f), makeVector(4.0f, 2.5f, 4.0f), white);
  addRectangle(scene, 0, makeVector(0.0f, 0.0f, 0.0f), makeVector(0.0f, 2.5f, 4.0f), red);
  addRectangle(scene, 0, makeVector(4.0f, 0.0f, 0.0f), makeVector(4.0f, 2.5f, 4.0f), blue);
  addRectangle(scene, 2, makeVector(0.0f, 0.0f, 0.0f), makeVector(4.0f, 2.5f, 0.0f), grey);
  addRectangle(scene, 2, makeVector(0.0f, 0.0f, 4.0f), makeVector(4.0f, 2.5f, 4.0f), grey);
  addBox(scene, makeVector(0.8f, 0.0f, 2.4f), makeVector(1.6f, 0.7f, 3.2f), grey);
  addBox(scene, makeVector(2.6f, 0.0f, 1.2f), makeVector(3.2f, 0.4f, 2.0f), red);
  addBox(scene, makeVector(0.0f, 0.0f, 3.5f), makeVector(0.6f, 1.5f, 4.0f), wood);

  /* The lamp, which shines upwards out of a tube, on a pedestal. */
  addBox(scene, makeVector(3.1f, 0.0f, 3.1f), makeVector(3.5f, 0.3f, 3.5f), wood);
  addRectangle(scene, 0, makeVector(3.0f, 0.3f, 3.0f), makeVector(3.0f, 2.0f, 3.6f), black);
  addRectangle(scene, 0, makeVector(3.6f, 0.3f, 3.0f), makeVector(3.6f, 2.0f, 3.6f), black);
  addRectangle(scene, 2, makeVector(3.0f, 0.3f, 3.0f), makeVector(3.6f, 2.0f, 3.0f), black);
  addRectangle(scene, 2, makeVector(3.0f, 0.3f, 3.6f), makeVector(3.6f, 2.0f, 3.6f), black);
  scene->lamp =
      addRectangle(scene, 1, makeVector(3.05f, 1.7f, 3.05f), makeVector(3.55f, 1.7f, 3.55f), black);
  scene->emission = makeVector(40.0f, 36.0f, 30.0f);
  setCamera(scene, makeVector(0.6f, 1.4f, 0.3f), makeVector(2.2f, 0.9f, 3.2f), 0.7f);
}

void makeFloor(Scene* scene) {
  scene->count = 0;
  scene->lower = makeVector(-4.0f, 0.0f, -4.0f);
  scene->upper = makeVector(4.0f, 2.0f, 4.0f);
  addRectangle(scene, 1, scene->lower, makeVector(4.0f, 0.0f, 4.0f), makeVector(0.6f, 0.6f, 0.6f));
  scene->lamp = addQuad(scene, makeVector(-0.4f, 2.0f, -0.4f), makeVector(0.8f, 0.0f, 0.0f),
                        makeVector(0.0f, 0.0f, 0.8f), makeVector(0.0f, 0.0f, 0.0f));
  scene->emission = makeVector(10.0f, 10.0f, 10.0f);
  setCamera(scene, makeVector(0.0f, 3.5f, 4.5f), makeVector(0.0f, 0.0f, 0.0f), 0.45f);
}

/* How far along the ray the quad is; negative: it isn't hit. */
static float distanceTo(const Quad* quad, Vector origin, Vector direction) {
  const Vector fromCorner = subtract(origin, quad->corner);
  const float t = -dot(fromCorner, quad->normal) / dot(direction, quad->normal);
  Vector place;
  float a, b;
  if (!(t > 0.0f)) return -1.0f;
  place = add(fromCorner, scale(t, direction));
  a = dot(place, quad->alongA);
  b = dot(place, quad->alongB);
  return a >= 0.0f && a <= 1.0f && b >= 0.0f && b <= 1.0f ? t : -1.0f;
}

Hit intersect(const Scene* scene, Vector origin, Vector direction, int from) {
  Hit hit = {-1, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
  float nearest = INFINITY;
  int i;
  for (i = 0; i < scene->count; ++i) {
    const float t = i == from ? -1.0f : distanceTo(&scene->quads[i], origin, direction);
    if (t > 0.0f && t < nearest) {
      nearest = t;
      hit.quad = i;
    }
  }
  if (hit.quad >= 0) {
    const Vector normal = scene->quads[hit.quad].normal;
    hit.position = add(origin, scale(nearest, direction));
    hit.normal = dot(normal, direction) < 0.0f ? normal : scale(-1.0f, normal);
  }
  return hit;
}

int seesLamp(const Scene* scene, Vector point, int from, Vector lampPoint) {
  const Vector way = subtract(lampPoint, point); /* its length is the unit of distances */
  int i;
  for (i = 0; i < scene->count; ++i) {
    float t;
    if (i == from || i == scene->lamp) continue;
    t = distanceTo(&scene->quads[i], point, way);
    if (t > 0.0f && t < 1.0f) return 0;
  }
  return 1;
}

Vector lookThrough(const Scene* scene, double x, double y) {
  const Vector across = scale((float)(2.0 * x - 1.0), scene->right);
  const Vector upwards = scale((float)(1.0 - 2.0 * y), scene->up);
  return normalize(add(scene->forward, add(across, upwards)));
}

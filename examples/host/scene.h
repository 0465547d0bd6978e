/* SPDX-License-Identifier: Apache-2.0
 *
 * Diffuse parallelograms, one of which is a lamp, and a pinhole camera. Rays try them all: there
 * are few.
 */
#ifndef SCENE_H
#define SCENE_H

#include "vector.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MOST_QUADS 40

/* corner + s a + t b, 0 <= s, t <= 1. Both sides reflect. */
typedef struct Quad {
  Vector corner, a, b;
  Vector normal; /* unit, along a x b */
  Vector alongA; /* (x - corner) . alongA = s for x in the plane */
  Vector alongB; /* likewise t */
  Vector albedo;
} Quad;

typedef struct Scene {
  Quad quads[MOST_QUADS];
  int count;
  int lamp;                       /* the quad that emits, to the side of its normal alone */
  Vector emission;                /* its radiance */
  Vector eye, forward, right, up; /* right and up reach from the middle of the image to its edges */
  Vector lower, upper;            /* box that holds all surfaces */
} Scene;

typedef struct Hit {
  int quad; /* -1: nothing was hit */
  Vector position;
  Vector normal; /* on the side of the ray */
} Hit;

/* A closed room: its lamp stands in a black tube and shines at the ceiling alone. */
void makeRoom(Scene* scene);

/* A floor, and a lamp above it that the camera doesn't see. */
void makeFloor(Scene* scene);

/* The nearest quad but for `from`, which the ray starts on; -1: on none. */
Hit intersect(const Scene* scene, Vector origin, Vector direction, int from);

/* Whether nothing is between a point of the quad `from` and one of the lamp. */
int seesLamp(const Scene* scene, Vector point, int from, Vector lampPoint);

/* The direction in which the camera sees the point (x, y) of the image, both in [0,1), y down. */
Vector lookThrough(const Scene* scene, double x, double y);

#ifdef __cplusplus
}
#endif

#endif

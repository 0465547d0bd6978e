/* SPDX-License-Identifier: Apache-2.0
 *
 * A square image that remembers the variance of its samples, and how wrong one is against another.
 */
#ifndef FILM_H
#define FILM_H

#include <stdint.h>

#include "vector.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Film {
  int size;         /* pixels along each side */
  uint64_t samples; /* of each pixel so far */
  double* sums;     /* three colours a pixel, rows from the top */
  double* squares;
} Film;

/* 0: out of memory. What was made is to be released even then. */
int makeFilm(Film* film, int size);
void releaseFilm(Film* film);

void addSample(Film* film, int pixel, Vector color);

/* How an image differs from a reference. The reference's own variance is taken off the errors. */
typedef struct Difference {
  /* Mean over pixels of sum (x - r)^2 / (sum r^2 + 0.01 of the mean image's), sums over colours. */
  double relMse;
  double relMseTrimmed; /* without the worst 0.1 % of the pixels */
  double relMseMedian;  /* of the pixels' terms, the reference's variance still in it */
  double sigmas;        /* by which the mean colours differ: the largest of the three */
} Difference;

/* 0: out of memory. Both films have at least two samples a pixel. */
int compareFilms(const Film* film, const Film* reference, Difference* difference);

/* A portable pixmap of films of one size side by side, in the curve of sRGB; 0: it can't be
   written. */
int writeFilms(const Film* films, int count, const char* path);

#ifdef __cplusplus
}
#endif

#endif

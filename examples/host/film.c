/* SPDX-License-Identifier: Apache-2.0 */
#include "film.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double kTrimmed = 0.001;

static size_t pixelsOf(const Film* film) { return (size_t)film->size * (size_t)film->size; }

int makeFilm(Film* film, int size) {
  film->size = size;
  film->samples = 0;
  film->sums = calloc(3 * pixelsOf(film), sizeof(double));
  film->squares = calloc(3 * pixelsOf(film), sizeof(double));
  return film->sums && film->squares;
}

void releaseFilm(Film* film) {
  free(film->sums);
  free(film->squares);
}

void addSample(Film* film, int pixel, Vector color) {
  const double colors[3] = {color.x, color.y, color.z};
  int c;
  for (c = 0; c < 3; ++c) {
    film->sums[3 * pixel + c] += colors[c];
    film->squares[3 * pixel + c] += colors[c] * colors[c];
  }
}

static double meanAt(const Film* film, size_t i) { return film->sums[i] / (double)film->samples; }

/* Variance of a pixel's mean. */
static double varianceAt(const Film* film, size_t i) {
  const double mean = meanAt(film, i), n = (double)film->samples;
  return fmax(film->squares[i] / n - mean * mean, 0.0) / (n - 1.0);
}

typedef struct Term {
  double seen, noise; /* noise: what the reference's variance contributes */
} Term;

static int compareTerms(const void* a, const void* b) {
  const double first = ((const Term*)a)->seen, second = ((const Term*)b)->seen;
  return (first > second) - (first < second);
}

static double sigmasBetween(const Film* film, const Film* reference) {
  double most = 0.0;
  size_t i, c;
  for (c = 0; c < 3; ++c) {
    double difference = 0.0, variance = 0.0;
    for (i = c; i < 3 * pixelsOf(film); i += 3) {
      difference += meanAt(film, i) - meanAt(reference, i);
      variance += varianceAt(film, i) + varianceAt(reference, i);
    }
    if (difference != 0.0) most = fmax(most, fabs(difference) / sqrt(variance));
  }
  return most;
}

int compareFilms(const Film* film, const Film* reference, Difference* difference) {
  const size_t pixels = pixelsOf(film);
  const size_t kept = pixels - (size_t)(kTrimmed * (double)pixels);
  Term* terms = malloc(pixels * sizeof *terms);
  double mean = 0.0, floor, sum = 0.0;
  size_t i, c;
  if (!terms) return 0;
  for (i = 0; i < 3 * pixels; ++i) mean += meanAt(reference, i) / (double)(3 * pixels);
  floor = 0.01 * 3.0 * mean * mean;
  for (i = 0; i < pixels; ++i) {
    double error = 0.0, noise = 0.0, power = floor;
    for (c = 3 * i; c < 3 * i + 3; ++c) {
      const double r = meanAt(reference, c), d = meanAt(film, c) - r;
      error += d * d;
      noise += varianceAt(reference, c);
      power += r * r;
    }
    terms[i].seen = error / power;
    terms[i].noise = noise / power;
  }
  qsort(terms, pixels, sizeof *terms, compareTerms);
  for (i = 0; i < pixels; ++i) {
    sum += terms[i].seen - terms[i].noise;
    if (i + 1 == kept) difference->relMseTrimmed = sum / (double)kept;
  }
  difference->relMse = sum / (double)pixels;
  difference->relMseMedian = terms[pixels / 2].seen;
  difference->sigmas = sigmasBetween(film, reference);
  free(terms);
  return 1;
}

static int byteOf(double value) {
  const double v = fmin(value, 1.0);
  return (int)(255.0 * (v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055) + 0.5);
}

int writeFilms(const Film* films, int count, const char* path) {
  const int size = films[0].size;
  FILE* file = fopen(path, "wb");
  int good, x, y, f;
  if (!file) return 0;
  fprintf(file, "P6\n%d %d\n255\n", count * size, size);
  for (y = 0; y < size; ++y) {
    for (f = 0; f < count; ++f) {
      for (x = 0; x < 3 * size; ++x) {
        putc(byteOf(meanAt(&films[f], (size_t)y * 3 * (size_t)size + (size_t)x)), file);
      }
    }
  }
  good = !ferror(file);
  return fclose(file) == 0 && good;
}

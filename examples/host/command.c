/* SPDX-License-Identifier: Apache-2.0 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comparison.h"

static const double kMostSize = 4096.0, kMostSamples = 1e9;

static void printHelp(const char* name, const char* about, const Settings* settings) {
  printf(
      "usage: %s [options]\n%s\n\n"
      "  --size N               pixels along each side; default %d\n"
      "  --samples N            of each pixel, unguided and guided; default %llu\n"
      "  --reference-samples N  of each pixel of the reference; default %llu\n"
      "  --seed S               default %llu\n"
      "  --out FILE.ppm         unguided, guided and reference side by side\n"
      "  --help                 this text\n",
      name, about, settings->size, (unsigned long long)settings->samples,
      (unsigned long long)settings->referenceSamples, (unsigned long long)settings->seed);
}

/* A whole number from `least` to `most`; 0 if it isn't one. */
static int parseWhole(const char* text, double least, double most, double* value) {
  char* end = NULL;
  errno = 0;
  *value = strtod(text, &end);
  return end != text && *end == '\0' && errno == 0 && *value >= least && *value <= most &&
         *value == floor(*value);
}

/* NULL, or what is wrong with the option. */
static const char* parseOption(const char* option, const char* text, Settings* settings) {
  double value;
  if (strcmp(option, "--out") == 0) {
    settings->out = text;
  } else if (strcmp(option, "--size") == 0) {
    if (!parseWhole(text, 1.0, kMostSize, &value)) return "give 1 to 4096 to";
    settings->size = (int)value;
  } else if (strcmp(option, "--samples") == 0) {
    if (!parseWhole(text, 2.0, kMostSamples, &value)) return "give 2 to 1e9 to";
    settings->samples = (uint64_t)value;
  } else if (strcmp(option, "--reference-samples") == 0) {
    if (!parseWhole(text, 2.0, kMostSamples, &value)) return "give 2 to 1e9 to";
    settings->referenceSamples = (uint64_t)value;
  } else if (strcmp(option, "--seed") == 0) {
    if (!parseWhole(text, 0.0, kMostSamples, &value)) return "give 0 to 1e9 to";
    settings->seed = (uint64_t)value;
  } else {
    return "no such option:";
  }
  return NULL;
}

static void printShot(const char* name, const Shot* shot) {
  printf("%-10s %10.5f %15.5f %10.5f %9.2f %13.2f%% %12.2f\n", name, shot->difference.relMse,
         shot->difference.relMseTrimmed, shot->difference.relMseMedian, shot->seconds,
         100.0 * (double)shot->lampHits / (double)(shot->scattered ? shot->scattered : 1),
         shot->difference.sigmas);
}

static void print(const Comparison* comparison) {
  const Shot *unguided = &comparison->unguided, *guided = &comparison->guided;
  const double time = unguided->seconds / guided->seconds;
  const double error = unguided->difference.relMse / guided->difference.relMse;
  const double trimmed = unguided->difference.relMseTrimmed / guided->difference.relMseTrimmed;
  const double median = unguided->difference.relMseMedian / guided->difference.relMseMedian;
  printf("%-10s %10s %15s %10s %9s %14s %12s\n", "", "relMSE", "without 0.1 %", "median", "seconds",
         "rays at lamp", "mean off by");
  printShot("unguided", unguided);
  printShot("guided", guided);
  printf("%-10s %9.2fx %14.2fx %9.2fx %8.2fx\n", "gain", error, trimmed, median, time);
  printf("%-10s %9.2fx %14.2fx %9.2fx\n", "efficiency", error * time, trimmed * time,
         median * time);
}

int runCommand(const char* name, const char* about, int count, char** arguments, const Scene* scene,
               int shadowRays, Settings settings) {
  Comparison comparison;
  const char* error;
  int i;
  for (i = 1; i < count; ++i) {
    if (strcmp(arguments[i], "--help") != 0) continue;
    printHelp(name, about, &settings);
    return 0;
  }
  for (i = 1; i < count; i += 2) {
    error = i + 1 < count ? parseOption(arguments[i], arguments[i + 1], &settings)
                          : "unknown, or without its value:";
    if (!error) continue;
    fprintf(stderr, "%s: %s %s (--help tells more)\n", name, error, arguments[i]);
    return 2;
  }
  error = compareGuiding(scene, shadowRays, &settings, &comparison);
  if (error) {
    fprintf(stderr, "%s: %s\n", name, error);
    return 1;
  }
  print(&comparison);
  if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
  fprintf(stderr, "%s: can't write to standard output\n", name);
  return 1;
}

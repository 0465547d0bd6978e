/* SPDX-License-Identifier: Apache-2.0
 *
 * resume: a render that may end at any time, and goes on from its checkpoint.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "room.h"

typedef struct Options {
  const char* checkpoint;
  const char* image;
  uint32_t size;    /* of the image, pixels a side */
  uint32_t samples; /* per pixel */
  uint32_t passes;  /* that are rendered before the program ends; 0: all */
} Options;

/* One that can't be opened is there as well: it must not be overwritten. */
static int isThere(const char* path) {
  FILE* file = fopen(path, "rb");
  if (file) fclose(file);
  return file != NULL || errno != ENOENT;
}

/* From the checkpoint, or from the beginning. */
static AWDResult begin(const Options* options, AWDScene scene, AWDRender* render) {
  const AWDCamera camera = viewOfRoom(options->size);
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  uint32_t passes;
  AWDResult result;
  desc.camera = &camera;
  if (!isThere(options->checkpoint)) return awdNewRender(scene, NULL, &desc, render);
  /* With desc the library says so if the checkpoint is of other settings than these. */
  result = awdLoadRender(scene, options->checkpoint, NULL, &desc, render);
  if (result == AWD_SUCCESS) result = awdGetPassCount(*render, &passes);
  if (result == AWD_SUCCESS) {
    printf("%s: going on after %u passes\n", options->checkpoint, (unsigned)passes);
  }
  return result;
}

/* A checkpoint after each pass: whatever happens then, no more than one is lost. */
static AWDResult renderPasses(const Options* options, AWDRender render) {
  AWDSchedule next = AWD_SCHEDULE_INIT;
  uint32_t done, before, now = 0;
  AWDResult result = awdGetPassCount(render, &now);
  next.totalSamples = options->samples;
  next.resume = 1;    /* the passes that the render has had are the schedule's first, */
  next.maxPasses = 1; /* and one more is rendered at a time */
  for (done = 0; result == AWD_SUCCESS && (options->passes == 0 || done < options->passes);
       ++done) {
    before = now;
    result = awdRenderPasses(render, &next);
    if (result == AWD_SUCCESS) result = awdGetPassCount(render, &now);
    if (result != AWD_SUCCESS || now == before) break;
    result = awdSaveRender(render, options->checkpoint);
  }
  return result;
}

static AWDResult writeImage(AWDRender render, const char* path) {
  AWDImage image = NULL;
  AWDResult result = awdNewFilmImage(render, &image);
  if (result == AWD_SUCCESS) result = awdWriteImageEXR(image, path);
  awdReleaseImage(image);
  return result;
}

int main(int count, char** arguments) {
  Options options = {NULL, NULL, 128, 64, 0};
  AWDDevice device = NULL;
  AWDScene scene = NULL;
  AWDRender render = NULL;
  AWDResult result;
  if (count < 3) {
    fprintf(stderr, "usage: resume CHECKPOINT OUT.exr [SIZE [SAMPLES [PASSES]]]\n");
    return 2;
  }
  options.checkpoint = arguments[1];
  options.image = arguments[2];
  if (count > 3) options.size = (uint32_t)strtoul(arguments[3], NULL, 10);
  if (count > 4) options.samples = (uint32_t)strtoul(arguments[4], NULL, 10);
  if (count > 5) options.passes = (uint32_t)strtoul(arguments[5], NULL, 10);

  result = awdNewDevice(NULL, &device);
  if (result == AWD_SUCCESS) result = makeRoom(device, &scene);
  if (result == AWD_SUCCESS) result = begin(&options, scene, &render);
  if (result == AWD_SUCCESS) result = renderPasses(&options, render);
  if (result == AWD_SUCCESS) result = writeImage(render, options.image);
  if (result != AWD_SUCCESS) fprintf(stderr, "resume: %s\n", awdGetLastErrorMessage());

  awdReleaseRender(render);
  awdReleaseScene(scene);
  awdReleaseDevice(device);
  return result != AWD_SUCCESS;
}

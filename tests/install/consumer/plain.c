/* SPDX-License-Identifier: Apache-2.0
 *
 * A host in what C99 and C++ have in common, with cubic.c of examples/cubic-bspline linked into it.
 * Prints only what is wrong.
 *   plain shipped|own render|none
 * "own" uses the linked basis where there is no other, "shipped" those that lie beside libawd;
 * "none" wants a libawd without the renderer, which says so.
 */
#include <awd/awd.h>
#include <awd/basis.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                           \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      fprintf(stderr, "%s:%d: %s; last message: %s\n", __FILE__, __LINE__, #condition,             \
              awdGetLastErrorMessage());                                                           \
      ++failures;                                                                                  \
    }                                                                                              \
  } while (0)

static const double points[4] = {0.125, 0.375, 0.625, 0.875};

/* A density of f(x) = x has more of its mass on the right. */
static void learn(AWDDevice device, const char* basis) {
  AWDDensityAxis axis;
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  AWDDensity density = NULL;
  double pdfs[4] = {0, 0, 0, 0};
  int i;
  memset(&axis, 0, sizeof axis);
  axis.basis = basis;
  axis.startLevel = axis.maxLevel = AWD_LEVEL(1);
  desc.dimensions = 1;
  desc.axes = &axis;
  CHECK(awdNewDensity(device, &desc, &density) == AWD_SUCCESS);
  for (i = 0; i < 16; ++i) {
    CHECK(awdRecordDensity(density, 4, points, NULL, NULL, points) == AWD_SUCCESS);
  }
  CHECK(awdAdaptDensity(density, NULL) == AWD_SUCCESS);
  CHECK(awdGetDensityPdf(density, 4, points, pdfs) == AWD_SUCCESS);
  CHECK(pdfs[0] > 0 && pdfs[0] < pdfs[3]);
  awdReleaseDensity(density);
}

/* An image and a scene, or else a refusal that leaves nothing behind. */
static void useRenderer(AWDDevice device, int there) {
  const AWDResult want = there ? AWD_SUCCESS : AWD_ERROR_UNSUPPORTED;
  AWDImage image = (AWDImage)device;
  AWDScene scene = (AWDScene)device;
  CHECK(awdNewImage(device, 2, 2, &image) == want);
  CHECK(awdNewScene(device, &scene) == want);
  CHECK(!image == !there && !scene == !there);
  CHECK(awdCommitScene(scene) == want);
  if (!there) CHECK(strstr(awdGetLastErrorMessage(), "awdCommitScene: ") != NULL);
  if (!there) CHECK(strstr(awdGetLastErrorMessage(), "AWD_RENDER=ON") != NULL);
  awdReleaseScene(scene);
  awdReleaseImage(image);
}

int main(int count, char** arguments) {
  const AWDBasisHost host = {sizeof host, AWD_BASIS_ABI, AWD_VERSION};
  AWDDevice device = NULL;
  size_t families = 99;
  if (count != 3) return 2;
  CHECK(awdGetVersion() == AWD_VERSION);
  CHECK(awdNewDevice(NULL, &device) == AWD_SUCCESS);
  if (strcmp(arguments[1], "own") == 0) {
    CHECK(awdGetBasisCount(device, &families) == AWD_SUCCESS && families == 0);
    CHECK(awdRegisterBasisModule(device, AWD_BASIS_ENTRY(&host)) == AWD_SUCCESS);
    learn(device, "cubic-bspline");
  } else {
    learn(device, "linear-bspline");
    learn(device, NULL);
  }
  useRenderer(device, strcmp(arguments[2], "render") == 0);
  awdReleaseDevice(device);
  return failures ? 1 : 0;
}

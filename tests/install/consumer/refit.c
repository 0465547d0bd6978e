/* SPDX-License-Identifier: Apache-2.0
 *
 * Asks for the estimator refit, in turn with every solver: refit ANSWER, which is "there" if the
 * module has to be found, or else the path that the refusal has to name. All else works as ever.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "awd/awd.h"

static int fail(const char* what) {
  printf("%s: %s\n", what, awdGetLastErrorMessage());
  return 1;
}

static int learn(AWDDevice device, AWDEstimator estimator, const char* solver, const char* answer) {
  const AWDDensityAxis axis = {"quadratic-bspline", AWD_LEVEL(3), AWD_LEVEL(3)};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
  AWDDensity density = NULL;
  AWDResult result;
  double points[64], values[64];
  int i;
  desc.dimensions = 1;
  desc.axes = &axis;
  desc.estimator = estimator;
  desc.refitSolver = solver;
  result = awdNewDensity(device, &desc, &density);
  if (strcmp(answer, "there") != 0) {
    if (result != AWD_ERROR_UNSUPPORTED) return fail("not refused as unsupported");
    return strstr(awdGetLastErrorMessage(), answer) ? 0 : fail("the path tried is not named");
  }
  if (result != AWD_SUCCESS) return fail("awdNewDensity");
  for (i = 0; i < 64; ++i) {
    points[i] = (i + 0.5) / 64.0;
    values[i] = points[i] * points[i];
  }
  if (awdRecordDensity(density, 64, points, NULL, NULL, values) ||
      awdAdaptDensity(density, &report)) {
    return fail("a pass");
  }
  if (estimator == AWD_ESTIMATOR_REFIT && report.refitStatus != AWD_REFIT_CONVERGED) {
    return fail(report.refitMessage);
  }
  if (awdGetDensityPdf(density, 1, &points[63], values) || fabs(values[0] - 2.95) > 0.6) {
    return fail("p near 1");
  }
  awdReleaseDensity(density);
  return 0;
}

int main(int count, char** arguments) {
  AWDDevice device = NULL;
  if (count != 2) return 2;
  if (awdNewDevice(NULL, &device)) return fail("awdNewDevice");
  if (learn(device, AWD_ESTIMATOR_REFIT, NULL, arguments[1]) ||
      learn(device, AWD_ESTIMATOR_REFIT, "ceres", arguments[1]) ||
      learn(device, AWD_ESTIMATOR_REFIT, "descent", arguments[1]) ||
      learn(device, AWD_ESTIMATOR_QUASI, NULL, "there")) {
    return 1;
  }
  awdReleaseDevice(device);
  return 0;
}

/* SPDX-License-Identifier: Apache-2.0
 *
 * A host of the installed library: checks a basis module that was built elsewhere, and makes fields
 * with it. Prints only what is wrong.
 *   host <module.so>, with $AWD_BASIS_PATH the module's folder
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

typedef struct Seen {
  int checks, families;
} Seen;

static void AWD_CALL onCheck(void* user, const AWDBasisCheck* check) {
  Seen* seen = (Seen*)user;
  ++seen->checks;
  seen->families = (int)check->index + 1;
  CHECK(check->status == AWD_SUCCESS);
  CHECK(check->worst <= check->limit);
  CHECK(strncmp(check->family, "cubic-bspline", strlen("cubic-bspline")) == 0);
}

/* A field of that basis gives directions with a density. */
static void useField(AWDDevice device, const char* basis) {
  const float up[3] = {0, 0, 1};
  const double uniforms[3] = {0.3, 0.6, 0.9};
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  AWDDirectionSample sample;
  AWDField field = NULL;
  float pdf = 0;
  desc.basis = basis;
  CHECK(awdNewField(device, &desc, &field) == AWD_SUCCESS);
  if (!field) return;
  CHECK(awdSampleField(field, 0, up, uniforms, &sample) == AWD_SUCCESS);
  CHECK(awdRecordField(field, 0, &sample, 1.0) == AWD_SUCCESS);
  CHECK(awdAdaptField(field, NULL) == AWD_SUCCESS);
  CHECK(awdGetFieldPdf(field, 0, up, sample.direction, &pdf) == AWD_SUCCESS);
  CHECK(pdf > 0);
  awdReleaseField(field);
}

int main(int argumentCount, char** arguments) {
  const char* module = argumentCount > 1 ? arguments[1] : "";
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  AWDDevice device = NULL;
  AWDField field = NULL;
  AWDFieldDesc cubic = AWD_FIELD_DESC_INIT;
  Seen seen = {0, 0};
  cubic.basis = "cubic-bspline";

  CHECK(awdGetVersion() == AWD_VERSION);
  CHECK(awdCheckBasisModule(module, onCheck, &seen) == AWD_SUCCESS);
  CHECK(seen.families == 2 && seen.checks >= 24);

  /* Found by the environment, beside the library's own. */
  CHECK(awdNewDevice(NULL, &device) == AWD_SUCCESS);
  useField(device, "cubic-bspline");
  useField(device, "cubic-bspline-periodic");
  useField(device, "haar");
  awdReleaseDevice(device);

  /* Loaded by path. */
  desc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  CHECK(awdNewDevice(&desc, &device) == AWD_SUCCESS);
  CHECK(awdNewField(device, &cubic, &field) == AWD_ERROR_UNSUPPORTED);
  CHECK(awdLoadBasisModule(device, module) == AWD_SUCCESS);
  useField(device, "cubic-bspline");
  awdReleaseDevice(device);
  return failures ? 1 : 0;
}

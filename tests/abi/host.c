/* SPDX-License-Identifier: Apache-2.0
 *
 * A host in C99 that links libawd alone: devices, struct rules, callbacks and messages. Prints only
 * what is wrong.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "awd/awd.h"
#include "awd/basis.h"

static int failures = 0;

#define CHECK(condition)                                                                           \
  do {                                                                                             \
    if (!(condition)) {                                                                            \
      fprintf(stderr, "%s:%d: %s; last message: %s\n", __FILE__, __LINE__, #condition,             \
              awdGetLastErrorMessage());                                                           \
      ++failures;                                                                                  \
    }                                                                                              \
  } while (0)

static int said(const char* text) { return strstr(awdGetLastErrorMessage(), text) != NULL; }

/* A desc that must be refused with a message that contains `text`. */
static void refused(const AWDDeviceDesc* desc, const char* text) {
  AWDDevice device = (AWDDevice)&failures;
  CHECK(awdNewDevice(desc, &device) == AWD_ERROR_INVALID_ARGUMENT);
  CHECK(device == NULL);
  if (!said(text)) {
    fprintf(stderr, "message lacks \"%s\": %s\n", text, awdGetLastErrorMessage());
    ++failures;
  }
}

static void checkVersionAndNames(void) {
  AWDResult result;
  CHECK(strcmp(awdGetLastErrorMessage(), "") == 0);
  CHECK(awdGetVersion() == AWD_VERSION);
  for (result = AWD_SUCCESS; result >= AWD_ERROR_PLUGIN_SELF_TEST - 1; --result) {
    CHECK(strlen(awdGetResultString(result)) > 0);
  }
  CHECK(strcmp(awdGetResultString(AWD_ERROR_OUT_OF_MEMORY), "out of memory") == 0);
  CHECK(strcmp(awdGetResultString(AWD_SUCCESS), awdGetResultString(1)) != 0);
}

static void checkDevice(void) {
  AWDDevice device = NULL;
  size_t count = 0;
  CHECK(awdNewDevice(NULL, NULL) == AWD_ERROR_INVALID_ARGUMENT);
  CHECK(said("awdNewDevice: device is NULL"));
  CHECK(awdNewDevice(NULL, &device) == AWD_SUCCESS);
  CHECK(device != NULL);
  awdRetainDevice(device);
  awdReleaseDevice(device);
  CHECK(awdGetBasisCount(device, &count) == AWD_SUCCESS);
  CHECK(count >= 1);
  awdReleaseDevice(device);
  awdRetainDevice(NULL);
  awdReleaseDevice(NULL);
}

/* --- structs -----------------------------------------------------------------------------------
 */

typedef struct NewerDesc {
  AWDDeviceDesc desc;
  void* newer;
} NewerDesc;

static void checkStructRules(void) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  NewerDesc newer;
  AWDDevice device = NULL;
  union {
    AWDBasisInfo info;
    unsigned char bytes[sizeof(AWDBasisInfo) + 16];
  } room;
  AWDBasisInfo old;
  size_t i;

  CHECK(desc.structSize == sizeof desc);
  desc.structSize = 0;
  refused(&desc, "desc->structSize is 0: initialise the struct with AWD_DEVICE_DESC_INIT");
  desc.structSize = sizeof(size_t) - 1;
  refused(&desc, "structSize");
  desc.structSize = (size_t)-1;
  refused(&desc, "structSize");

  /* A newer host: fine until it uses what this library does not know. */
  memset(&newer, 0, sizeof newer);
  newer.desc.structSize = sizeof newer;
  CHECK(awdNewDevice(&newer.desc, &device) == AWD_SUCCESS);
  awdReleaseDevice(device);
  newer.newer = &newer;
  refused(&newer.desc, "that this version of the library does not know");

  /* An older host: what lies behind its struct is not read. */
  memset(&desc, 0xff, sizeof desc);
  desc.structSize = offsetof(AWDDeviceDesc, log);
  desc.threads = 1;
  desc.flags = 0;
  CHECK(awdNewDevice(&desc, &device) == AWD_SUCCESS);
  desc.structSize = sizeof desc;
  refused(&desc, "desc->");

  /* Outputs: no byte behind the host's struct is written, and its structSize stays. */
  memset(&old, 0xff, sizeof old);
  old.structSize = offsetof(AWDBasisInfo, file);
  CHECK(awdGetBasisInfo(device, 0, &old) == AWD_SUCCESS);
  CHECK(old.structSize == offsetof(AWDBasisInfo, file));
  CHECK(old.name[0] != '\0');
  for (i = offsetof(AWDBasisInfo, file); i < sizeof old; ++i) {
    CHECK(((unsigned char*)&old)[i] == 0xff);
  }
  memset(&room, 0xff, sizeof room);
  room.info.structSize = sizeof room;
  CHECK(awdGetBasisInfo(device, 0, &room.info) == AWD_SUCCESS);
  CHECK(room.info.structSize == sizeof room);
  CHECK(room.info.order == 1);
  for (i = sizeof(AWDBasisInfo); i < sizeof room; ++i) CHECK(room.bytes[i] == 0);
  awdReleaseDevice(device);
}

/* --- arguments ---------------------------------------------------------------------------------
 */

static void* AWD_CALL noMemory(void* user, size_t size, size_t alignment) {
  (void)user;
  (void)size;
  (void)alignment;
  return NULL;
}

static void AWD_CALL noFree(void* user, void* ptr, size_t size, size_t alignment) {
  (void)user;
  (void)ptr;
  (void)size;
  (void)alignment;
}

static void checkArguments(void) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  const char* path = "relative/folder";
  AWDDevice device = NULL;

  desc.threads = 1025;
  refused(&desc, "awdNewDevice: desc->threads is 1025: at most 1024, 0 for all there are");
  desc.threads = 0;
  desc.flags = 2;
  refused(&desc, "desc->flags is 0x2");
  desc.flags = 0;
  desc.alloc = noMemory;
  refused(&desc, "desc->alloc is set without desc->free");
  desc.alloc = NULL;
  desc.free = noFree;
  refused(&desc, "desc->free is set without desc->alloc");
  desc.free = NULL;
  desc.basisPathCount = 1;
  refused(&desc, "desc->basisPaths is NULL, but basisPathCount is 1");
  desc.basisPaths = &path;
  refused(&desc, "desc->basisPaths[0] \"relative/folder\" is not absolute");
  path = NULL;
  refused(&desc, "desc->basisPaths[0] is NULL");
  path = "/no/such/folder";
  CHECK(awdNewDevice(&desc, &device) == AWD_SUCCESS);
  awdReleaseDevice(device);
}

/* --- the host's memory --------------------------------------------------------------------------
 */

typedef struct Heap {
  size_t blocks, bytes, calls, failAt;
} Heap;

static void* AWD_CALL heapAlloc(void* user, size_t size, size_t alignment) {
  Heap* heap = (Heap*)user;
  void* ptr = NULL;
  if (++heap->calls == heap->failAt) return NULL;
  CHECK(alignment <= 2 * sizeof(void*)); /* as malloc gives */
  ptr = malloc(size);
  if (ptr) {
    ++heap->blocks;
    heap->bytes += size;
  }
  return ptr;
}

static void AWD_CALL heapFree(void* user, void* ptr, size_t size, size_t alignment) {
  Heap* heap = (Heap*)user;
  (void)alignment;
  --heap->blocks;
  heap->bytes -= size;
  free(ptr);
}

static void checkMemory(void) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  AWDDevice device = NULL;
  Heap heap = {0, 0, 0, 0};
  size_t n;
  desc.alloc = noMemory;
  desc.free = noFree;
  CHECK(awdNewDevice(&desc, &device) == AWD_ERROR_OUT_OF_MEMORY);
  CHECK(device == NULL);

  desc.alloc = heapAlloc;
  desc.free = heapFree;
  desc.allocUser = &heap;
  for (n = 1;; ++n) {
    heap.calls = 0;
    heap.failAt = n;
    if (awdNewDevice(&desc, &device) == AWD_SUCCESS) break;
    CHECK(device == NULL);
    CHECK(heap.blocks == 0);
    CHECK(n < 100);
    if (n >= 100) return;
  }
  CHECK(n > 1);
  CHECK(heap.blocks > 0);
  awdReleaseDevice(device);
  CHECK(heap.blocks == 0);
  CHECK(heap.bytes == 0);
}

/* --- the field, as far as struct rules go
 * --------------------------------------------------------- */

/* A path of one vertex through a field and its bytes. */
static void checkPath(AWDField field) {
  const float up[3] = {0.0f, 0.0f, 1.0f}, white[3] = {1.0f, 1.0f, 1.0f};
  const double uniforms[3] = {0.5, 0.25, 0.75};
  const uint32_t patch = 3;
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  AWDPathVertex vertex;
  float radiance[3] = {0.0f, 0.0f, 0.0f};
  size_t size = 0;
  memset(&vertex, 0, sizeof vertex);
  CHECK(awdSampleFieldBatch(field, 1, &patch, up, uniforms, &vertex.sample) == AWD_SUCCESS);
  vertex.patch = patch;
  vertex.continuation = 0.5f;
  vertex.emitted[0] = 1.0f;
  vertex.scattering[0] = vertex.sample.pdf;
  CHECK(awdRecordFieldPath(field, 1, &vertex, white, radiance) == AWD_SUCCESS);
  CHECK(radiance[0] > 2.999f && radiance[0] < 3.001f && radiance[1] == 0.0f);
  CHECK(awdAdaptField(field, &figures) == AWD_SUCCESS);
  CHECK(figures.samples == 1 && figures.rejected == 0);
  CHECK(awdSaveField(field, NULL, 0, &size) == AWD_SUCCESS);
  CHECK(size > 100);
}

static void checkField(void) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  AWDDevice device = NULL;
  AWDField field = (AWDField)&failures;
  CHECK(awdNewDevice(NULL, &device) == AWD_SUCCESS);
  CHECK(awdNewField(NULL, NULL, &field) == AWD_ERROR_INVALID_ARGUMENT);
  CHECK(field == NULL);
  CHECK(awdNewField(device, NULL, NULL) == AWD_ERROR_INVALID_ARGUMENT);
  desc.structSize = 0;
  field = (AWDField)&failures;
  CHECK(awdNewField(device, &desc, &field) == AWD_ERROR_INVALID_ARGUMENT);
  CHECK(said("AWD_FIELD_DESC_INIT"));
  CHECK(field == NULL);
  desc.structSize = sizeof desc;
  desc.basis = "no-such-basis";
  CHECK(awdNewField(device, &desc, &field) == AWD_ERROR_UNSUPPORTED);
  CHECK(said("no-such-basis") && said("/awd/bases-1"));
  CHECK(field == NULL);
  desc.basis = NULL;
  CHECK(awdNewField(device, &desc, &field) == AWD_SUCCESS);
  checkPath(field);
  awdReleaseDevice(device); /* the child keeps its parent alive */
  awdRetainField(field);
  awdReleaseField(field);
  awdReleaseField(field);
  awdRetainField(NULL);
  awdReleaseField(NULL);
}

int main(void) {
  checkVersionAndNames();
  checkDevice();
  checkStructRules();
  checkArguments();
  checkMemory();
  checkField();
  return failures ? 1 : 0;
}

/* SPDX-License-Identifier: Apache-2.0
 *
 * Opens several libawd in one process: sides FOLDER..., each of which must find the bases beside
 * itself, and no others. Prints only what is wrong.
 */
#include <awd/awd.h>
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

/* ISO C has no conversion from void* to a function. */
#define FIND(function)                                                                             \
  do {                                                                                             \
    void* found = dlsym(library, #function);                                                       \
    memcpy(&function##_, &found, sizeof found);                                                    \
  } while (0)

static int look(const char* folder) {
  AWDResult(AWD_CALL * awdNewDevice_)(const AWDDeviceDesc*, AWDDevice*) = NULL;
  AWDResult(AWD_CALL * awdGetBasisCount_)(AWDDevice, size_t*) = NULL;
  AWDResult(AWD_CALL * awdGetBasisInfo_)(AWDDevice, size_t, AWDBasisInfo*) = NULL;
  void(AWD_CALL * awdReleaseDevice_)(AWDDevice) = NULL;
  AWDDevice device = NULL;
  size_t count = 0, i;
  char file[4096], bases[4096];
  void* library;
  snprintf(file, sizeof file, "%s/libawd.so.1", folder);
  snprintf(bases, sizeof bases, "%s/awd/bases-1/", folder);
  library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!library) return printf("%s\n", dlerror());
  FIND(awdNewDevice);
  FIND(awdGetBasisCount);
  FIND(awdGetBasisInfo);
  FIND(awdReleaseDevice);
  if (awdNewDevice_(NULL, &device) || awdGetBasisCount_(device, &count) || count == 0) {
    return printf("%s: no bases\n", file);
  }
  for (i = 0; i < count; ++i) {
    AWDBasisInfo info = AWD_BASIS_INFO_INIT;
    if (awdGetBasisInfo_(device, i, &info) || info.status != AWD_SUCCESS ||
        strncmp(info.file, bases, strlen(bases)) != 0) {
      return printf("%s: found \"%s\" %s\n", file, info.file ? info.file : "", info.message);
    }
  }
  awdReleaseDevice_(device);
  return 0;
}

int main(int count, char** arguments) {
  int i;
  if (count < 2) return 2;
  for (i = 1; i < count; ++i) {
    if (look(arguments[i])) return 1;
  }
  return 0;
}

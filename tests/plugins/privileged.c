/* SPDX-License-Identifier: Apache-2.0
 * Whether the loader takes this process for privileged, and what basis families it then finds, in
 * one line. */
#include <stdio.h>
#include <sys/auxv.h>

#include "awd/awd.h"

int main(void) {
  AWDDevice device = NULL;
  size_t count = 0;
  if (awdNewDevice(NULL, &device) != AWD_SUCCESS || awdGetBasisCount(device, &count)) {
    fprintf(stderr, "%s\n", awdGetLastErrorMessage());
    return 1;
  }
  printf("secure %lu", getauxval(AT_SECURE));
  for (size_t i = 0; i < count; ++i) {
    AWDBasisInfo info = AWD_BASIS_INFO_INIT;
    if (awdGetBasisInfo(device, i, &info) == AWD_SUCCESS) printf(" %s", info.name);
  }
  printf("\n");
  awdReleaseDevice(device);
  return 0;
}

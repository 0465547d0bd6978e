/* SPDX-License-Identifier: Apache-2.0
 *
 * The device: threads, callbacks, memory, and the registry of basis families. Two devices share
 * nothing, and may be at work at once.
 *
 * A process may fork, and goes on as if it hadn't. Its child may use what the parent made, unless a
 * call was at work on it or on its device, and release it; with the same bits, though in one thread
 * if those of a device had been started before. Then the child can't commit scenes
 * (AWD_ERROR_INVALID_OPERATION). In a callback a child may but call _exit or exec.
 */
#ifndef AWD_DEVICE_H
#define AWD_DEVICE_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

struct AWDBasisModule; /* awd/basis.h */

/* Flags of a device. */
enum {
  AWD_DEVICE_IGNORE_ENVIRONMENT = 1u /* don't read $AWD_BASIS_PATH */
};

/* What a device is to be. Callbacks are given the pointer that stands after them. */
typedef struct AWDDeviceDesc {
  size_t structSize;
  uint32_t threads; /* 0: all this process may use; 1: everything runs in the calling thread */
  uint32_t flags;   /* AWD_DEVICE_... */
  AWDLogFn log;     /* NULL: silent. The library itself never prints. */
  void* logUser;    /* of log */
  AWDProgressFn progress;        /* NULL: nothing is reported, nothing can be cancelled */
  void* progressUser;            /* of progress */
  AWDAllocFn alloc;              /* with `free`, or both NULL for the C++ runtime's */
  AWDFreeFn free;                /* with `alloc` */
  void* allocUser;               /* of both */
  AWDParallelForFn parallelFor;  /* the host's scheduler; NULL: the library's own */
  void* parallelForUser;         /* of parallelFor */
  const char* const* basisPaths; /* absolute folders, searched before all others; copied */
  size_t basisPathCount;         /* of basisPaths */
} AWDDeviceDesc;

#ifdef __cplusplus
#define AWD_DEVICE_DESC_INIT                                                                       \
  AWDDeviceDesc {                                                                                  \
    sizeof(AWDDeviceDesc), 0u, 0u, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,  \
        nullptr, nullptr, nullptr, 0u                                                              \
  }
#else
#define AWD_DEVICE_DESC_INIT                                                                       \
  { sizeof(AWDDeviceDesc), 0u, 0u, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 0u }
#endif

/* AWD_VERSION of the loaded library. Free. */
AWD_EXPORT uint32_t AWD_CALL awdGetVersion(void) AWD_NOEXCEPT;

/* A short name of a result code, such as "out of memory"; never NULL. Free. */
AWD_EXPORT const char* AWD_CALL awdGetResultString(AWDResult result) AWD_NOEXCEPT;

/* Why this thread's last failed call failed: argument, value and remedy. "" before any failure;
   never NULL; valid until this thread's next call. Free. */
AWD_EXPORT const char* AWD_CALL awdGetLastErrorMessage(void) AWD_NOEXCEPT;

/* Makes a device; desc NULL: all defaults. Loads nothing yet: basis modules are looked for when
   the first one is asked for. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewDevice(const AWDDeviceDesc* desc,
                                           AWDDevice* device) AWD_NOEXCEPT;
/* One reference more, or less; NULL is allowed. Free. */
AWD_EXPORT void AWD_CALL awdRetainDevice(AWDDevice device) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseDevice(AWDDevice device) AWD_NOEXCEPT;

/* --- basis families -------------------------------------------------------------------------
   A family becomes visible under its name once its self-test has passed. Modules are looked for
   in the device's basisPaths, in the folders of $AWD_BASIS_PATH (separated by ':'; not when the
   process is privileged), and in <folder of libawd>/awd/bases-1; never in the current folder.
   The first family of a name wins; the others are listed as rejected. */

/* Loads one module by absolute path. AWD_ERROR_PLUGIN_... tells why not. Free. */
AWD_EXPORT AWDResult AWD_CALL awdLoadBasisModule(AWDDevice device,
                                                 const char* absolutePath) AWD_NOEXCEPT;

/* Registers a module that is linked into the host; its table must outlive the device. A table, like
   a file, that is registered already is no error. AWD_ERROR_PLUGIN_... tells why not. Free. */
AWD_EXPORT AWDResult AWD_CALL
awdRegisterBasisModule(AWDDevice device, const struct AWDBasisModule* module) AWD_NOEXCEPT;

/* One check of a family's self-test. Made by the library; the texts die with the call. */
typedef struct AWDBasisCheck {
  size_t structSize;
  const char* family;  /* name of the family; "" when it could not say */
  const char* name;    /* of the check, such as "partition of unity" */
  const char* message; /* what is wrong and where; "" when all is well */
  double worst;        /* largest figure met; infinite when there is none to tell */
  double limit;        /* that no figure may exceed */
  AWDResult status;    /* AWD_SUCCESS or AWD_ERROR_PLUGIN_... */
  uint32_t index;      /* of the family in its module */
} AWDBasisCheck;

/* Called from the thread that asked; the library holds no lock meanwhile. */
typedef void(AWD_CALL* AWDBasisCheckFn)(void* user, const AWDBasisCheck* check);

/* Tests a module as loading does, names that are taken elsewhere apart, and registers nothing:
   report, which may be NULL, is called with every check of every family in turn. Succeeds if the
   module can be loaded; otherwise the result is that of its first failure, and
   AWD_ERROR_PLUGIN_LOAD or AWD_ERROR_PLUGIN_ABI means that no check could be made. Free. */
AWD_EXPORT AWDResult AWD_CALL awdCheckBasisModule(const char* absolutePath, AWDBasisCheckFn report,
                                                  void* user) AWD_NOEXCEPT;

/* One line of the registry: a family that can be used, or a candidate that can't. The texts live
   as long as the device. */
typedef struct AWDBasisInfo {
  size_t structSize;
  const char* name;    /* "" when a module could not say */
  const char* summary; /* "" when a module could not say */
  const char* file;    /* absolute path; "" when registered from memory */
  AWDResult status;    /* AWD_SUCCESS: can be used */
  uint32_t flags;      /* AWD_BASIS_ORTHOGONAL and so on */
  const char* message; /* why not; "" when it can be used */
  uint32_t order;      /* polynomial degree + 1 */
  uint32_t minLevel;   /* coarsest level */
  uint32_t maxLevel;   /* finest level */
  uint32_t reserved;   /* 0 */
} AWDBasisInfo;

#ifdef __cplusplus
#define AWD_BASIS_INFO_INIT                                                                        \
  AWDBasisInfo { sizeof(AWDBasisInfo), nullptr, nullptr, nullptr, 0, 0u, nullptr, 0u, 0u, 0u, 0u }
#else
#define AWD_BASIS_INFO_INIT                                                                        \
  { sizeof(AWDBasisInfo), NULL, NULL, NULL, 0, 0u, NULL, 0u, 0u, 0u, 0u }
#endif

/* Looks for modules if that has not been done, and counts families and rejected candidates.
   Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetBasisCount(AWDDevice device, size_t* count) AWD_NOEXCEPT;
/* index < awdGetBasisCount(). Sorted: families by name, then rejected ones by file. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetBasisInfo(AWDDevice device, size_t index,
                                              AWDBasisInfo* info) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif

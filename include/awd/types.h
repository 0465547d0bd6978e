/* SPDX-License-Identifier: Apache-2.0
 *
 * What every other header of libawd stands on: calling convention, result codes, handles, buffers
 * and callbacks.
 *
 * Conventions of the whole interface
 *  - Every call that can fail returns AWDResult. Outputs go through pointers; a handle output is
 *    NULL after a failure. The reason is in awdGetLastErrorMessage().
 *  - Any call may return AWD_ERROR_INVALID_ARGUMENT (NULL where that is not allowed, a number out
 *    of its range), AWD_ERROR_OUT_OF_MEMORY, and AWD_ERROR_UNKNOWN, which should not happen; what
 *    works in parallel also AWD_ERROR_INVALID_OPERATION, when the host's parallelFor has not run
 *    every task once. All others are named at the function.
 *  - New gives the caller one reference; Retain adds one, Release drops one; both accept NULL.
 *    A child (a scene of a device, a render of a scene) keeps its parents alive.
 *  - Descriptions start with structSize, which their ..._INIT macro sets. They only ever grow at
 *    the end. Zero means "the default" in every field. A caller newer than the library gets an
 *    error if it uses a field that the library does not know.
 *  - Every libawd of one soname has every function. One that was built without the renderer
 *    (AWD_RENDER=OFF) fails those of scene.h, render.h and image.h with AWD_ERROR_UNSUPPORTED.
 *  - Threading: *free* functions may be called at any time from any thread. *Exclusive* ones want
 *    that no other call uses the same object meanwhile. Retain and Release are always free.
 *  - Callbacks may call the library. While a call that calls back is at work (a commit, a pass, an
 *    adapt) its objects, and the field of a render, are not changed: exclusive functions of them
 *    fail with AWD_ERROR_INVALID_OPERATION, as does recording in them. Those that read a film or
 *    the figures of passes tell of the passes before; all others work. The last reference may be
 *    released: the object lives until the call returns. `alloc` and `free` may use other devices,
 *    not their own. Functions of a basis module must not call the library: for the device that
 *    looks at the module it is AWD_ERROR_INVALID_OPERATION.
 *  - A callback must return. One that ends its thread (pthread_exit), throws or jumps ends the
 *    process: there is no way back through what other threads have begun. A thread that is
 *    cancelled from outside (pthread_cancel, not at once but where it may be, as is the default)
 *    ends after the call that it is in.
 *  - Lengths are in the host's scene units, angles in radians, radiance in linear RGB.
 */
#ifndef AWD_TYPES_H
#define AWD_TYPES_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define AWD_CALL __cdecl
#if defined(AWD_STATIC_DEFINE)
#define AWD_EXPORT
#elif defined(awd_EXPORTS)
#define AWD_EXPORT __declspec(dllexport)
#else
#define AWD_EXPORT __declspec(dllimport)
#endif
#else
/* Calling convention of the interface. */
#define AWD_CALL
/* Of what the library or a plugin exports. */
#define AWD_EXPORT __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
#define AWD_NOEXCEPT noexcept
extern "C" {
#else
/* noexcept, to C++. */
#define AWD_NOEXCEPT
#endif

/* Version of these headers; awdGetVersion() tells that of the loaded library. */
#define AWD_VERSION_MAJOR 0
#define AWD_VERSION_MINOR 1
#define AWD_VERSION_PATCH 0
#define AWD_VERSION (AWD_VERSION_MAJOR * 10000 + AWD_VERSION_MINOR * 100 + AWD_VERSION_PATCH)

/* The result of a call: AWD_SUCCESS or one of the negative AWD_ERROR_... values. */
typedef int32_t AWDResult;
enum {
  AWD_SUCCESS = 0,                   /* all was done */
  AWD_ERROR_UNKNOWN = -1,            /* what should not happen: a bug, or Embree's */
  AWD_ERROR_INVALID_ARGUMENT = -2,   /* a value that the call can't take */
  AWD_ERROR_INVALID_OPERATION = -3,  /* a call at the wrong time, such as before commit */
  AWD_ERROR_OUT_OF_MEMORY = -4,      /* by the machine, the host's alloc, or a limit that was set */
  AWD_ERROR_UNSUPPORTED = -5,        /* not in this build, or a module is not there */
  AWD_ERROR_CANCELLED = -6,          /* the progress callback said stop; nothing was changed */
  AWD_ERROR_IO = -7,                 /* a file can't be read or written */
  AWD_ERROR_PLUGIN_LOAD = -8,        /* a module can't be opened or has no entry point */
  AWD_ERROR_PLUGIN_ABI = -9,         /* a module was compiled for another interface */
  AWD_ERROR_PLUGIN_NAME_TAKEN = -10, /* a family of this name is there already */
  AWD_ERROR_PLUGIN_SELF_TEST = -11   /* a module's mathematics is wrong; the message says where */
};

/* Handles. All objects of a device share its threads, callbacks and basis registry. */
typedef struct AWDDeviceImpl* AWDDevice;   /* threads, registry, callbacks */
typedef struct AWDSceneImpl* AWDScene;     /* triangles, materials, lights */
typedef struct AWDFieldImpl* AWDField;     /* one adaptive density per patch */
typedef struct AWDDensityImpl* AWDDensity; /* one adaptive density on the unit cube */
typedef struct AWDRenderImpl* AWDRender;   /* a path tracer with its film */
typedef struct AWDImageImpl* AWDImage;     /* named float channels and metadata */

/* A level as a setting, so that 0 can mean "the default". */
#define AWD_LEVEL(level) ((uint32_t)(level) + 1u)

/* No mesh, triangle, material, patch or component. */
#define AWD_INVALID_ID 0xFFFFFFFFu

/* A patch is known by a number of the host's below 2^31 - 1. Its back side, which is seen from
   against the geometric normal, is a patch of its own. */
#define AWD_PATCH_BACK 0x80000000u

/* How the items of a buffer are laid out; all in the byte order of the machine. */
typedef int32_t AWDFormat;
enum {
  AWD_FORMAT_UNDEFINED = 0,  /* of a buffer that is none */
  AWD_FORMAT_UINT = 0x5001,  /* one uint32_t */
  AWD_FORMAT_UINT3 = 0x5003, /* three uint32_t */
  AWD_FORMAT_FLOAT3 = 0x9003 /* three float */
};

/* `count` items; item i starts byteOffset + i * byteStride bytes after `data`, and nothing after
   the last item is read. byteStride 0: packed. data NULL with count 0: no buffer. This struct is
   part of others and never grows. */
typedef struct AWDBuffer {
  const void* data;  /* NULL: no buffer */
  size_t byteOffset; /* of item 0 */
  size_t byteStride; /* from item to item; 0: packed */
  size_t count;      /* items */
  AWDFormat format;  /* of an item */
  uint32_t reserved; /* 0 */
} AWDBuffer;

/* A group of settings. The paper's: Pietrek and Peter 1999 to the letter. */
typedef int32_t AWDPreset;
enum {
  AWD_PRESET_DEFAULT = 0, /* what we found best */
  AWD_PRESET_PAPER = 1    /* the paper */
};

/* What a density becomes proportional to: the local mean of |f| (default), or the local
   sqrt(E[f^2]), which is the better one where f is noisy at each point, and learned more slowly. Of
   fields f is what is recorded: random, since it is what one path brought. */
typedef int32_t AWDTarget;
enum {
  AWD_TARGET_DEFAULT = 0, /* mean */
  AWD_TARGET_MEAN = 1,    /* |f| */
  AWD_TARGET_RMS = 2      /* sqrt(E[f^2]) */
};

/* How coefficients come from the m samples x_i ~ p of values f_i. With S1_j = sum f N_j / p and
   S0_j = sum N_j / p over all samples, weights w_j = int N_j and Gram matrix G:
     paper    b_j = w_j times the mean of f over the samples drawn from component j; G c = b
     mixture  b_j = S1_j / m; G c = b
     ratio    b_j = w_j S1_j / S0_j; G c = b
     lumped   c_j = S1_j / (m w_j), G replaced by its row sums: never negative, and the least sums
     quasi    c_j = S1_j / S0_j, shrunk towards the coarser levels: never negative
     refit    the c >= floor that minimises
              sum_i (f_i - sum_j c_j N_j(x_i))^2 / p_i + lambda S0 sum_j w_j (c_j - q_j)^2,
              q_j those of quasi, S0 = sum_i 1 / p_i, lambda = shrinkage n / m, or by the noise
              if shrinkage is 0 (lib/refit/README.md tells how); wants the refit
              module that libawd looks for at <its folder>/awd/refit-1.so and in the folders of
              $AWD_REFIT_PATH (separated by ':'; not when the process is privileged)
   Default, of a density: quasi; ratio where the level can't grow any more and m >= 16 n on a grid.
   Of a field: lumped, pooled over all passes; paper in the preset of that name. */
typedef int32_t AWDEstimator;
enum {
  AWD_ESTIMATOR_DEFAULT = 0, /* as said above */
  AWD_ESTIMATOR_PAPER = 1,   /* wants AWD_SAMPLER_COMPONENT */
  AWD_ESTIMATOR_MIXTURE = 2, /* from all samples */
  AWD_ESTIMATOR_RATIO = 3,   /* weights by their own sum */
  AWD_ESTIMATOR_QUASI = 4,   /* quasi-interpolation */
  AWD_ESTIMATOR_REFIT = 5,   /* least squares under bounds, by the refit module */
  AWD_ESTIMATOR_LUMPED = 6   /* of fields alone */
};

/* How passes make one result. */
typedef int32_t AWDCombination;
enum {
  AWD_COMBINE_DEFAULT = 0, /* count; of an adaptive render, but for the preset paper, experience */
  AWD_COMBINE_COUNT = 1,   /* every sample counts the same, as in the paper: unbiased */
  /* Of a density's estimates of int f: by m_k / V_k, V_k the variance of pass k as the last pass's
     samples see it (consistent, smaller error, a slight bias): V_k = mean of f^2 / (p_k p_last) -
     mean^2, at least 1e-3 mean^2. Keeps the densities of the last 16 passes. */
  AWD_COMBINE_CROSS_VARIANCE = 2,
  /* Of a render: a sample counts for (s + 2) / (s + 8), s the samples per pixel before its pass:
     less while little has been learned. The same for all if the field had learned before. Known in
     advance, and so unbiased, which weights by the passes' own variance are not; those also
     count a pass for more the rarer it has met the light. */
  AWD_COMBINE_EXPERIENCE = 3
};

/* How a refit ended. */
typedef int32_t AWDRefitStatus;
enum {
  AWD_REFIT_NONE = 0,      /* there was none */
  AWD_REFIT_CONVERGED = 1, /* at the optimum */
  AWD_REFIT_LIMIT = 2,     /* at the solver's limit of iterations: good, not quite the optimum */
  AWD_REFIT_FAILED = 3     /* the quasi coefficients were taken instead */
};

/* Severity of a log message. */
enum {
  AWD_LOG_INFO = 0,    /* what was done */
  AWD_LOG_WARNING = 1, /* what may not be meant, such as a scene without light */
  AWD_LOG_ERROR = 2    /* what went wrong, such as a basis that was refused */
};

/* Takes a message of one line without its line end. May be called from any thread, also from
   several at once; the library holds no lock meanwhile. The text dies with the call. */
typedef void(AWD_CALL* AWDLogFn)(void* user, int32_t severity, const char* message);

/* What a long operation has done so far. */
typedef struct AWDProgress {
  size_t structSize;
  const char* operation; /* "commit", "pass" or "adapt" */
  const void* object;    /* the AWDScene, AWDRender, AWDField or AWDDensity at work */
  double fraction;       /* 0 to 1, never falling within one operation */
} AWDProgress;

/* Returns nonzero to go on and 0 to cancel: the operation then ends within one tile of work (of a
   pass 16 x 16 pixels, and 4,096 paths at most) with AWD_ERROR_CANCELLED and leaves its objects as
   they were. Called from whichever thread is at work, never from two at once for one operation; the
   library holds no lock meanwhile. */
typedef int32_t(AWD_CALL* AWDProgressFn)(void* user, const AWDProgress* progress);

/* The host's memory. `alignment` is a power of two. Return NULL when there is none: the call at
   work fails with AWD_ERROR_OUT_OF_MEMORY. Must be callable from any thread. */
typedef void*(AWD_CALL* AWDAllocFn)(void* user, size_t size, size_t alignment);
typedef void(AWD_CALL* AWDFreeFn)(void* user, void* ptr, size_t size, size_t alignment);

/* One unit of parallel work, and the host's way to run `count` of them: call task(taskData, i)
   once for each i in [0, count), on any threads in any order, and return when all have. */
typedef void(AWD_CALL* AWDTaskFn)(void* taskData, size_t index);
typedef void(AWD_CALL* AWDParallelForFn)(void* user, size_t count, AWDTaskFn task, void* taskData);

#ifdef __cplusplus
}
#endif
#endif

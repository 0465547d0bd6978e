/* SPDX-License-Identifier: Apache-2.0
 *
 * The renderer: the multi-pass algorithm of Pietrek and Peter 1999. Backward path tracing; direct
 * light by jittered shadow rays to each light; indirect light by one ray a vertex, drawn uniformly,
 * by the cosine, or from the field's density; Russian roulette; densities frozen during a pass and
 * adapted between passes; the film is the sample-weighted sum of all passes.
 *
 * The same seed gives the same bits for any number of threads.
 */
#ifndef AWD_RENDER_H
#define AWD_RENDER_H

#include "awd/field.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A pinhole camera. Pixel (i, j), row 0 on top, with (u, v) in [0,1)^2 looks along
     lookDir + tanHalfFovX ((2 (i+u)/w - 1) right + (1 - 2 (j+v)/h) (h/w) up),
   right = lookDir x up; lookDir is normalised and up made orthogonal to it. */
typedef struct AWDCamera {
  size_t structSize;
  float eye[3];      /* where it stands, not beyond 1e18 times the size of the scene */
  float lookDir[3];  /* not 0; need not be a unit vector */
  float up[3];       /* not along lookDir */
  float tanHalfFovX; /* > 0 */
  uint32_t width;    /* 1 to 65536 */
  uint32_t height;   /* 1 to 65536 */
} AWDCamera;

#ifdef __cplusplus
#define AWD_CAMERA_INIT                                                                            \
  AWDCamera {                                                                                      \
    sizeof(AWDCamera), {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f}, 0.5f, 512u,    \
        512u                                                                                       \
  }
#else
#define AWD_CAMERA_INIT                                                                            \
  {                                                                                                \
    sizeof(AWDCamera), {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, {0.0f, 1.0f, 0.0f}, 0.5f, 512u,    \
        512u                                                                                       \
  }
#endif

/* Where indirect rays go. */
typedef int32_t AWDGuide;
enum {
  AWD_GUIDE_ADAPTIVE = 0, /* by the field's density */
  AWD_GUIDE_COSINE = 1,   /* pdf = cos(theta) / pi */
  AWD_GUIDE_UNIFORM = 2   /* pdf = 1 / (2 pi) */
};

/* How light is found. */
typedef int32_t AWDDirectLight;
enum {
  AWD_DIRECT_DEFAULT = 0, /* weighted; area in the preset paper */
  /* Shadow rays alone, over the light's area: infinite variance where a light touches a surface. */
  AWD_DIRECT_AREA = 1,
  /* Shadow rays and indirect rays that meet a light, by balance weights from area and cosine. */
  AWD_DIRECT_WEIGHTED = 2,
  /* By indirect rays that meet a light, alone: a field then learns direct light too, as in the
     paper's figure 4. */
  AWD_DIRECT_NONE = 3
};

/* How long paths live. q is the chance to go on, before the indirect ray is drawn; the survivor is
   divided by it. After 64 vertices q <= 0.95. */
typedef int32_t AWDRoulette;
enum {
  /* Adjoint if adaptive; by throughput with AWD_GUIDE_UNIFORM, whose weights would else grow
     without end; else, and in the preset paper, by albedo. */
  AWD_ROULETTE_DEFAULT = 0,
  AWD_ROULETTE_ALBEDO = 1,     /* q = largest component of the albedo */
  AWD_ROULETTE_THROUGHPUT = 2, /* q = largest component of throughput times albedo, at most 1 */
  /* By the radiance still to come: q = clamp(3 r, 0.1, 1) with r = T L / I, and where r > 1 the
     path is split into r rays, at most maxSplit. T is the luminance of the throughput before the
     vertex, L that of the indirect light which the vertex's patch reflects by the field, I that of
     the pixel in earlier passes, blurred over 5 x 5 pixels and not below a fifth of the image's
     mean; by albedo where nothing is known. Needs AWD_GUIDE_ADAPTIVE. */
  AWD_ROULETTE_ADJOINT = 3
};

/* What paths are drawn from. */
typedef int32_t AWDPoints;
enum {
  AWD_POINTS_DEFAULT = 0, /* sobol; random in the preset paper */
  AWD_POINTS_RANDOM = 1,  /* independent numbers */
  /* Sobol's sequence with Owen's scrambling, over all samples of a pixel: its point, and at the
     first two vertices light, point on the light, and direction through the density's inverse CDF,
     which is monotone and so keeps strata. Every sample by itself is uniform; the film's variance,
     that of independent samples, is then larger than the truth. */
  AWD_POINTS_SOBOL = 2
};

/* Which light a shadow ray goes to, where lights share them. */
typedef int32_t AWDLightChoice;
enum {
  AWD_LIGHTS_DEFAULT = 0, /* learned if adaptive and the field chooses lights; else by power */
  AWD_LIGHTS_POWER = 1,   /* in proportion to its power */
  /* As the field has learned (awd/light.h), among 16 groups where there are more lights. Needs
     AWD_GUIDE_ADAPTIVE, and a field that knows the scene's lights: awdNewSceneField makes one. */
  AWD_LIGHTS_LEARNED = 2
};

/* What render to make. */
typedef struct AWDRenderDesc {
  size_t structSize;
  const AWDCamera* camera; /* copied; required */
  AWDPreset preset;        /* settles every setting that is 0 below */
  AWDGuide guide;          /* where indirect rays go */
  AWDDirectLight direct;   /* how light is found */
  AWDRoulette roulette;    /* how long paths live */
  uint32_t shadowRays;     /* per light and vertex, at most 1024; 0: 1, in the preset paper 4 */
  /* With more lights than this, the shadow rays of a vertex share them by power; 0: 1, in the
     preset paper 8. */
  uint32_t maxLights;
  uint64_t seed;              /* any; the same gives the same bits */
  AWDCombination combination; /* count or experience */
  AWDPoints points;           /* what paths are drawn from */
  /* Of film, pass and field together; 0: no limit. An image that takes more by itself is refused;
     the field splits no patch beyond the rest, which replaces a larger maxBytes of its own. */
  uint64_t maxBytes;
  /* Of the roulette adjoint: rays a vertex, at most 64; 1: none; 0: 8. None in a film of fewer than
     8 samples per pixel. */
  uint32_t maxSplit;
  AWDLightChoice lights; /* which light a shadow ray goes to */
} AWDRenderDesc;

#ifdef __cplusplus
#define AWD_RENDER_DESC_INIT                                                                       \
  AWDRenderDesc { sizeof(AWDRenderDesc), nullptr, 0, 0, 0, 0, 0u, 0u, 0u, 0, 0, 0u, 0u, 0 }
#else
#define AWD_RENDER_DESC_INIT                                                                       \
  { sizeof(AWDRenderDesc), NULL, 0, 0, 0, 0, 0u, 0u, 0u, 0, 0, 0u, 0u, 0 }
#endif

/* awdNewField, for renders of a committed scene: a box and lights that desc leaves open are those
   of the scene, each light by its power, or 16 groups of about equal power where there are more.
   desc NULL: all defaults. AWD_ERROR_INVALID_OPERATION if the scene is not committed; else as
   awdNewField. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewSceneField(AWDScene scene, const AWDFieldDesc* desc,
                                               AWDField* field) AWD_NOEXCEPT;

/* Makes a render of a committed scene with a black film. `field` is used by AWD_GUIDE_ADAPTIVE
   alone; NULL: one of the render's own, made by the same preset (awdNewSceneField). Its scale is
   set from the lights. AWD_ERROR_INVALID_OPERATION if the scene is not committed. Free, but
   exclusive for the field. */
AWD_EXPORT AWDResult AWD_CALL awdNewRender(AWDScene scene, AWDField field,
                                           const AWDRenderDesc* desc,
                                           AWDRender* render) AWD_NOEXCEPT;
/* One reference more, or less; NULL is allowed. Free. */
AWD_EXPORT void AWD_CALL awdRetainRender(AWDRender render) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseRender(AWDRender render) AWD_NOEXCEPT;

/* The render's field, retained: release it. NULL unless the render is adaptive. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetRenderField(AWDRender render, AWDField* field) AWD_NOEXCEPT;

/* Figures of one pass, or of all. */
typedef struct AWDPassStatistics {
  size_t structSize;
  double cpuSeconds;        /* of the process, while rendering and adapting */
  double wallSeconds;       /* likewise */
  uint64_t samplesPerPixel; /* of the pass, or of all */
  uint64_t samples;         /* camera paths */
  uint64_t rays;            /* traced, shadow rays included */
  uint64_t shadowRays;      /* of these */
  uint64_t patches;         /* that have had a sample, at the end */
  uint64_t coefficients;    /* of their densities as used during the pass */
  uint64_t bytes;           /* of field and film */
  /* Paths whose radiance, and records whose value, was NaN, infinite or negative: left out, but
     counted as samples. */
  uint64_t rejectedSamples;
} AWDPassStatistics;

#ifdef __cplusplus
#define AWD_PASS_STATISTICS_INIT                                                                   \
  AWDPassStatistics { sizeof(AWDPassStatistics), 0.0, 0.0, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#else
#define AWD_PASS_STATISTICS_INIT                                                                   \
  { sizeof(AWDPassStatistics), 0.0, 0.0, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#endif

/* One pass of n >= 1 samples per pixel with the densities as they are; doesn't adapt: the host
   calls awdAdaptField. statistics may be NULL. A cancelled (AWD_ERROR_CANCELLED) or failed pass
   leaves film and field as they were. Exclusive, for the field too. */
AWD_EXPORT AWDResult AWD_CALL awdRenderPass(AWDRender render, uint32_t samplesPerPixel,
                                            AWDPassStatistics* statistics) AWD_NOEXCEPT;

/* Several passes. samplesPerPass NULL: totalSamples divided by the library, which renders unguided
   while it knows that there will be fewer than 6 samples per pixel in all, too few for learning to
   pay, unless the field has learned before or the preset is the paper. Both 0: the preset's
   schedule (paper: 10, 10, 10, 70), or with seconds as many as there is time for. */
typedef struct AWDSchedule {
  size_t structSize;
  const uint32_t* samplesPerPass; /* passCount numbers >= 1 */
  uint32_t passCount;             /* 0 if samplesPerPass is NULL */
  uint32_t totalSamples;          /* per pixel */
  /* Wall time, 0: no limit. Sizes of passes are the library's then, 1, 1, 1, 2, 2, 2, 4, ..; none
     is begun that would by the pace of the last go beyond, but for the first, and the last is as
     large as still fits. Not with samplesPerPass. How many samples there are, and with them the
     image, depends on the machine; of so many the bits are what they always are. */
  double seconds;
  /* 0: no limit. Passes of the library's sizes, 16 samples at least, until the upper end of
     awdGetRenderError() is not above this, which the true error then is not either 95 times of 100.
     That error itself, the luckiest of several, may be too low: where few pixels matter the true
     one was above its upper end up to 14 times of 100. Also within totalSamples and seconds, if
     they are set; not with samplesPerPass. */
  double error;
  /* Not 0: all passes that the render has had, before an interruption or before it was saved, count
     as the first of this schedule, and what is left of it is rendered, with the bits of a run that
     was never interrupted. They must be of the sizes that it has; seconds are those of all. */
  int32_t resume;
  uint32_t maxPasses; /* that are rendered now, of those that are left; 0: all */
} AWDSchedule;

#ifdef __cplusplus
#define AWD_SCHEDULE_INIT                                                                          \
  AWDSchedule { sizeof(AWDSchedule), nullptr, 0u, 0u, 0.0, 0.0, 0, 0u }
#else
#define AWD_SCHEDULE_INIT                                                                          \
  { sizeof(AWDSchedule), NULL, 0u, 0u, 0.0, 0.0, 0, 0u }
#endif

/* Runs the passes of a schedule (NULL: the preset's) and adapts between them, not after the last.
   Passes that were finished before a cancellation (AWD_ERROR_CANCELLED) stay: with
   schedule->resume it goes on from there. Exclusive, for the field too. */
AWD_EXPORT AWDResult AWD_CALL awdRenderPasses(AWDRender render,
                                              const AWDSchedule* schedule) AWD_NOEXCEPT;

/* --- to be gone on with ----------------------------------------------------------------------- */

/* Writes a checkpoint: film, figures of all passes, settings and field, in a file that is there
   whole or not at all: until the new one is complete the old one stays. Between passes, such as
   after each (schedule->maxPasses 1). Exclusive, for the field too. */
AWD_EXPORT AWDResult AWD_CALL awdSaveRender(AWDRender render, const char* path) AWD_NOEXCEPT;

/* A render from a checkpoint, with a field of its own if it is adaptive (awdGetRenderField).
   `scene` must be committed and made as it was then: AWD_ERROR_INVALID_ARGUMENT if it is another
   one. `field` and `desc` are what awdNewRender would be given: if their settings are not those of
   the checkpoint, AWD_ERROR_INVALID_ARGUMENT names the first that differs. NULL: as they were. What
   `field` has learned doesn't matter, and it is not used. AWD_ERROR_IO if the file can't be read or
   is damaged.
   The render goes on with the same bits as if it had never stopped, on a machine and with a library
   of the same kind: awdRenderPasses with schedule->resume, or passes one by one. Free. */
AWD_EXPORT AWDResult AWD_CALL awdLoadRender(AWDScene scene, const char* path, AWDField field,
                                            const AWDRenderDesc* desc,
                                            AWDRender* render) AWD_NOEXCEPT;

/* --- in several processes ---------------------------------------------------------------------
   Each has the scene, and a render and a field made alike or loaded from one checkpoint; all call
     for (;;) {
       awdRenderPassPart(render, &schedule, rank, ranks, &samples);
       if (samples == 0) break;
       awdExportPass(render, numbers, capacity, &sums, &maxima);
       MPI_Allreduce(MPI_IN_PLACE, numbers, sums, MPI_UINT64_T, MPI_SUM, comm);
       MPI_Allreduce(MPI_IN_PLACE, numbers + sums, maxima, MPI_UINT64_T, MPI_MAX, comm);
       awdImportPass(render, numbers, sums + maxima, NULL);
     }
   and each then has the film, the field and the passes of awdRenderPasses in one process, bit by
   bit, whatever the number of processes: any may save the checkpoint, and any number go on from it.
   The processes must run the same library on processors of one kind. */

/* Renders part `part` of `parts` of the next pass that the schedule (NULL: the preset's) has after
   those which the render has had, and adapts before it as awdRenderPasses does. *samplesPerPixel:
   of the pass; 0: the schedule is through, and nothing was done. A part is every parts-th tile of
   16 x 16 pixels with all samples of the pass: a pixel's sums are then made by one process in the
   order of its samples; of divided samples the sums would be rounded otherwise. Schedules of
   seconds are refused. What has been rendered counts when it is imported; until then it is given up
   by the next part or pass, which renders the same pass again. A cancelled or failed part leaves
   film and field as they were, but for the adapt, which is not done again. Exclusive, for the field
   too, which must not be used until awdImportPass. */
AWD_EXPORT AWDResult AWD_CALL awdRenderPassPart(AWDRender render, const AWDSchedule* schedule,
                                                uint32_t part, uint32_t parts,
                                                uint32_t* samplesPerPixel) AWD_NOEXCEPT;
/* The part last rendered, as *sums numbers to be added, modulo 2^64, and after them *maxima of
   which the largest is to be taken: 9 numbers a pixel, and those of awdExportField unless the pass
   is unguided. numbers may be NULL if capacity is 0; nothing is written if they don't fit.
   AWD_ERROR_INVALID_OPERATION if no part waits to be imported. Exclusive, for the field too. */
AWD_EXPORT AWDResult AWD_CALL awdExportPass(AWDRender render, uint64_t* numbers, size_t capacity,
                                            size_t* sums, size_t* maxima) AWD_NOEXCEPT;
/* Ends the pass with the numbers of all parts, combined; count = sums + maxima. Of its figures, in
   `statistics` unless that is NULL, cpuSeconds are those of all processes, wallSeconds those of the
   slowest. AWD_ERROR_INVALID_ARGUMENT, and nothing is changed, unless each part is in the numbers
   once, and all processes have the same scene, settings, passes and densities: the message says
   what is wrong. Exclusive, for the field too. */
AWD_EXPORT AWDResult AWD_CALL awdImportPass(AWDRender render, const uint64_t* numbers, size_t count,
                                            AWDPassStatistics* statistics) AWD_NOEXCEPT;

/* How good an image must be, as a promise that the film itself keeps: its error, the upper end of
   awdGetRenderError(), is at most
     draft 0.5, normal 0.25, fine 0.1, reference 0.05
   of its mean radiance, or it has had as many samples per pixel as it may have at most:
     draft 1024, normal 4096, fine 16384, reference 65536. */
typedef int32_t AWDQuality;
enum {
  AWD_QUALITY_DRAFT = 1,    /* error at most 0.5 */
  AWD_QUALITY_NORMAL = 2,   /* at most 0.25 */
  AWD_QUALITY_FINE = 3,     /* at most 0.1 */
  AWD_QUALITY_REFERENCE = 4 /* at most 0.05 */
};

/* Sets `error` and `totalSamples` to those of the quality, and all else to AWD_SCHEDULE_INIT; the
   host may add seconds. Whether the promise was kept is to be asked for after awdRenderPasses():
   upper > schedule.error where samples or seconds ran out before. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetQualitySchedule(AWDQuality quality,
                                                    AWDSchedule* schedule) AWD_NOEXCEPT;

/* Passes finished so far. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetPassCount(AWDRender render, uint32_t* count) AWD_NOEXCEPT;
/* The figures of one of them, index < count. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetPassStatistics(AWDRender render, uint32_t index,
                                                   AWDPassStatistics* statistics) AWD_NOEXCEPT;
/* Sums over all passes; patches, coefficients and bytes are those of the last. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetRenderStatistics(AWDRender render,
                                                     AWDPassStatistics* statistics) AWD_NOEXCEPT;

/* What the film holds of a pixel; each three floats. */
typedef int32_t AWDFilmLayer;
enum {
  AWD_FILM_RADIANCE = 1, /* mean over all samples as they are weighted, linear RGB */
  AWD_FILM_VARIANCE = 2  /* estimated variance of that mean, per channel; 0 below 2 samples */
};

/* Copies a layer: pixel (i, j) goes to pixels + j * rowStride + i * pixelStride bytes; 0: packed.
   Row 0 is on top. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdReadFilm(AWDRender render, AWDFilmLayer layer, float* pixels,
                                          size_t pixelStride, size_t rowStride) AWD_NOEXCEPT;

/* Size of the film and samples per pixel so far; each pointer may be NULL. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetFilmInfo(AWDRender render, uint32_t* width, uint32_t* height,
                                             uint64_t* samplesPerPixel) AWD_NOEXCEPT;

/* How far the film is from the truth, relative to its brightness:
     error = sqrt(mean (x - truth)^2) / mean x, over all pixels and channels,
   as the samples of even and of odd number, which are independent, tell it: honest with
   AWD_POINTS_SOBOL too. The true one lies between lower and upper 95 times of 100 after a number of
   samples that was fixed before; what no sample has met yet, nobody can know of. */
typedef struct AWDRenderError {
  size_t structSize;
  double error; /* estimate */
  double lower; /* end of the interval */
  double upper; /* likewise */
} AWDRenderError;

#ifdef __cplusplus
#define AWD_RENDER_ERROR_INIT                                                                      \
  AWDRenderError { sizeof(AWDRenderError), 0.0, 0.0, 0.0 }
#else
#define AWD_RENDER_ERROR_INIT                                                                      \
  { sizeof(AWDRenderError), 0.0, 0.0, 0.0 }
#endif

/* AWD_ERROR_INVALID_OPERATION below 2 samples per pixel. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetRenderError(AWDRender render,
                                                AWDRenderError* error) AWD_NOEXCEPT;

/* The patch under the middle of a pixel, of the render's field if that has spatial patches;
   AWD_INVALID_ID where nothing is seen. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPixelPatch(AWDRender render, uint32_t x, uint32_t y,
                                               uint32_t* patch) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: Apache-2.0
 *
 * The field: one adaptive density per patch of surface, over the hemisphere above it.
 *
 * A host asks for directions (awdSampleField), tells what came from them (awdRecordField), and
 * after each pass lets the field learn (awdAdaptField). During a pass the densities are frozen, so
 * every estimate that divides by the pdf is unbiased.
 *
 * A density lives on the unit square; a hemisphere map carries it to directions in the tangent
 * frame of the normal n. With p the density on the square, the pdf in solid angle is
 *   spherical          theta = pi u/2, phi = 2 pi v:          p / (pi^2 sin theta)
 *   cylindrical        cos(theta) = u, phi = 2 pi v:          p / (2 pi)
 *   cosine             sin(theta)^2 = u, phi = 2 pi v:        p cos(theta) / pi
 *   concentric-cosine  equal-area square to disk to dome:     p cos(theta) / pi
 */
#ifndef AWD_FIELD_H
#define AWD_FIELD_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A map of the unit square to the hemisphere, as above. */
typedef int32_t AWDHemisphereMap;
enum {
  AWD_MAP_DEFAULT = 0,           /* concentric-cosine; spherical in the preset paper */
  AWD_MAP_SPHERICAL = 1,         /* the paper's */
  AWD_MAP_CONCENTRIC_COSINE = 2, /* a constant density is cosine sampling; no pole, no seam */
  AWD_MAP_CYLINDRICAL = 3,       /* a constant density is uniform */
  AWD_MAP_COSINE = 4             /* a constant density is cosine sampling */
};

/* Which patches there are. */
typedef int32_t AWDPatches;
enum {
  AWD_PATCHES_DEFAULT = 0, /* spatial if there is a box, but for the preset paper */
  /* The library's own, found by awdFindPatch: the leaves of binary trees over positions, a tree for
     each of six dominant directions of normals. A leaf of many samples is split, and its halves
     begin with what it knew. */
  AWD_PATCHES_SPATIAL = 1,
  AWD_PATCHES_HOST = 2 /* the host's numbers, or those of the scene's triangles */
};

/* Of the lights that a field tells apart. */
#define AWD_MOST_FIELD_LIGHTS 64

/* What field to make. */
typedef struct AWDFieldDesc {
  size_t structSize;
  AWDPreset preset;     /* settles every setting that is 0 below */
  AWDHemisphereMap map; /* of all its densities */
  const char* basis;    /* name of a family; NULL: "linear-bspline"; "haar" in the preset paper */
  uint32_t startLevel;  /* AWD_LEVEL(l) of a density's first pass, or 0 */
  /* AWD_LEVEL(l) beyond which nothing is refined, or 0. A patch is refined when it has samples
     enough and, from level 3 on, its density contrast enough; in the preset paper after every pass.
     Default: from level 3 to 4. */
  uint32_t maxLevel;
  /* Coefficients below tau times the mean density are raised to it, 0 < tau <= 1; 0: the
     preset's (paper: 0.05; default: none for the estimator lumped, which has alpha, 0.3 for the
     others); negative: no floor, which risks infinite variance where there is no alpha. */
  double tau;
  AWDEstimator estimator; /* 0: lumped; paper in the preset of that name */
  /* Of the estimator refit: the solver by name, "ceres" or "descent"; NULL: the module's first.
     Both give the same coefficients. maxLevel may be at most what takes 2^28 bytes a patch. */
  const char* refitSolver;
  /* Of quasi and refit, as in AWDDensityDesc. */
  double shrinkage;
  AWDPatches patches; /* the library's or the host's */
  float lower[3]; /* box of the positions of spatial patches, in the host's units; both 0: none, */
  float upper[3]; /* or that of the scene by awdNewSceneField */
  /* A spatial patch that has had more samples is split; 0: 2000. Times sqrt(n / 512) if there are
     n > 512 patches, since memory out of reach of the caches costs more than detail brings. */
  uint32_t patchSamples;
  /* Share of the map's constant density, which with the cosine maps is cosine sampling, in every
     learned density; it grows where samples are few. 0: 0.1 for the estimator lumped, else none;
     negative: none; at most 1. */
  double alpha;
  /* Beyond it no patch is split, and none refined if all could not be; their table, 8 bytes each,
     apart; 0: no limit. */
  uint64_t maxBytes;
  /* Lights, or groups of them, that shadow rays choose among (awd/light.h), at most
     AWD_MOST_FIELD_LIGHTS; 0: the field chooses none, but awdNewSceneField sets the scene's. */
  uint32_t lightCount;
  /* As many powers >= 0, by which lights are chosen where nothing has been learned; copied; NULL:
     equal ones. */
  const float* lightPowers;
  AWDTarget target; /* what densities become proportional to */
} AWDFieldDesc;

#ifdef __cplusplus
#define AWD_FIELD_DESC_INIT                                                                        \
  AWDFieldDesc {                                                                                   \
    sizeof(AWDFieldDesc), 0, 0, nullptr, 0u, 0u, 0.0, 0, nullptr, 0.0, 0, {0.0f, 0.0f, 0.0f},      \
        {0.0f, 0.0f, 0.0f}, 0u, 0.0, 0u, 0u, nullptr, 0                                            \
  }
#else
#define AWD_FIELD_DESC_INIT                                                                        \
  {                                                                                                \
    sizeof(AWDFieldDesc), 0, 0, NULL, 0u, 0u, 0.0, 0, NULL, 0.0, 0, {0.0f, 0.0f, 0.0f},            \
        {0.0f, 0.0f, 0.0f}, 0u, 0.0, 0u, 0u, NULL, 0                                               \
  }
#endif

/* Makes an empty field; desc NULL: all defaults. AWD_ERROR_UNSUPPORTED when there is no such
   basis or, for the estimator refit, no refit module or no such solver in it: the message names
   the paths tried. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewField(AWDDevice device, const AWDFieldDesc* desc,
                                          AWDField* field) AWD_NOEXCEPT;
/* One reference more, or less; NULL is allowed. Free. */
AWD_EXPORT void AWD_CALL awdRetainField(AWDField field) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseField(AWDField field) AWD_NOEXCEPT;

/* The number of the spatial patch at a point of a surface with the unit normal on the side of the
   ray, until the next adapt. A number also tells in which eighth of its patch the point lies, so
   that patches are split where their samples were: numbers that agree but for their three lowest
   bits are one patch. AWD_ERROR_INVALID_OPERATION if patches are the host's. Free, but not while
   the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdFindPatch(AWDField field, const float position[3],
                                           const float normal[3], uint32_t* patch) AWD_NOEXCEPT;

/* A direction drawn from a patch. This struct never grows. */
typedef struct AWDDirectionSample {
  float direction[3]; /* unit, in the upper hemisphere of the normal */
  float pdf;          /* in solid angle, 1/sr */
  float square[2];    /* the same point on the unit square */
  uint32_t component; /* the basis function drawn from (eq. 4); AWD_INVALID_ID unless paper */
  float solidAngle;   /* |d omega / d(u,v)| there, sr: p_square = pdf * solidAngle */
} AWDDirectionSample;

/* Draws a direction from the density of `patch` about the unit vector `normal`, from three
   uniforms in [0,1). Under the estimator paper one chooses the component, two the point; else the
   first two choose the point by the inverse CDF, monotone in each, and the third is not used. A
   patch that has not learned anything has the start density. Free, but not while the field
   adapts. */
AWD_EXPORT AWDResult AWD_CALL awdSampleField(AWDField field, uint32_t patch, const float normal[3],
                                             const double uniforms[3],
                                             AWDDirectionSample* sample) AWD_NOEXCEPT;

/* The pdf in solid angle of a unit direction, 0 below the horizon of `normal`. Free, but not while
   the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetFieldPdf(AWDField field, uint32_t patch, const float normal[3],
                                             const float direction[3], float* pdf) AWD_NOEXCEPT;

/* What came from a direction drawn by awdSampleField since the last adapt: value = luminance of
   f_r L_i cos(theta), that is 0 where nothing came; not divided by the pdf. A value that is NaN,
   infinite or negative counts as a rejected sample of value 0. Sums are integers: the result does
   not depend on the order of calls. The estimator paper goes by the sample's component, the others
   by its square and pdf. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdRecordField(AWDField field, uint32_t patch,
                                             const AWDDirectionSample* sample,
                                             double value) AWD_NOEXCEPT;

/* The magnitude of values to be expected in patches that know nothing yet, such as the luminance
   of the brightest light; default 1. Values are summed in units of about 1e-12 of it; from the
   first adapt on each patch goes by what it has seen. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdSetFieldScale(AWDField field, double magnitude) AWD_NOEXCEPT;

/* Figures of a field and of its last adapt. */
typedef struct AWDFieldStatistics {
  size_t structSize;
  uint64_t patches;          /* that have ever had a sample */
  uint64_t coefficients;     /* of all their densities */
  uint64_t bytes;            /* memory held by the field */
  uint64_t samples;          /* recorded by the pass that the last adapt ended */
  uint64_t rejected;         /* of these: NaN, infinite or negative, or of a bad pdf */
  uint64_t saturated;        /* of these: too large for the scale, clamped */
  uint64_t kept;             /* patches whose samples were of no use: density kept as it was */
  uint64_t refitFailed;      /* patches whose refit failed in the last adapt: quasi instead */
  uint64_t refitLimited;     /* that ended at the solver's limit of iterations */
  uint64_t refitIterations;  /* of the solver in the last adapt, over all patches */
  uint64_t capped;           /* patches that maxBytes kept from being split in the last adapt */
  uint64_t rejectedNaN;      /* of the rejected: by value */
  uint64_t rejectedInfinite; /* likewise */
  uint64_t rejectedNegative; /* likewise */
  uint64_t rejectedPdf;      /* of the rejected: by a pdf that no sample can have, in a path */
} AWDFieldStatistics;

#ifdef __cplusplus
#define AWD_FIELD_STATISTICS_INIT                                                                  \
  AWDFieldStatistics {                                                                             \
    sizeof(AWDFieldStatistics), 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u         \
  }
#else
#define AWD_FIELD_STATISTICS_INIT                                                                  \
  { sizeof(AWDFieldStatistics), 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#endif

/* Ends a pass: every patch's recorded samples become its next density (estimate, clamp,
   normalise; lumped: with what all passes before have taught), refined by a level where that is
   due, and spatial patches of many samples are split; statistics start anew. statistics may be
   NULL. A cancelled adapt (AWD_ERROR_CANCELLED) leaves the field as it was. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdAdaptField(AWDField field,
                                            AWDFieldStatistics* statistics) AWD_NOEXCEPT;

/* For passes that may be given up: awdMarkField remembers what has been recorded so far, and
   awdRevertField forgets all that came after the last mark. awdAdaptField takes everything and
   ends the mark. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdMarkField(AWDField field) AWD_NOEXCEPT;
AWD_EXPORT AWDResult AWD_CALL awdRevertField(AWDField field) AWD_NOEXCEPT;

/* The same figures without adapting. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetFieldStatistics(AWDField field,
                                                    AWDFieldStatistics* statistics) AWD_NOEXCEPT;

/* Writes the numbers of the patches that have had samples, ascending, front sides first; at most
   `capacity` of them; *count is their whole number. patches may be NULL if capacity is 0. Free,
   but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetFieldPatches(AWDField field, uint32_t* patches, size_t capacity,
                                                 size_t* count) AWD_NOEXCEPT;

/* What is known of a patch. */
typedef struct AWDPatchInfo {
  size_t structSize;
  const char* basis;  /* name of the family on both axes; lives as long as the field */
  uint32_t level;     /* of both axes */
  uint32_t axisCount; /* functions per axis; axisCount^2 coefficients */
  uint64_t samples;   /* recorded since the last adapt */
  uint64_t learned;   /* samples of the pass that last changed the density; 0: start density */
} AWDPatchInfo;

#ifdef __cplusplus
#define AWD_PATCH_INFO_INIT                                                                        \
  AWDPatchInfo { sizeof(AWDPatchInfo), nullptr, 0u, 0u, 0u, 0u }
#else
#define AWD_PATCH_INFO_INIT                                                                        \
  { sizeof(AWDPatchInfo), NULL, 0u, 0u, 0u, 0u }
#endif

/* What a patch knows; one never seen has the start density. Free, but not while the field
   adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPatchInfo(AWDField field, uint32_t patch,
                                              AWDPatchInfo* info) AWD_NOEXCEPT;

/* Coefficients c of p(u,v) = sum_jk c[j * axisCount + k] N_j(u) N_k(v), on the unit square;
   capacity must be at least axisCount^2. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPatchCoefficients(AWDField field, uint32_t patch,
                                                      double* coefficients,
                                                      size_t capacity) AWD_NOEXCEPT;

/* What all passes have found the integral of f over the hemisphere to be, in the units of what is
   recorded: with f the luminance of f_r L_i cos(theta), the indirect radiance that the patch
   reflects. For roulette and splitting by the radiance to come, and for a look at the scene. -1
   where nothing is known, and of the estimator paper, which doesn't keep it. Free, but not while
   the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPatchMean(AWDField field, uint32_t patch,
                                              float* mean) AWD_NOEXCEPT;

/* With how many rays on average a path should go on from a vertex, by the radiance that is still to
   come (adjoint-driven roulette and splitting, a weight window). With L what the patch reflects
   (awdGetPatchMean) and r = throughput L / expected,
     rays = max(3 r, 0.1) up to r = 1/3, 1 up to r = 1, min(r, maxSplit) above.
   throughput: luminance of the path's weight before the vertex, finite, not negative; expected:
   that of the radiance the pixel is expected to have, positive: what earlier passes found, blurred,
   serves well; maxSplit: 1 to 64, 1: roulette alone, 0: 8. Trace floor(rays) of them, one more with
   the chance of the fraction, and divide each by `rays`. -1 where nothing is known. Free, but not
   while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetContinuation(AWDField field, uint32_t patch, float throughput,
                                                 float expected, uint32_t maxSplit,
                                                 float* rays) AWD_NOEXCEPT;

/* The density on the unit square as an n x n image: row i, column k holds
   p((k + 1/2)/n, (i + 1/2)/n), u to the right and v downwards; rows are rowStride bytes apart
   (0: packed). 1 <= n <= 16384. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPatchPdf(AWDField field, uint32_t patch, uint32_t n,
                                             float* pixels, size_t rowStride) AWD_NOEXCEPT;

/* --- directions that the host drew itself ---------------------------------------------------- */

/* The unit `direction`, drawn by the host, as a sample that can be recorded: its square, its
   solidAngle and the pdf that the field has for it; the component is AWD_INVALID_ID, which the
   estimator paper does not take. A host that draws with chance a from the field and else from its
   BSDF (a one-sample mixture) sets pdf = a p_field + (1 - a) p_bsdf in every sample, whichever of
   the two it was drawn from, and both divides by that and records with it. Below the horizon
   pdf and solidAngle are 0, and the sample can't be recorded. Free, but not while the field
   adapts. */
AWD_EXPORT AWDResult AWD_CALL awdMapDirection(AWDField field, uint32_t patch, const float normal[3],
                                              const float direction[3],
                                              AWDDirectionSample* sample) AWD_NOEXCEPT;

/* --- many at a time ---------------------------------------------------------------------------
   For wavefront renderers: what the functions for one item do, in the order of the items and with
   the same bits. Arrays are packed: item i has positions[3 i] to positions[3 i + 2], likewise
   normals, directions and uniforms. If an argument is wrong the message names its index, and
   nothing is written or recorded. */

/* awdFindPatch for `count` places. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdFindPatches(AWDField field, size_t count, const float* positions,
                                             const float* normals, uint32_t* patches) AWD_NOEXCEPT;
/* awdSampleField for `count` patches. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdSampleFieldBatch(AWDField field, size_t count,
                                                  const uint32_t* patches, const float* normals,
                                                  const double* uniforms,
                                                  AWDDirectionSample* samples) AWD_NOEXCEPT;
/* awdGetFieldPdf for `count` directions. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetFieldPdfs(AWDField field, size_t count, const uint32_t* patches,
                                              const float* normals, const float* directions,
                                              float* pdfs) AWD_NOEXCEPT;
/* awdRecordField for `count` samples. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdRecordFieldBatch(AWDField field, size_t count,
                                                  const uint32_t* patches,
                                                  const AWDDirectionSample* samples,
                                                  const double* values) AWD_NOEXCEPT;

/* --- paths ------------------------------------------------------------------------------------ */

/* Where a path met a surface, and how it went on. This struct never grows. */
typedef struct AWDPathVertex {
  uint32_t patch;            /* AWD_INVALID_ID: nothing is recorded here, say of a mirror */
  float continuation;        /* chance with which the path went on, in (0,1]; 0: it ended here */
  AWDDirectionSample sample; /* in which it went on; pdf: with which that was drawn, such as a
                                mixture's (awdMapDirection); only pdf counts where nothing is
                                recorded */
  float emitted[3];          /* what the surface emits towards the vertex before, times the weight
                                with which the host combines that with shadow rays */
  float direct[3];           /* what it reflects of light found by shadow rays, combined likewise */
  float scattering[3];       /* f_r cos(theta) of the sampled direction, not divided by anything */
} AWDPathVertex;

/* Records a path of `count` vertices from the camera on. The radiance that leaves vertex i towards
   the one before is
     L_i = emitted + direct + scattering L_(i+1) / (pdf continuation),
   the last term only if the path went on; of a last vertex that went on L_(i+1) is `background`,
   what comes from outside the scene; NULL: 0. Recorded at vertex i, if the path went on there, is
   the luminance of scattering L_(i+1). *radiance, three floats, is L_0, the path's estimate of what
   the camera sees; it may be NULL. Where a pdf is not positive and finite, or the sample's square
   or solidAngle makes no sense, the vertex counts as a rejected sample; so does a value that is
   NaN, infinite or negative. What comes to NaN or infinity beyond a vertex adds nothing to L_i.
   A vertex whose patch, component or continuation can't be fails the call, and nothing is
   recorded. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdRecordFieldPath(AWDField field, size_t count,
                                                 const AWDPathVertex* vertices,
                                                 const float background[3],
                                                 float radiance[3]) AWD_NOEXCEPT;

/* --- in several processes, and to be continued ------------------------------------------------ */

/* Everything that the field is and has recorded, as bytes with version and checksum: *size is how
   many there are; bytes may be NULL if capacity is 0; nothing is written if they don't fit. A
   loaded field goes on with the same bits. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdSaveField(AWDField field, void* bytes, size_t capacity,
                                           size_t* size) AWD_NOEXCEPT;
/* A field from such bytes. Damaged ones are refused with AWD_ERROR_IO; AWD_ERROR_UNSUPPORTED when
   there is no such basis or refit module here. Free. */
AWD_EXPORT AWDResult AWD_CALL awdLoadField(AWDDevice device, const void* bytes, size_t size,
                                           AWDField* field) AWD_NOEXCEPT;
/* The same bytes in a file, which is there whole or not at all: until the new one is complete the
   old one stays. AWD_ERROR_IO if it can't be written. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdWriteField(AWDField field, const char* path) AWD_NOEXCEPT;
/* A field from such a file. AWD_ERROR_IO: there is none, or it is damaged. Free. */
AWD_EXPORT AWDResult AWD_CALL awdReadField(AWDDevice device, const char* path,
                                           AWDField* field) AWD_NOEXCEPT;

/* Adds what `other` has recorded since its last adapt; `other` stays as it is. Both must be the
   same in settings, patches and densities, such as fields loaded from the same bytes: the message
   says what differs. A pass recorded in parts by several fields and merged gives the same bits as
   recorded by one. Save between passes: what had been recorded before counts in every copy.
   Exclusive for both. */
AWD_EXPORT AWDResult AWD_CALL awdMergeField(AWDField field, AWDField other) AWD_NOEXCEPT;

/* For many processes that record parts of a pass at once, each in a field of its own: what this one
   has recorded since the last adapt, or since awdMarkField after it, as numbers that are combined
   element by element. The first *sums are to be added, modulo 2^64; of the *maxima after them the
   largest is to be taken, since which value was the largest can't be had from sums. With MPI:
     MPI_Allreduce(MPI_IN_PLACE, numbers, sums, MPI_UINT64_T, MPI_SUM, comm);
     MPI_Allreduce(MPI_IN_PLACE, numbers + sums, maxima, MPI_UINT64_T, MPI_MAX, comm);
   All fields must be the same in settings, patches, densities and scale, such as fields loaded from
   the same bytes, or made alike and then adapted to the same imports. The numbers are laid out over
   the patches of these densities, also those that this process has not touched. Of a field with
   patches of the host's own `patches` has the numbers of all in which any of the processes may have
   recorded, patchCount of them, ascending and the same for all; with spatial patches NULL and 0.
   numbers may be NULL if capacity is 0; nothing is written if they don't fit.
   AWD_ERROR_INVALID_ARGUMENT if a patch that is not in `patches` has records. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdExportField(AWDField field, const uint32_t* patches,
                                             size_t patchCount, uint64_t* numbers, size_t capacity,
                                             size_t* sums, size_t* maxima) AWD_NOEXCEPT;
/* Puts the combined numbers, count = sums + maxima, in place of what this field has recorded since
   then: the bits are those of one process that has recorded everything, and each process goes on
   with awdAdaptField to the same densities. Where a pass is recorded on top without an adapt,
   awdMarkField comes first, lest what is common be exported again.
   AWD_ERROR_INVALID_ARGUMENT, and nothing is changed, if the fields were not all the same: the
   message says in what they differ. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdImportField(AWDField field, const uint32_t* patches,
                                             size_t patchCount, const uint64_t* numbers,
                                             size_t count) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif

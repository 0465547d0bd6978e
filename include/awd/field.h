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
 *   concentric-cosine  equal-area square to disk to dome:     p cos(theta) / pi
 */
#ifndef AWD_FIELD_H
#define AWD_FIELD_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t AWDHemisphereMap;
enum { AWD_MAP_DEFAULT = 0, AWD_MAP_SPHERICAL = 1, AWD_MAP_CONCENTRIC_COSINE = 2 };

typedef struct AWDFieldDesc {
  size_t structSize;
  AWDPreset preset; /* settles every setting that is 0 below */
  AWDHemisphereMap map;
  const char* basis;   /* name of a family; NULL: "haar" */
  uint32_t startLevel; /* AWD_LEVEL(l) of a density's first pass, or 0 */
  uint32_t maxLevel;   /* AWD_LEVEL(l) beyond which nothing is refined, or 0 */
  /* Coefficients below tau times the mean density are raised to it, 0 < tau <= 1; 0: the
     preset's (paper: 0.05; default: 0.3); negative: no floor, which risks infinite variance. */
  double tau;
  AWDEstimator estimator; /* 0: paper */
  /* Of the estimator refit: the solver by name, "ceres" or "descent"; NULL: the module's first.
     Both give the same coefficients. maxLevel may be at most what takes 2^28 bytes a patch. */
  const char* refitSolver;
  /* Of quasi and refit, as in AWDDensityDesc. */
  double shrinkage;
} AWDFieldDesc;

#ifdef __cplusplus
#define AWD_FIELD_DESC_INIT                                                                        \
  AWDFieldDesc { sizeof(AWDFieldDesc), 0, 0, nullptr, 0u, 0u, 0.0, 0, nullptr, 0.0 }
#else
#define AWD_FIELD_DESC_INIT                                                                        \
  { sizeof(AWDFieldDesc), 0, 0, NULL, 0u, 0u, 0.0, 0, NULL, 0.0 }
#endif

/* Makes an empty field; desc NULL: all defaults. AWD_ERROR_UNSUPPORTED when there is no such
   basis or, for the estimator refit, no refit module or no such solver in it: the message names
   the paths tried. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewField(AWDDevice device, const AWDFieldDesc* desc,
                                          AWDField* field) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdRetainField(AWDField field) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseField(AWDField field) AWD_NOEXCEPT;

/* A direction drawn from a patch. This struct never grows. */
typedef struct AWDDirectionSample {
  float direction[3]; /* unit, in the upper hemisphere of the normal */
  float pdf;          /* in solid angle, 1/sr */
  float square[2];    /* the same point on the unit square */
  uint32_t component; /* the basis function that it was drawn from (eq. 4) */
  float solidAngle;   /* |d omega / d(u,v)| there, sr: p_square = pdf * solidAngle */
} AWDDirectionSample;

/* Draws a direction from the density of `patch` about the unit vector `normal`, from three
   uniforms in [0,1): one chooses the component, two the point. A patch that has not learned
   anything has the start density. Free, but not while the field adapts. */
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

typedef struct AWDFieldStatistics {
  size_t structSize;
  uint64_t patches;         /* that have ever had a sample */
  uint64_t coefficients;    /* of all their densities */
  uint64_t bytes;           /* memory held by the field */
  uint64_t samples;         /* recorded by the pass that the last adapt ended */
  uint64_t rejected;        /* of these: NaN, infinite or negative */
  uint64_t saturated;       /* of these: too large for the scale, clamped */
  uint64_t kept;            /* patches whose samples were of no use: density kept as it was */
  uint64_t refitFailed;     /* patches whose refit failed in the last adapt: quasi instead */
  uint64_t refitLimited;    /* that ended at the solver's limit of iterations */
  uint64_t refitIterations; /* of the solver in the last adapt, over all patches */
} AWDFieldStatistics;

#ifdef __cplusplus
#define AWD_FIELD_STATISTICS_INIT                                                                  \
  AWDFieldStatistics { sizeof(AWDFieldStatistics), 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#else
#define AWD_FIELD_STATISTICS_INIT                                                                  \
  { sizeof(AWDFieldStatistics), 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#endif

/* Ends a pass: every patch's recorded samples become its next density (estimate, clamp,
   normalise), refined by a level where that is due; statistics start anew. statistics may be NULL.
   A cancelled adapt leaves the field as it was. Exclusive. */
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

typedef struct AWDPatchInfo {
  size_t structSize;
  const char* basis;  /* name of the family on both axes; lives as long as the field */
  uint32_t level;     /* of both axes */
  uint32_t axisCount; /* functions per axis; axisCount^2 coefficients */
  uint64_t samples;   /* recorded since the last adapt */
  uint64_t learned;   /* samples that the present density was made of; 0: start density */
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

/* The density on the unit square as an n x n image: row i, column k holds
   p((k + 1/2)/n, (i + 1/2)/n), u to the right and v downwards; rows are rowStride bytes apart
   (0: packed). 1 <= n <= 16384. Free, but not while the field adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetPatchPdf(AWDField field, uint32_t patch, uint32_t n,
                                             float* pixels, size_t rowStride) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif

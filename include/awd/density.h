/* SPDX-License-Identifier: Apache-2.0
 *
 * Adaptive densities on the unit cube [0,1]^d, d = 1 to 6: pdfs that learn |f| from samples of f,
 * so that the next samples fall where f is large (Pietrek and Peter 1999).
 *
 * p(x) = sum_j c_j N_j(x) with c_j >= 0, N_j products of one basis function per axis. A *grid* is
 * the tensor product of any families; a *tree* halves boxes along one axis at a time where that
 * pays, and each of its leaves carries the lowest level of a nested family on every axis.
 *
 * A pass: draw points (awdSampleDensity), evaluate f there, tell (awdRecordDensity), and let the
 * density learn (awdAdaptDensity). In between p is frozen, so that the mean of f/p is unbiased.
 * What is recorded goes into sums that don't depend on the order: the same samples give the same
 * bits however they were split into batches, threads (awdForkDensity) or machines
 * (awdExportDensityStatistics).
 *
 * Arrays are packed: point i starts at points[i * dimensions].
 */
#ifndef AWD_DENSITY_H
#define AWD_DENSITY_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define AWD_MAX_DIMENSIONS 6u /* of a density, at most */

/* How coefficients are laid out. */
typedef int32_t AWDDensityStructure;
enum {
  AWD_STRUCTURE_DEFAULT = 0, /* grid */
  AWD_STRUCTURE_GRID = 1,    /* a tensor product */
  AWD_STRUCTURE_TREE = 2     /* boxes, each with its own */
};

/* inverse CDF: marginal, then conditionals; one uniform per axis; monotone, so that stratified
   uniforms give stratified points. component: eq. 4 of the paper, a component from the first
   uniform and the point from it by one uniform per axis; grids only. */
typedef int32_t AWDSampler;
enum {
  AWD_SAMPLER_DEFAULT = 0,     /* component for the estimator paper, else inverse CDF */
  AWD_SAMPLER_INVERSE_CDF = 1, /* keeps strata */
  AWD_SAMPLER_COMPONENT = 2    /* the paper's */
};

/* One axis. This struct is part of others and never grows. */
typedef struct AWDDensityAxis {
  const char* basis;   /* family; NULL: "linear-bspline" on a grid, "haar" in a tree */
  uint32_t startLevel; /* AWD_LEVEL(l) at first; 0: by passSamples */
  uint32_t maxLevel;   /* AWD_LEVEL(l) beyond which it never refines; 0: by maxCoefficients on a
                          grid, 20 halvings in a tree. Equal levels: it stays there. */
} AWDDensityAxis;

/* What density to make. */
typedef struct AWDDensityDesc {
  size_t structSize;
  uint32_t dimensions;           /* 1 to AWD_MAX_DIMENSIONS */
  AWDDensityStructure structure; /* grid or tree */
  const AWDDensityAxis* axes;    /* `dimensions` of them; NULL: all defaults */
  AWDEstimator estimator;        /* how coefficients come from samples */
  AWDTarget target;              /* what p becomes proportional to */
  AWDSampler sampler;            /* how points are drawn */
  AWDCombination combination;    /* how passes make one estimate: count or cross-variance */
  /* Coefficients below tau times the mean density are raised to it, 0 < tau <= 1. 0: with m
     samples and n coefficients 1 / (1 + m/n), within 0.01 and 0.1 (0.3 if nothing is shrunk), for
     piecewise constants; 0.01 for smoother bases; 0.1 for the estimator paper. Negative: no floor,
     which risks infinite variance. */
  double tau;
  /* kappa >= 0 of the cascade c_L = (n_j r_j + kappa P c_{L-1}) / (n_j + kappa), the number of
     samples that the coarser level is worth. 0: 2 for piecewise constants, 0.5 for others;
     negative: no cascade. */
  double shrinkage;
  uint64_t passSamples;     /* to be expected in a pass; 0: 1024, later twice the last pass's */
  uint64_t maxCoefficients; /* 0: 65536 */
  /* Of the estimator refit: the solver by name, "ceres" or "descent"; NULL: the module's first.
     Both give the same coefficients. */
  const char* refitSolver;
  /* Most memory that the sums of refit may take; 0: 2^28. Levels and trees grow no further. */
  uint64_t refitBytes;
} AWDDensityDesc;

#ifdef __cplusplus
#define AWD_DENSITY_DESC_INIT                                                                      \
  AWDDensityDesc {                                                                                 \
    sizeof(AWDDensityDesc), 0u, 0, nullptr, 0, 0, 0, 0, 0.0, 0.0, 0u, 0u, nullptr, 0u              \
  }
#else
#define AWD_DENSITY_DESC_INIT                                                                      \
  { sizeof(AWDDensityDesc), 0u, 0, NULL, 0, 0, 0, 0, 0.0, 0.0, 0u, 0u, NULL, 0u }
#endif

/* Makes a constant density. AWD_ERROR_UNSUPPORTED when there is no such basis or, for the estimator
   refit, no refit module or no such solver in it (the message names the paths tried), or a tree is
   asked of a family that is not nested. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewDensity(AWDDevice device, const AWDDensityDesc* desc,
                                            AWDDensity* density) AWD_NOEXCEPT;
/* One reference more, or less; NULL is allowed. Free. */
AWD_EXPORT void AWD_CALL awdRetainDensity(AWDDensity density) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseDensity(AWDDensity density) AWD_NOEXCEPT;

/* A density of the same p, which both share, and with no samples: one for each thread that
   records. A fork is a density in its own right. Free, but not while `density` adapts. */
AWD_EXPORT AWDResult AWD_CALL awdForkDensity(AWDDensity density, AWDDensity* fork) AWD_NOEXCEPT;
/* Moves what was recorded by a fork to the density that it was forked from, or to another of its
   forks; the fork then takes over that one's p and has no samples. AWD_ERROR_INVALID_OPERATION if
   it has samples of another p than that one has now. Exclusive for both. */
AWD_EXPORT AWDResult AWD_CALL awdJoinDensity(AWDDensity density, AWDDensity fork) AWD_NOEXCEPT;

/* Draws `count` points. uniforms: `dimensions` numbers in [0,1) a point, one more first if the
   sampler is component. pdfs (1 a point) and components (1 a point; AWD_INVALID_ID unless the
   sampler is component) may be NULL. Points are in [0,1)^d, and pdfs are bit for bit what
   awdGetDensityPdf says of them. Free, but not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdSampleDensity(AWDDensity density, size_t count,
                                               const double* uniforms, double* points, double* pdfs,
                                               uint32_t* components) AWD_NOEXCEPT;

/* p at `count` points of [0,1]^d. Free, but not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityPdf(AWDDensity density, size_t count,
                                               const double* points, double* pdfs) AWD_NOEXCEPT;

/* Tells the values f of `count` points. pdfs: with what density each was drawn, positive: that of
   awdSampleDensity or, say, of a mixture; NULL: p itself, evaluated here. components: of the
   sampler component, else NULL. Zeros belong in. A value that is NaN or infinite, or at a
   point where p itself is 0, counts as a rejected sample of value 0; of negative ones the density
   learns |f|. If an argument is wrong nothing is recorded. At most 2^30 - 1 samples a pass: with
   more AWD_ERROR_INVALID_OPERATION. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdRecordDensity(AWDDensity density, size_t count,
                                               const double* points, const double* pdfs,
                                               const uint32_t* components,
                                               const double* values) AWD_NOEXCEPT;

/* What an adapt made of a pass. */
typedef struct AWDDensityReport {
  size_t structSize;
  uint64_t samples;         /* of the pass */
  uint64_t rejected;        /* of these: NaN or infinite */
  uint64_t coefficients;    /* of the new density */
  uint64_t negative;        /* coefficients that came out negative, before the floor */
  uint64_t coarsened;       /* tree: coefficients saved where details were below their error */
  uint64_t split;           /* tree: boxes halved */
  double tau;               /* the floor that was used; 0: none */
  AWDEstimator estimator;   /* that was used */
  int32_t kept;             /* 1: the samples were of no use, p is as it was */
  uint32_t estimatedLevels; /* grid: rungs of the cascade that were estimated, 1 if there was none;
                               the levels beyond are refined from them */
  AWDRefitStatus refitStatus; /* this and all below: of the estimator refit */
  uint32_t refitIterations;   /* the solver's: sweeps of descent, trust-region steps of ceres */
  uint64_t refitAtBound;      /* coefficients that the floor holds */
  double refitLambda;         /* lambda of the pull towards the cascade */
  double refitObjective;      /* what was minimised over that of c = 0: 0 would be a perfect fit */
  const char* refitMessage;   /* the solver's own account; lives until the density's next adapt */
} AWDDensityReport;

#ifdef __cplusplus
#define AWD_DENSITY_REPORT_INIT                                                                    \
  AWDDensityReport {                                                                               \
    sizeof(AWDDensityReport), 0u, 0u, 0u, 0u, 0u, 0u, 0.0, 0, 0, 0u, 0, 0u, 0u, 0.0, 0.0, nullptr  \
  }
#else
#define AWD_DENSITY_REPORT_INIT                                                                    \
  { sizeof(AWDDensityReport), 0u, 0u, 0u, 0u, 0u, 0u, 0.0, 0, 0, 0u, 0, 0u, 0u, 0.0, 0.0, NULL }
#endif

/* Ends a pass: p becomes what the samples say, its level or tree what their number bears;
   recording starts anew. report may be NULL. A failure changes nothing. Only refit takes long
   enough to tell of its progress and to be cancelled (AWD_ERROR_CANCELLED). Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdAdaptDensity(AWDDensity density,
                                              AWDDensityReport* report) AWD_NOEXCEPT;

#define AWD_ALL_AXES 0xFFFFFFFFu /* of awdRefineDensity: along every axis */

/* The same p one level finer along an axis or all of them (two-scale relation; a tree halves every
   leaf). AWD_ERROR_INVALID_OPERATION after samples have been recorded, and beyond maxCoefficients.
   Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdRefineDensity(AWDDensity density, uint32_t axis) AWD_NOEXCEPT;

/* The estimate of int f over [0,1]^d by all passes, the one at work included. */
typedef struct AWDDensityEstimate {
  size_t structSize;
  double integral;      /* of f over [0,1]^d */
  double standardError; /* as of independent samples: too large if they were stratified */
  uint64_t samples;     /* of all passes */
  uint64_t passes;      /* that had samples */
} AWDDensityEstimate;

#ifdef __cplusplus
#define AWD_DENSITY_ESTIMATE_INIT                                                                  \
  AWDDensityEstimate { sizeof(AWDDensityEstimate), 0.0, 0.0, 0u, 0u }
#else
#define AWD_DENSITY_ESTIMATE_INIT                                                                  \
  { sizeof(AWDDensityEstimate), 0.0, 0.0, 0u, 0u }
#endif

/* Mean of f/p over the recorded samples, passes combined as the desc says. 0 and 0 without
   samples; infinite error with one. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityEstimate(AWDDensity density,
                                                    AWDDensityEstimate* estimate) AWD_NOEXCEPT;

/* What a density is, with the defaults settled. */
typedef struct AWDDensityInfo {
  size_t structSize;
  uint32_t dimensions;           /* of points */
  AWDDensityStructure structure; /* grid or tree */
  AWDEstimator estimator;        /* asked for; 0: chosen anew by every adapt */
  AWDTarget target;              /* of learning */
  AWDSampler sampler;            /* of points */
  AWDCombination combination;    /* of passes */
  uint32_t uniforms;             /* per point that awdSampleDensity wants */
  uint32_t reserved;             /* 0 */
  uint64_t coefficients;         /* of p */
  uint64_t leaves;               /* boxes of a tree, 1 for a grid */
  uint64_t bytes;                /* memory held, p and statistics */
  uint64_t samples;              /* recorded since the last adapt */
  uint64_t rejected;             /* of these */
  uint64_t learned;              /* samples that p was made of; 0: constant, or set by the host */
  uint64_t passes;               /* adapts so far */
} AWDDensityInfo;

#ifdef __cplusplus
#define AWD_DENSITY_INFO_INIT                                                                      \
  AWDDensityInfo { sizeof(AWDDensityInfo), 0u, 0, 0, 0, 0, 0, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#else
#define AWD_DENSITY_INFO_INIT                                                                      \
  { sizeof(AWDDensityInfo), 0u, 0, 0, 0, 0, 0, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u }
#endif

/* Settings and size. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityInfo(AWDDensity density,
                                                AWDDensityInfo* info) AWD_NOEXCEPT;

/* What an axis has. */
typedef struct AWDDensityAxisInfo {
  size_t structSize;
  const char* basis; /* lives as long as the density */
  uint32_t level;    /* grid: present level; tree: most halvings of any leaf along this axis */
  uint32_t maxLevel; /* beyond which it never refines */
  uint32_t count;    /* functions along this axis, of the grid or of one leaf */
  uint32_t cells;    /* polynomial pieces they are made of */
  uint32_t order;    /* polynomial degree + 1 */
  uint32_t flags;    /* AWD_BASIS_... of awd/basis.h */
} AWDDensityAxisInfo;

#ifdef __cplusplus
#define AWD_DENSITY_AXIS_INFO_INIT                                                                 \
  AWDDensityAxisInfo { sizeof(AWDDensityAxisInfo), nullptr, 0u, 0u, 0u, 0u, 0u, 0u }
#else
#define AWD_DENSITY_AXIS_INFO_INIT                                                                 \
  { sizeof(AWDDensityAxisInfo), NULL, 0u, 0u, 0u, 0u, 0u, 0u }
#endif

/* Basis and level of axis 0 <= axis < dimensions. Free, but not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityAxisInfo(AWDDensity density, uint32_t axis,
                                                    AWDDensityAxisInfo* info) AWD_NOEXCEPT;

/* In which basis coefficients are told. scaling: c_j as above; the constant 1 has all of them 1.
   orthonormal, for nested families: in the orthonormal basis of each cell, Legendre polynomials
   for m2 and m3, normalised boxes for Haar and f2; the squares sum to int p^2. */
typedef int32_t AWDCoefficientForm;
enum {
  AWD_COEFFICIENTS_SCALING = 0,    /* of the functions that p is made of */
  AWD_COEFFICIENTS_ORTHONORMAL = 1 /* of nested families alone */
};

/* All coefficients: of a grid with the last axis running fastest, of a tree leaf by leaf with each
   leaf like a grid. capacity: at least AWDDensityInfo.coefficients. AWD_ERROR_UNSUPPORTED if they
   are to be orthonormal and a family is not nested. Free, but not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityCoefficients(AWDDensity density, AWDCoefficientForm form,
                                                        double* coefficients,
                                                        size_t capacity) AWD_NOEXCEPT;

/* Makes p the density of these scaling coefficients, divided by their integral. They must be
   finite, none negative, not all 0; as many as there are now. AWD_ERROR_INVALID_OPERATION after
   samples have been recorded. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdSetDensityCoefficients(AWDDensity density,
                                                        const double* coefficients,
                                                        size_t count) AWD_NOEXCEPT;

/* int of p over the box from lower to upper, `dimensions` numbers each in [0,1]; both NULL: over
   all of [0,1]^d, that is 1 but for rounding. Free, but not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityIntegral(AWDDensity density, const double* lower,
                                                    const double* upper,
                                                    double* integral) AWD_NOEXCEPT;

/* The boxes of a tree's leaves, in the order of their coefficients: boxes[2 d i + a] is the lower
   and boxes[2 d i + d + a] the upper end of leaf i along axis a. capacity counts leaves. Free, but
   not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityLeaves(AWDDensity density, double* boxes,
                                                  size_t capacity, size_t* count) AWD_NOEXCEPT;

/* For nested families, int p^2 split by wavelets: energies[0] that of the coarsest level,
   energies[1 + l] that of the details between rung l and the next; a rung refines all axes of a
   grid by a level, or halves boxes of a tree once. Sums to int p^2. *count: how many there are.
   AWD_ERROR_UNSUPPORTED if a family is not nested. Free, but not while the density adapts. */
AWD_EXPORT AWDResult AWD_CALL awdGetDensityDetailEnergy(AWDDensity density, double* energies,
                                                        size_t capacity,
                                                        size_t* count) AWD_NOEXCEPT;

/* What was recorded since the last adapt, as bytes to be sent to another process or machine:
   *size is how many there are; bytes may be NULL if capacity is 0; nothing is written if they
   don't fit. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdExportDensityStatistics(AWDDensity density, void* bytes,
                                                         size_t capacity,
                                                         size_t* size) AWD_NOEXCEPT;
/* Adds what another density of the same bases and boxes exported. AWD_ERROR_IO: damaged bytes.
   AWD_ERROR_INVALID_OPERATION: more than 2^30 - 1 samples. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdAddDensityStatistics(AWDDensity density, const void* bytes,
                                                      size_t size) AWD_NOEXCEPT;
/* Forgets what was recorded and takes this instead; else like adding. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdImportDensityStatistics(AWDDensity density, const void* bytes,
                                                         size_t size) AWD_NOEXCEPT;

/* Everything that the density is and has recorded, as bytes with version and checksum, as above.
   A loaded density goes on with the same bits. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdSaveDensity(AWDDensity density, void* bytes, size_t capacity,
                                             size_t* size) AWD_NOEXCEPT;
/* A density from such bytes. Damaged ones are refused with AWD_ERROR_IO; AWD_ERROR_UNSUPPORTED when
   there is no such basis or refit module here. Free. */
AWD_EXPORT AWDResult AWD_CALL awdLoadDensity(AWDDevice device, const void* bytes, size_t size,
                                             AWDDensity* density) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: Apache-2.0
 *
 * The interface of basis plugins, with an ABI number of its own. A plugin includes this header
 * alone and links nothing.
 *
 * A family is a ladder of bases N_0 .. N_{n-1} of non-negative functions on [0,1], one rung a
 * level, that
 *   - sum to 1 (partition of unity),
 *   - are polynomials of degree < order on each of cells(level) equal cells, with non-negative
 *     Bernstein coefficients there,
 *   - refine: every function of a level is a non-negative combination of those of the next.
 * With w_j = int N_j, N_j / w_j is a pdf (eq. 3 of Pietrek and Peter 1999).
 *
 * The functions of the table are pure: no state, no allocation, no output, callable from any
 * thread at any time. The library tests every one before a family's name becomes visible, and
 * compiles the family into tables: sampling never calls a plugin.
 */
#ifndef AWD_BASIS_H
#define AWD_BASIS_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define AWD_BASIS_ABI 1u /* bumped only on a break; also in the entry point's name */
/* The symbol that a plugin exports. */
#define AWD_BASIS_ENTRY awdBasisModule_v1
#define AWD_BASIS_MAX_ORDER 8u  /* functions alive at one x, and degree + 1, at most */
#define AWD_BASIS_MAX_LEVEL 20u /* no family goes beyond */

/* Flags of a family. */
enum {
  AWD_BASIS_ORTHOGONAL = 1u, /* int N_j N_k = 0 for j != k */
  /* Indices run modulo count(level); a shift by one cell shifts them by count / cells. */
  AWD_BASIS_PERIODIC = 2u,
  /* Each support lies in one dyadic cell of size 2^-level: tree densities allowed. Levels begin
     at 0 with n <= AWD_BASIS_MAX_ORDER functions; function n c + k of a level is function k of
     level 0 on dyadic cell c. */
  AWD_BASIS_NESTED = 4u
};

/* A family: what it is, and its functions. */
typedef struct AWDBasisFamily {
  size_t structSize;   /* sizeof(AWDBasisFamily); append only */
  const char* name;    /* ^[a-z][a-z0-9_.-]{0,63}$; unique on a device */
  const char* summary; /* one line */
  uint32_t flags;      /* AWD_BASIS_ORTHOGONAL and so on, together */
  uint32_t order;      /* polynomial degree + 1, 1 to AWD_BASIS_MAX_ORDER */
  uint32_t sampleDims; /* uniforms that `sample` takes, 1 to AWD_BASIS_MAX_ORDER */
  uint32_t minLevel;   /* coarsest level that it has */
  uint32_t maxLevel;   /* minLevel to AWD_BASIS_MAX_LEVEL */
  /* Number n of functions. */
  uint32_t(AWD_CALL* count)(uint32_t level);
  /* Number of equal polynomial pieces. */
  uint32_t(AWD_CALL* cells)(uint32_t level);
  /* Smallest interval outside which N_j is 0; for a periodic one that wraps, ab[1] > 1. */
  void(AWD_CALL* support)(uint32_t level, uint32_t j, double ab[2]);
  /* w_j = int_0^1 N_j */
  double(AWD_CALL* weight)(uint32_t level, uint32_t j);
  /* Values of N_first .. N_{first+k-1} at x in [0,1]; returns k <= AWD_BASIS_MAX_ORDER; all
     others are 0 there. Indices run modulo n if the family is periodic. At a cell boundary the
     cell to the right counts; at x = 1 the last one. */
  uint32_t(AWD_CALL* eval)(uint32_t level, double x, uint32_t* first, double* values);
  /* x ~ N_j / w_j from `sampleDims` uniforms in [0,1) */
  double(AWD_CALL* sample)(uint32_t level, uint32_t j, const double* u);
  /* Two-scale relation N^l_j = sum_k h_k N^{l+1}_{first+k}, level < maxLevel; returns how many h
     it wrote, at most 2 * AWD_BASIS_MAX_ORDER. */
  uint32_t(AWD_CALL* twoScale)(uint32_t level, uint32_t j, uint32_t* first, double* h);
  /* Nested families only, or NULL: the wavelets psi_k, k < count(0), of one cell. Writes the
     count(1) = 2 count(0) numbers g of psi_k = sum_i g_i N^1_i. The detail k of f is int f psi_k;
     with the projection on level 0 the details determine f on level 1. NULL: the library takes
     an orthonormal basis of what level 1 has beyond level 0. */
  void(AWD_CALL* wavelet)(uint32_t k, double* g);
  /* int x^i psi_k(x) dx = 0 for i < vanishingMoments; with `wavelet` at least 1, so that details
     carry no mass, and at most AWD_BASIS_MAX_ORDER; without it 0 */
  uint32_t vanishingMoments;
} AWDBasisFamily;

/* The host's services; a plugin may ignore them. */
typedef struct AWDBasisHost {
  size_t structSize;
  uint32_t abi;            /* AWD_BASIS_ABI of the library */
  uint32_t libraryVersion; /* AWD_VERSION of the library */
} AWDBasisHost;

/* What a plugin is made of. */
typedef struct AWDBasisModule {
  size_t structSize;                     /* sizeof(AWDBasisModule); append only */
  uint32_t abi;                          /* AWD_BASIS_ABI that the plugin was compiled with */
  uint32_t familyCount;                  /* 1 to 256 */
  const char* version;                   /* of the plugin, for people */
  const char* license;                   /* likewise */
  const AWDBasisFamily* const* families; /* familyCount of them */
} AWDBasisModule;

/* A plugin's one exported symbol, AWD_BASIS_ENTRY, is of this type. It returns static storage,
   or NULL to refuse the host. Free. */
typedef const AWDBasisModule*(AWD_CALL* AWDBasisModuleFn)(const AWDBasisHost* host);

/* A plugin defines it as:
     AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host)
   Free. */
AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost* host) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif

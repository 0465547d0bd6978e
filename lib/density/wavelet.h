// SPDX-License-Identifier: Apache-2.0
// One dyadic split of a nested family in one dimension: the coefficients of two halves of a cell
// against those of the whole cell and the details between.
//
// All integrals are over the unit cell, with the average as the unit: a detail is
// int_0^1 f(t) psi_k(t) dt whatever the size s of the node is. The integral over the node itself
// is s times it, the L2 norm of the node's part of f is sqrt(s) times that on the unit cell.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "basis/family.h"

namespace awd {

class WaveletFilter {
 public:
  /// The family is nested and is not used after the call; AWD_ERROR_UNSUPPORTED if it is not
  /// nested, AWD_ERROR_PLUGIN_SELF_TEST if its wavelets do not determine what a split adds.
  WaveletFilter(std::pmr::memory_resource* memory, const Family& family);

  /// Coefficients of one cell, n; also the number of its details. At most AWD_BASIS_MAX_ORDER.
  uint32_t size() const { return n_; }

  // Below, an array is one fibre of a tensor: n elements, `stride` apart, the same stride for all
  // arrays of a call. Outputs may be the inputs' own memory.

  /// From the two halves to the whole: coarse is the orthogonal projection of f on the whole
  /// cell's functions (the mass is kept; coefficients may come out negative where order > 1),
  /// detail[k] = int f psi_k.
  void analyse(const double* left, const double* right, std::size_t stride, double* coarse,
               double* detail) const;

  /// The inverse of analyse.
  void synthesise(const double* coarse, const double* detail, std::size_t stride, double* left,
                  double* right) const;

  /// The same function on both halves, by the two-scale relation: keeps sign and mass. Not
  /// synthesise with details 0 unless the wavelets are orthogonal to the cell's functions: with
  /// the two vanishing moments of flatlets, no details means a straight line.
  void split(const double* coarse, std::size_t stride, double* left, double* right) const;

  /// int_0^1 of the square of what the details alone stand for: of synthesise(0, detail).
  double detailEnergy(const double* detail, std::size_t stride) const;

  /// int_0^1 (f - its projection on the whole cell)^2: what is lost when the halves are merged.
  /// The same as the energy of the details if the wavelets are orthogonal to the cell's functions.
  double mergeError(const double* left, const double* right, std::size_t stride) const;

  // Orthonormal coefficients, for which sums of squares are integrals of squares; on each axis of
  // a tensor in turn.

  /// Coefficients of an orthonormal basis of the whole cell: boxes times sqrt(n) for a family of
  /// boxes, else Legendre polynomials as far as the family has them, of rising degree.
  void toOrthonormal(const double* scaling, std::size_t stride, double* orthonormal) const;
  void fromOrthonormal(const double* orthonormal, std::size_t stride, double* scaling) const;

  /// Details scaled and mixed such that detailEnergy is their sum of squares; the identity for
  /// wavelets that are orthonormal, and orthogonal to the cell's functions.
  void toOrthonormalDetail(const double* detail, std::size_t stride, double* orthonormal) const;

 private:
  using Matrix = std::pmr::vector<double>;  ///< row by row

  uint32_t n_;
  Matrix analysis_;           ///< 2n x 2n: (coarse, detail) from (left, right)
  Matrix synthesis_;          ///< its inverse
  Matrix split_;              ///< 2n x n
  Matrix loss_;               ///< n x 2n: sum of squares is mergeError
  Matrix toOrthonormal_;      ///< n x n
  Matrix fromOrthonormal_;    ///< its inverse
  Matrix orthonormalDetail_;  ///< n x n
};

}  // namespace awd

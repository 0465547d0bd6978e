// SPDX-License-Identifier: Apache-2.0
// Drawing points of the leaves of a tree by their inverse CDFs, from the marginals of their
// coefficients.
#pragma once

#include "density/block.h"
#include "density/point.h"
#include "density/tensor.h"
#include "density/tree_descent.h"

namespace awd {

/// A leaf of more coefficients than this is refused.
constexpr std::size_t kMostLeafCoefficients = 1024;

class LeafSampler {
 public:
  LeafSampler(const BasisLevel* const* levels, const Shape& shape);

  /// Coefficients of all marginals but the last, which are the leaf's own: of axis 0, of axes 0
  /// and 1, and so on.
  std::size_t marginalSize() const { return marginalSize_; }
  void marginals(const double* coefficients, double* out) const;

  /// What leaves are drawn from: of all leaves, one after the other, none without mass.
  struct Leaves {
    const TreeDescent& descent;
    const double* coefficients;
    const double* marginals;
  };

  /// Points in the leaves of a block, from the uniforms there. pdfs: if not null, gets the leaves'
  /// values at them, with the bits of contract(); only of bases that tellsPdfs() is true of.
  template <std::size_t N>
  void sample(const Leaves& leaves, std::size_t count, const BlockDescent<N>& block, double* points,
              double* pdfs) const;
  bool tellsPdfs() const { return boxes_ || polynomials_ > 0; }

  /// A point of one leaf in one way for all bases: what sample() is tested against, bit by bit.
  template <uint32_t D>
  void sampleAny(const Leaves& leaves, uint32_t leaf, const double* uniforms, double* x) const;

 private:
  template <std::size_t N>
  void sampleBoxes(const Leaves& leaves, std::size_t count, const BlockDescent<N>& block,
                   double* points, double* pdfs) const;
  /// Axes a and after, given the R rows of those before.
  template <uint32_t O, std::size_t R, std::size_t N>
  void samplePolynomials(uint32_t a, const Leaves& leaves, std::size_t count,
                         const BlockDescent<N>& block, const BlockRows<R, N>& rows, double* points,
                         double* pdfs) const;

  /// What the marginal of axis a has for a leaf.
  const double* along(const Leaves& leaves, uint32_t leaf, uint32_t a) const {
    return a + 1 < shape_.dimensions ? leaves.marginals + leaf * marginalSize_ + marginalBegin_[a]
                                     : leaves.coefficients + leaf * leafSize_;
  }

  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  std::size_t leafSize_;
  std::size_t marginalSize_ = 0;
  std::size_t marginalBegin_[kMaxDimensions] = {};
  bool bernstein_[kMaxDimensions] = {};  ///< per axis: one polynomial, in Bernstein form
  bool boxes_ = true;                    ///< function k of any axis is 1 on its cell k
  /// The order of all axes, if each is bernstein_, and their rows are worth unrolling; else 0.
  uint32_t polynomials_ = 0;
};

}  // namespace awd

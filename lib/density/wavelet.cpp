// SPDX-License-Identifier: Apache-2.0
#include "density/wavelet.h"

#include <algorithm>
#include <cmath>

#include "basis/quadrature.h"
#include "density/gram.h"
#include "util/error.h"
#include "util/small_matrix.h"

namespace awd {

namespace {

/// Relative squared distance at which a function counts as a combination of others.
constexpr long double kDependent = 1e-9L;

SmallMatrix wide(const std::pmr::vector<double>& values, uint32_t rows, uint32_t columns) {
  SmallMatrix matrix(rows, columns);
  for (uint32_t i = 0; i < rows; ++i) {
    for (uint32_t j = 0; j < columns; ++j) matrix.at(i, j) = values[i * columns + j];
  }
  return matrix;
}

void keep(const SmallMatrix& from, std::pmr::vector<double>& to) {
  to.clear();
  for (uint32_t i = 0; i < from.rows(); ++i) {
    for (uint32_t j = 0; j < from.columns(); ++j) {
      to.push_back(static_cast<double>(from.at(i, j)));
    }
  }
}

SmallMatrix rowsOf(const SmallMatrix& from, uint32_t first, uint32_t size) {
  SmallMatrix part(size, from.columns());
  for (uint32_t i = 0; i < size; ++i) {
    for (uint32_t j = 0; j < from.columns(); ++j) part.at(i, j) = from.at(first + i, j);
  }
  return part;
}

SmallMatrix stacked(const SmallMatrix& above, const SmallMatrix& below) {
  SmallMatrix both(above.rows() + below.rows(), above.columns());
  for (uint32_t j = 0; j < above.columns(); ++j) {
    for (uint32_t i = 0; i < above.rows(); ++i) both.at(i, j) = above.at(i, j);
    for (uint32_t i = 0; i < below.rows(); ++i) both.at(above.rows() + i, j) = below.at(i, j);
  }
  return both;
}

/// The Gram matrix of the functions of two halves of a unit cell.
SmallMatrix halvesOf(const SmallMatrix& gram) {
  const uint32_t n = gram.rows();
  SmallMatrix halves(2 * n, 2 * n);
  for (uint32_t j = 0; j < n; ++j) {
    for (uint32_t k = 0; k < n; ++k) {
      halves.at(j, k) = halves.at(n + j, n + k) = 0.5L * gram.at(j, k);
    }
  }
  return halves;
}

/// Row i: int x^i N_j, i < n.
SmallMatrix momentsOf(const BasisLevel& cell) {
  SmallMatrix moments(cell.count, cell.count);
  const GaussRule gauss;
  for (uint32_t c = 0; c < cell.cells; ++c) {
    for (uint32_t g = 0; g < kMaxOrder; ++g) {
      const double x = (c + gauss.points[g]) / cell.cells;
      for (uint32_t a = 0; a < cell.alive; ++a) {
        const std::size_t row = std::size_t{c} * cell.alive + a;
        long double term =
            bernsteinValue(&cell.pieces[row * cell.order], cell.order, gauss.points[g]) *
            gauss.weights[g] / cell.cells;
        for (uint32_t i = 0; i < cell.count; ++i, term *= x) {
          moments.at(i, cell.functions[row]) += term;
        }
      }
    }
  }
  return moments;
}

/// Rows: coefficients of orthonormal functions of the cell.
SmallMatrix orthonormalOf(const Family& family, const SmallMatrix& gram,
                          const SmallMatrix& inverseGram) {
  SmallMatrix unit(gram.rows(), gram.rows());
  for (uint32_t j = 0; j < gram.rows(); ++j) unit.at(j, j) = 1.0L;
  if (family.orthogonal()) return orthonormalRows(unit, gram, kDependent);
  // Powers of x, as the functions have them, and whatever these leave out.
  return orthonormalRows(stacked(momentsOf(family.level(0)) * inverseGram, unit), gram, kDependent);
}

/// out = matrix * in
void apply(const std::pmr::vector<double>& matrix, uint32_t rows, uint32_t columns,
           const double* in, double* out) {
  const double* entry = matrix.data();
  for (uint32_t i = 0; i < rows; ++i) {
    double sum = 0.0;
    for (uint32_t j = 0; j < columns; ++j) sum += *entry++ * in[j];
    out[i] = sum;
  }
}

void gather(const double* from, uint32_t size, std::size_t stride, double* to) {
  for (uint32_t i = 0; i < size; ++i) to[i] = from[i * stride];
}

void scatter(const double* from, uint32_t size, std::size_t stride, double* to) {
  for (uint32_t i = 0; i < size; ++i) to[i * stride] = from[i];
}

/// A square matrix times one fibre.
void convert(const std::pmr::vector<double>& matrix, uint32_t n, const double* from,
             std::size_t stride, double* to) {
  double in[kMaxOrder], out[kMaxOrder];
  gather(from, n, stride, in);
  apply(matrix, n, n, in, out);
  scatter(out, n, stride, to);
}

double squares(const double* values, uint32_t size) {
  double sum = 0.0;
  for (uint32_t i = 0; i < size; ++i) sum += values[i] * values[i];
  return sum;
}

}  // namespace

WaveletFilter::WaveletFilter(std::pmr::memory_resource* memory, const Family& family)
    : n_(family.split().size),
      analysis_(memory),
      synthesis_(memory),
      split_(memory),
      loss_(memory),
      toOrthonormal_(memory),
      fromOrthonormal_(memory),
      orthonormalDetail_(memory) {
  if (!family.nested()) {
    fail(AWD_ERROR_UNSUPPORTED,
         "basis \"%s\" has no wavelets: its functions do not nest in dyadic cells; take a nested "
         "basis such as haar, f2, m2 or m3",
         family.name().c_str());
  }
  const SmallMatrix gram = wide(gramMatrix(memory, family.level(0)), n_, n_);
  const SmallMatrix halves = halvesOf(gram);
  const SmallMatrix functions = wide(family.split().functions, n_, 2 * n_);
  const SmallMatrix wavelets = wide(family.split().wavelets, n_, 2 * n_);

  SmallMatrix inverseGram = gram;
  bool regular = invert(inverseGram);
  const SmallMatrix analysis = stacked(inverseGram * functions * halves, wavelets * halves);
  SmallMatrix synthesis = analysis;
  regular = regular && invert(synthesis);
  // The cell's functions, then what else the halves have.
  const SmallMatrix all = orthonormalRows(stacked(functions, wavelets), halves, kDependent);
  if (!regular || all.rows() != 2 * n_) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST,
         "basis \"%s\": its wavelets do not determine what the halves of a cell add",
         family.name().c_str());
  }
  keep(analysis, analysis_);
  keep(synthesis, synthesis_);
  keep(transposed(functions), split_);
  keep(rowsOf(all, n_, n_) * halves, loss_);

  const SmallMatrix orthonormal = orthonormalOf(family, gram, inverseGram);
  keep(orthonormal * gram, toOrthonormal_);
  keep(transposed(orthonormal), fromOrthonormal_);

  // Rows: what each detail alone stands for.
  const SmallMatrix alone = rowsOf(transposed(synthesis), n_, n_);
  keep(orthonormalRows(alone, halves, kDependent) * halves * transposed(alone), orthonormalDetail_);
}

void WaveletFilter::analyse(const double* left, const double* right, std::size_t stride,
                            double* coarse, double* detail) const {
  double in[2 * kMaxOrder], out[2 * kMaxOrder];
  gather(left, n_, stride, in);
  gather(right, n_, stride, in + n_);
  apply(analysis_, 2 * n_, 2 * n_, in, out);
  scatter(out, n_, stride, coarse);
  scatter(out + n_, n_, stride, detail);
}

void WaveletFilter::synthesise(const double* coarse, const double* detail, std::size_t stride,
                               double* left, double* right) const {
  double in[2 * kMaxOrder], out[2 * kMaxOrder];
  gather(coarse, n_, stride, in);
  gather(detail, n_, stride, in + n_);
  apply(synthesis_, 2 * n_, 2 * n_, in, out);
  scatter(out, n_, stride, left);
  scatter(out + n_, n_, stride, right);
}

void WaveletFilter::split(const double* coarse, std::size_t stride, double* left,
                          double* right) const {
  double in[kMaxOrder], out[2 * kMaxOrder];
  gather(coarse, n_, stride, in);
  apply(split_, 2 * n_, n_, in, out);
  scatter(out, n_, stride, left);
  scatter(out + n_, n_, stride, right);
}

double WaveletFilter::detailEnergy(const double* detail, std::size_t stride) const {
  double in[kMaxOrder], out[kMaxOrder];
  gather(detail, n_, stride, in);
  apply(orthonormalDetail_, n_, n_, in, out);
  return squares(out, n_);
}

double WaveletFilter::mergeError(const double* left, const double* right,
                                 std::size_t stride) const {
  double in[2 * kMaxOrder], out[kMaxOrder];
  gather(left, n_, stride, in);
  gather(right, n_, stride, in + n_);
  apply(loss_, n_, 2 * n_, in, out);
  return squares(out, n_);
}

void WaveletFilter::toOrthonormal(const double* scaling, std::size_t stride,
                                  double* orthonormal) const {
  convert(toOrthonormal_, n_, scaling, stride, orthonormal);
}

void WaveletFilter::fromOrthonormal(const double* orthonormal, std::size_t stride,
                                    double* scaling) const {
  convert(fromOrthonormal_, n_, orthonormal, stride, scaling);
}

void WaveletFilter::toOrthonormalDetail(const double* detail, std::size_t stride,
                                        double* orthonormal) const {
  convert(orthonormalDetail_, n_, detail, stride, orthonormal);
}

}  // namespace awd

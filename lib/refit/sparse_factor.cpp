// SPDX-License-Identifier: Apache-2.0
#include "refit/sparse_factor.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <cmath>

namespace awd {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// Pivots below this are nothing but rounding: the diagonal is 1.
constexpr double kSmallestPivot = 0x1p-42;

/// S A S, its lower half.
Matrix scaledLower(const Quadratic& quadratic, const std::vector<double>& scale) {
  const int n = static_cast<int>(quadratic.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < n; ++j) {
    quadratic.forEachEntry(static_cast<uint32_t>(j), [&](uint32_t k, double value) {
      if (static_cast<int>(k) <= j) entries.emplace_back(j, k, value * scale[j] * scale[k]);
    });
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Entries of L for the permuted matrix, by its elimination tree (Liu 1990); if there are more than
/// `most`, some number above it.
uint64_t fillOf(const Matrix& lower, uint64_t most) {
  const int n = static_cast<int>(lower.rows());
  const Matrix rows = lower.transpose();  // column i: the entries of row i
  std::vector<int> parent(n, -1), seen(n, -1);
  uint64_t fill = 0;
  for (int i = 0; i < n && fill <= most; ++i) {
    seen[i] = i;
    ++fill;
    for (Matrix::InnerIterator entry(rows, i); entry; ++entry) {
      for (int k = static_cast<int>(entry.row()); k != -1 && seen[k] != i; k = parent[k]) {
        if (parent[k] == -1) parent[k] = i;
        seen[k] = i;
        ++fill;
      }
    }
  }
  return fill;
}

}  // namespace

SparseFactor sparseFactor(const Quadratic& quadratic, uint64_t mostEntries) {
  SparseFactor factor;
  const uint32_t n = quadratic.size();
  factor.scale.resize(n);
  for (uint32_t j = 0; j < n; ++j) factor.scale[j] = 1.0 / std::sqrt(quadratic.diagonal(j));
  const Matrix matrix = scaledLower(quadratic, factor.scale);

  Order order;
  Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), order);
  const Order position = order.inverse();  // of an unknown among the rows of L
  Matrix permuted(matrix.rows(), matrix.cols());
  permuted.selfadjointView<Eigen::Lower>() =
      matrix.selfadjointView<Eigen::Lower>().twistedBy(position);
  factor.entries = fillOf(permuted, mostEntries);
  if (factor.entries > mostEntries) return factor;

  const Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> cholesky(permuted);
  if (cholesky.info() != Eigen::Success) return factor;
  const Matrix lower = cholesky.matrixL();
  if (lower.diagonal().minCoeff() < std::sqrt(kSmallestPivot)) return factor;
  factor.unknown.assign(order.indices().data(), order.indices().data() + n);
  factor.lower = lower;
  return factor;
}

}  // namespace awd

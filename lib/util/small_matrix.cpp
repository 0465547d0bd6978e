// SPDX-License-Identifier: Apache-2.0
#include "util/small_matrix.h"

#include <cmath>
#include <utility>

namespace awd {

SmallMatrix operator*(const SmallMatrix& a, const SmallMatrix& b) {
  SmallMatrix product(a.rows(), b.columns());
  for (uint32_t i = 0; i < a.rows(); ++i) {
    for (uint32_t k = 0; k < a.columns(); ++k) {
      for (uint32_t j = 0; j < b.columns(); ++j) product.at(i, j) += a.at(i, k) * b.at(k, j);
    }
  }
  return product;
}

SmallMatrix transposed(const SmallMatrix& a) {
  SmallMatrix result(a.columns(), a.rows());
  for (uint32_t i = 0; i < a.rows(); ++i) {
    for (uint32_t j = 0; j < a.columns(); ++j) result.at(j, i) = a.at(i, j);
  }
  return result;
}

SmallMatrix orthonormalRows(const SmallMatrix& a, const SmallMatrix& gram, long double least) {
  const uint32_t n = a.columns();
  const auto product = [&](const SmallMatrix& x, uint32_t i, const SmallMatrix& y, uint32_t j) {
    long double sum = 0.0L;
    for (uint32_t k = 0; k < n; ++k) {
      for (uint32_t l = 0; l < n; ++l) sum += x.at(i, k) * gram.at(k, l) * y.at(j, l);
    }
    return sum;
  };
  SmallMatrix found(SmallMatrix::kMost, n);
  uint32_t size = 0;
  for (uint32_t i = 0; i < a.rows() && size < SmallMatrix::kMost; ++i) {
    SmallMatrix row(1, n);
    for (uint32_t k = 0; k < n; ++k) row.at(0, k) = a.at(i, k);
    const long double whole = product(row, 0, row, 0);
    for (int pass = 0; pass < 2; ++pass) {  // the second takes away what rounding left
      for (uint32_t j = 0; j < size; ++j) {
        const long double along = product(row, 0, found, j);
        for (uint32_t k = 0; k < n; ++k) row.at(0, k) -= along * found.at(j, k);
      }
    }
    const long double rest = product(row, 0, row, 0);
    if (!(rest > least * whole)) continue;
    for (uint32_t k = 0; k < n; ++k) found.at(size, k) = row.at(0, k) / std::sqrt(rest);
    ++size;
  }
  SmallMatrix rows(size, n);
  for (uint32_t i = 0; i < size; ++i) {
    for (uint32_t k = 0; k < n; ++k) rows.at(i, k) = found.at(i, k);
  }
  return rows;
}

bool invert(SmallMatrix& a) {
  const uint32_t n = a.rows();
  SmallMatrix inverse(n, n);
  for (uint32_t i = 0; i < n; ++i) inverse.at(i, i) = 1.0L;
  for (uint32_t column = 0; column < n; ++column) {
    uint32_t pivot = column;
    for (uint32_t i = column + 1; i < n; ++i) {
      if (std::abs(a.at(i, column)) > std::abs(a.at(pivot, column))) pivot = i;
    }
    const long double largest = a.at(pivot, column);
    if (largest == 0.0L || !std::isfinite(largest)) return false;
    for (uint32_t k = 0; k < n; ++k) {
      std::swap(a.at(column, k), a.at(pivot, k));
      std::swap(inverse.at(column, k), inverse.at(pivot, k));
      a.at(column, k) /= largest;
      inverse.at(column, k) /= largest;
    }
    for (uint32_t i = 0; i < n; ++i) {
      const long double factor = a.at(i, column);
      if (i == column || factor == 0.0L) continue;
      for (uint32_t k = 0; k < n; ++k) {
        a.at(i, k) -= factor * a.at(column, k);
        inverse.at(i, k) -= factor * inverse.at(column, k);
      }
    }
  }
  a = inverse;
  return true;
}

}  // namespace awd

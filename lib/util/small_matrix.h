// SPDX-License-Identifier: Apache-2.0
// Dense matrices of a few rows, in the widest floating-point type: what is computed once and then
// kept in double.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace awd {

class SmallMatrix {
 public:
  static constexpr uint32_t kMost = 24;  ///< rows and columns: a cell beside its two halves

  SmallMatrix(uint32_t rows, uint32_t columns) : rows_(rows), columns_(columns) {}

  uint32_t rows() const { return rows_; }
  uint32_t columns() const { return columns_; }
  long double& at(uint32_t i, uint32_t j) { return values_[std::size_t{i} * kMost + j]; }
  long double at(uint32_t i, uint32_t j) const { return values_[std::size_t{i} * kMost + j]; }

 private:
  uint32_t rows_, columns_;
  std::array<long double, std::size_t{kMost} * kMost> values_{};
};

SmallMatrix operator*(const SmallMatrix& a, const SmallMatrix& b);
SmallMatrix transposed(const SmallMatrix& a);

/// Rows that span what those of `a` do and are orthonormal: x G y^T = 0 for two of them, 1 for one
/// with itself. A row that is a combination of those before it, to a relative squared distance
/// below `least`, is left out.
SmallMatrix orthonormalRows(const SmallMatrix& a, const SmallMatrix& gram, long double least);

/// Inverts a square matrix; false if a pivot is 0 or not finite.
bool invert(SmallMatrix& a);

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// Choosing a component of a density with probability c_j w_j (eq. 4 of the paper).
#pragma once

#include <memory_resource>
#include <vector>

#include "density/tensor.h"

namespace awd {

class ComponentTable {
 public:
  /// coefficients: not negative, of positive integral.
  ComponentTable(const BasisLevel* const* levels, const Shape& shape,
                 const Coefficients& coefficients);

  /// The component for a uniform in [0,1); never one of coefficient 0.
  std::size_t choose(double uniform) const;
  std::size_t bytes() const { return cumulative_.capacity() * sizeof(double); }

 private:
  /// Sums of c_j w_j up to and with each component; exactly 1 from the last that can be chosen on.
  Coefficients cumulative_;
};

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
#include "density/component.h"

#include <algorithm>

namespace awd {

ComponentTable::ComponentTable(const BasisLevel* const* levels, const Shape& shape,
                               const Coefficients& coefficients)
    : cumulative_(coefficients, coefficients.get_allocator()) {
  timesWeights(levels, shape, cumulative_);
  double sum = 0.0;
  for (double& mass : cumulative_) mass = sum += mass;
  for (double& mass : cumulative_) mass /= sum;
  // No uniform may fall beyond the last component that can be chosen.
  for (std::size_t i = cumulative_.size(); i-- > 0;) {
    cumulative_[i] = 1.0;
    if (coefficients[i] > 0.0) break;
  }
}

std::size_t ComponentTable::choose(double uniform) const {
  return static_cast<std::size_t>(
      std::upper_bound(cumulative_.begin(), cumulative_.end(), uniform) - cumulative_.begin());
}

}  // namespace awd

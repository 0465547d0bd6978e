// SPDX-License-Identifier: Apache-2.0
#include "density/nodal_square.h"

#include "basis/family.h"
#include "density/axis.h"

namespace awd {

namespace {

constexpr uint32_t kMostCells = 32;
/// Less is as good as nothing: blended with a share of 2^-18 and squared it would leave the range
/// of floats, and a cell of some mass could seem to have none.
constexpr double kLeastCoefficient = 1e-15;

}  // namespace

bool NodalSquare::fits(const BasisLevel& level) {
  if (level.order != 2 || !hasBernsteinPieces(level)) return false;
  if (level.cells < 2 || level.cells > kMostCells || level.count != level.cells + 1) return false;
  if (level.cells & (level.cells - 1)) return false;
  for (uint32_t cell = 0; cell < level.cells; ++cell) {
    const uint32_t* functions = &level.functions[std::size_t{2} * cell];
    if (functions[0] != cell || functions[1] != cell + 1) return false;
  }
  return true;
}

std::pmr::vector<float> NodalSquare::tables(const BasisLevel& level,
                                            const std::pmr::vector<double>& coefficients) {
  const uint32_t cells = level.cells;
  const uint32_t nodes = level.count;
  std::pmr::vector<float> tables(std::size_t{cells} + nodes + std::size_t{nodes} * nodes,
                                 coefficients.get_allocator());
  float* upTo = tables.data();
  float* marginal = upTo + cells;
  float* rows = marginal + nodes;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    rows[i] = coefficients[i] < kLeastCoefficient ? 0.0f : static_cast<float>(coefficients[i]);
  }
  for (uint32_t j = 0; j < nodes; ++j) {
    double sum = 0.0;
    for (uint32_t k = 0; k < nodes; ++k) {
      sum += static_cast<double>(rows[j * nodes + k]) * level.weights[k];
    }
    marginal[j] = static_cast<float>(sum);
  }
  float sum = 0.0f;
  for (uint32_t cell = 0; cell < cells; ++cell) {
    upTo[cell] = sum += marginal[cell] + marginal[cell + 1];
  }
  return tables;
}

}  // namespace awd

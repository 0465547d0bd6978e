// SPDX-License-Identifier: Apache-2.0
// The p of a pass, grid or tree, shared by a density, its forks and its history.
#pragma once

#include "density/grid.h"
#include "density/tree_density.h"

namespace awd {

/// Exactly one of the two is there.
struct Model {
  Ref<GridDensity> grid;
  Ref<TreeDensity> tree;

  void pdf(std::size_t count, const double* points, double* pdfs) const {
    grid ? grid->pdf(count, points, pdfs) : tree->pdf(count, points, pdfs);
  }
  const Coefficients& coefficients() const {
    return grid ? grid->coefficients() : tree->coefficients();
  }
  std::size_t leaves() const { return grid ? 1 : tree->tree().leaves(); }
  double mass(const double* lower, const double* upper) const {
    return grid ? grid->mass(lower, upper) : tree->mass(lower, upper);
  }
  std::size_t bytes() const { return grid ? grid->bytes() : tree->bytes(); }
  bool operator==(const Model& other) const {
    return grid.get() == other.grid.get() && tree.get() == other.tree.get();
  }
};

}  // namespace awd

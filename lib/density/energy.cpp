// SPDX-License-Identifier: Apache-2.0
#include "density/energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "density/leaf_sampler.h"

namespace awd {

namespace {

/// The orthogonal projection one level down along an axis.
Coefficients coarsened(const DensityBases& bases, uint32_t axis, Shape& shape,
                       const Coefficients& fine) {
  const WaveletFilter& filter = *bases.axis(axis).filter;
  const std::size_t n = filter.size();
  const std::size_t stride = shape.stride(axis);
  const std::size_t count = shape.count[axis];
  Coefficients coarse(fine.size() / 2, 0.0, fine.get_allocator());
  double detail[AWD_BASIS_MAX_ORDER];
  double halves[2][AWD_BASIS_MAX_ORDER], whole[AWD_BASIS_MAX_ORDER];
  shape.forEachFibre(axis, [&](std::size_t outer, std::size_t inner) {
    for (std::size_t cell = 0; cell < count / (2 * n); ++cell) {
      const double* from = &fine[(outer * count + cell * 2 * n) * stride + inner];
      for (std::size_t j = 0; j < 2 * n; ++j) halves[j / n][j % n] = from[j * stride];
      filter.analyse(halves[0], halves[1], 1, whole, detail);
      double* to = &coarse[(outer * (count / 2) + cell * n) * stride + inner];
      for (std::size_t j = 0; j < n; ++j) to[j * stride] = whole[j];
    }
  });
  shape.count[axis] /= 2;
  return coarse;
}

double sumOfSquares(const Coefficients& c) {
  return std::inner_product(c.begin(), c.end(), c.begin(), 0.0);
}

/// The projection of a tree's density on the functions of a node, and the details below it.
class TreeEnergy {
 public:
  TreeEnergy(const DensityBases& bases, const TreeDensity& density)
      : bases_(bases), density_(density), energies_(1, 0.0, bases.memory()) {}

  Coefficients run() {
    const Coefficients root = project(0, 1.0, 0);
    energies_[0] = boxEnergy(bases_, density_.leafShape(), root.data());
    return std::move(energies_);
  }

 private:
  Coefficients project(uint32_t node, double volume, std::size_t depth) {
    const Shape& shape = density_.leafShape();
    const std::size_t size = shape.size();
    const TreeNode& at = density_.tree().nodes()[node];
    if (at.leaf()) {
      const double* c = &density_.coefficients()[at.child * size];
      return {c, c + size, bases_.memory()};
    }
    const Coefficients lower = project(at.child, 0.5 * volume, depth + 1);
    const Coefficients upper = project(at.child + 1, 0.5 * volume, depth + 1);
    Coefficients coarse(size, 0.0, bases_.memory()), detail(size, 0.0, bases_.memory());
    const std::size_t stride = shape.stride(at.axis);
    shape.forEachFibre(at.axis, [&](std::size_t outer, std::size_t inner) {
      const std::size_t fibre = outer * shape.count[at.axis] * stride + inner;
      bases_.axis(at.axis).filter->analyse(&lower[fibre], &upper[fibre], stride, &coarse[fibre],
                                           &detail[fibre]);
    });
    const double halves =
        0.5 * (boxEnergy(bases_, shape, lower.data()) + boxEnergy(bases_, shape, upper.data()));
    if (energies_.size() < depth + 2) energies_.resize(depth + 2, 0.0);
    // The projection is orthogonal: what it loses is the energy of the details.
    const double lost = halves - boxEnergy(bases_, shape, coarse.data());
    energies_[depth + 1] += volume * std::max(lost, 0.0);
    return coarse;
  }

  const DensityBases& bases_;
  const TreeDensity& density_;
  Coefficients energies_;
};

}  // namespace

void toOrthonormal(const DensityBases& bases, const Shape& shape, double* coefficients) {
  double block[AWD_BASIS_MAX_ORDER];
  for (uint32_t a = 0; a < shape.dimensions; ++a) {
    const WaveletFilter& filter = *bases.axis(a).filter;
    const std::size_t n = filter.size();
    const std::size_t stride = shape.stride(a);
    shape.forEachFibre(a, [&](std::size_t outer, std::size_t inner) {
      for (std::size_t first = 0; first < shape.count[a]; first += n) {
        double* c = coefficients + (outer * shape.count[a] + first) * stride + inner;
        for (std::size_t j = 0; j < n; ++j) block[j] = c[j * stride];
        filter.toOrthonormal(block, 1, block);
        for (std::size_t j = 0; j < n; ++j) c[j * stride] = block[j];
      }
    });
  }
}

double boxEnergy(const DensityBases& bases, const Shape& shape, const double* coefficients) {
  double c[kMostLeafCoefficients];
  const std::size_t size = shape.size();
  std::copy_n(coefficients, size, c);
  toOrthonormal(bases, shape, c);
  return std::inner_product(c, c + size, c, 0.0);
}

Coefficients gridDetailEnergy(const DensityBases& bases, const Levels& levels,
                              const Coefficients& coefficients) {
  const uint32_t d = bases.dimensions();
  Levels at = levels;
  Shape shape = bases.shape(at);
  Coefficients c(coefficients, coefficients.get_allocator());
  Coefficients energies(coefficients.get_allocator());  // finest first
  for (bool coarser = true; coarser;) {
    Coefficients orthonormal(c, c.get_allocator());
    toOrthonormal(bases, shape, orthonormal.data());
    int halvings = 0;
    for (uint32_t a = 0; a < d; ++a) halvings += static_cast<int>(at[a]);
    energies.push_back(std::ldexp(sumOfSquares(orthonormal), -halvings));
    coarser = false;
    for (uint32_t a = 0; a < d; ++a) {
      if (at[a] == 0) continue;
      c = coarsened(bases, a, shape, c);
      --at[a];
      coarser = true;
    }
  }
  std::reverse(energies.begin(), energies.end());
  for (std::size_t i = energies.size(); --i > 0;) {
    energies[i] = std::max(energies[i] - energies[i - 1], 0.0);
  }
  return energies;
}

Coefficients treeDetailEnergy(const DensityBases& bases, const TreeDensity& density) {
  return TreeEnergy(bases, density).run();
}

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
#include "density/extreme_kinds.h"

namespace awdtest {

AWDDevice extremeDevice() {
  static const Device shared = newDevice(1u);
  return shared;
}

std::vector<Kind> kinds(uint32_t dimensions, AWDDensityAxis like, uint64_t most) {
  std::vector<Kind> all;
  const auto add = [&](const char* basis, AWDDensityDesc desc, const char* structure) {
    like.basis = basis;
    desc.maxCoefficients = most;
    all.push_back({std::string(basis) + structure, Axes(dimensions, like), desc});
  };
  for (const char* basis : kFamilies) add(basis, gridDesc(), " grid");
  for (const char* basis : kNested) add(basis, treeDesc(), " tree");
  return all;
}

void expectSane(Findings& found, AWDDensity density, const std::string& name) {
  const double mass = integralOf(density);
  found.expect(std::fabs(mass - 1.0) <= 1e-12, "%s: integral 1 %+.3g", name.c_str(), mass - 1.0);
  for (const double c : coefficientsOf(density)) {
    found.expect(c >= 0.0 && std::isfinite(c), "%s: a coefficient is %g", name.c_str(), c);
  }
  Random random(99);
  const Samples samples = draw(density, 200, random);
  for (const double p : samples.pdfs) {
    found.expect(p > 0.0 && std::isfinite(p), "%s: drew p = %g", name.c_str(), p);
  }
  for (const double x : samples.points) {
    found.expect(x >= 0.0 && x < 1.0, "%s: drew x = %.17g", name.c_str(), x);
  }
  found.expect(sameBits(pdfsAt(density, samples.points), samples.pdfs), "%s: pdfs differ",
               name.c_str());
}

Function bumpOf(const Kind& kind, double scale) {
  const uint32_t d = kind.dimensions();
  return [d, scale](const double* x) { return scale * (0.1 + bump(x, d, 0.15)); };
}

}  // namespace awdtest

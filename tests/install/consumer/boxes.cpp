// SPDX-License-Identifier: Apache-2.0
// A basis in C++, whose templates and inline functions must not be seen from outside.
#include <awd/basis.h>

namespace boxes {

struct Grid {
  explicit Grid(uint32_t level) : cells(1u << level) {}
  uint32_t cells;
};

template <class T>
inline T clampedCell(uint32_t level, double x) {
  const T cell = static_cast<T>(x * Grid(level).cells);
  return cell < Grid(level).cells ? cell : Grid(level).cells - 1;
}

uint32_t AWD_CALL cells(uint32_t level) { return Grid(level).cells; }
void AWD_CALL support(uint32_t level, uint32_t j, double ab[2]) {
  ab[0] = static_cast<double>(j) / Grid(level).cells;
  ab[1] = (j + 1.0) / Grid(level).cells;
}
double AWD_CALL weight(uint32_t level, uint32_t) { return 1.0 / Grid(level).cells; }
uint32_t AWD_CALL eval(uint32_t level, double x, uint32_t* first, double* values) {
  *first = clampedCell<uint32_t>(level, x);
  values[0] = 1.0;
  return 1;
}
double AWD_CALL sample(uint32_t level, uint32_t j, const double* u) {
  return (j + u[0]) / Grid(level).cells;
}
uint32_t AWD_CALL twoScale(uint32_t, uint32_t j, uint32_t* first, double* h) {
  *first = 2 * j;
  h[0] = h[1] = 1.0;
  return 2;
}

const AWDBasisFamily family = {sizeof(AWDBasisFamily),
                               "boxes",
                               "Piecewise constant",
                               AWD_BASIS_ORTHOGONAL,
                               1,
                               1,
                               0,
                               12,
                               cells,
                               cells,
                               support,
                               weight,
                               eval,
                               sample,
                               twoScale,
                               nullptr,
                               0};
const AWDBasisFamily* const families[] = {&family};
const AWDBasisModule module = {sizeof(AWDBasisModule), AWD_BASIS_ABI, 1, "1",
                               "Apache-2.0",           families};

}  // namespace boxes

extern "C" AWD_EXPORT const AWDBasisModule* AWD_CALL AWD_BASIS_ENTRY(const AWDBasisHost*)
    AWD_NOEXCEPT {
  return &boxes::module;
}

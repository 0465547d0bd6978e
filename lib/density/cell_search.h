// SPDX-License-Identifier: Apache-2.0
// Finding the cell that a uniform falls into, among cells of known masses.
#pragma once

#include <cstdint>

namespace awd {

/// The largest power of two that is not larger.
inline uint32_t powerBelow(uint32_t number) {
  uint32_t power = 1;
  while (power <= number / 2) power *= 2;
  return power;
}

/// The last cell of any mass, up to the end of which there is no more mass than the target, as
/// uniform * total was rounded up to total. The target becomes its end.
template <class Mass, class MassUpTo>
inline uint32_t lastCell(uint32_t cells, Mass& target, const MassUpTo& massUpTo) {
  uint32_t cell = cells - 1;
  while (cell > 0 && massUpTo(cell) <= massUpTo(cell - 1)) --cell;
  target = massUpTo(cell);
  return cell;
}

/// The first cell up to whose end there is more mass than the target, without branches but for the
/// loop's. If there is none, the last one of any mass. power: powerBelow(cells).
template <class Mass, class MassUpTo>
inline uint32_t findCell(uint32_t cells, uint32_t power, Mass& target, const MassUpTo& massUpTo) {
  // Either the first or the last `power` of the cells, which is then halved.
  uint32_t cell = 0;
  if (cells > power) cell = massUpTo(cells - power - 1) <= target ? cells - power : 0;
  for (uint32_t half = power / 2; half > 0; half /= 2) {
    cell += massUpTo(cell + half - 1) <= target ? half : 0;
  }
  if (cell + 1 == cells && massUpTo(cell) <= target) return lastCell(cells, target, massUpTo);
  return cell;
}

/// The same by counting, which vectors do faster where cells are few.
template <class Mass, class MassUpTo>
inline uint32_t countCells(uint32_t cells, Mass& target, const MassUpTo& massUpTo) {
  uint32_t cell = 0;
  for (uint32_t i = 0; i < cells; ++i) cell += massUpTo(i) <= target ? 1u : 0u;
  return cell < cells ? cell : lastCell(cells, target, massUpTo);
}

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
#include "guide/light_sums.h"

namespace awd {

double LightSums::magnitude() const {
  const auto count = static_cast<double>(std::max<uint64_t>(1, samples()));
  double mean = 0.0;
  for (uint32_t i = 0; i < lights(); ++i) mean += squares(i) / count;
  return std::max(std::sqrt(mean), largest() * 0x1p-9);
}

void LightSums::add(const LightSums& other) noexcept {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    accumulate(cells_[i].sum, other.cells_[i].sum.load(kOrder));
    cells_[i].count.fetch_add(other.cells_[i].count.load(kOrder), kOrder);
  }
  addFlaws(other);
}

void LightSums::clear() noexcept {
  for (Cell& cell : cells_) {
    cell.sum.store(0, kOrder);
    cell.count.store(0, kOrder);
  }
  clearFlaws();
}

void LightSums::put(ByteWriter& writer) const {
  if (cells_.empty()) return;
  putFlaws(writer);
  for (const Cell& cell : cells_) {
    writer.putPacked(cell.count.load(kOrder));
    putSum(writer, cell.sum);
  }
}

void LightSums::get(ByteReader& reader) {
  if (cells_.empty()) return;
  getFlaws(reader);
  for (Cell& cell : cells_) {
    cell.count.store(reader.getPacked(), kOrder);
    getSum(reader, cell.sum);
  }
}

}  // namespace awd

// SPDX-License-Identifier: Apache-2.0
// The sums of a density on the square as bytes, within the frame of whoever writes them. Their
// level and their unit are known to whoever reads them.
#include <cstring>
#include <limits>

#include "density/square_statistics.h"
#include "density/square_sums.h"
#include "density/square_values.h"

namespace awd {

void FixedSums::putFlaws(ByteWriter& writer) const {
  writer.put(largest());
  writer.put(static_cast<uint8_t>(overflowed()));
  for (const std::atomic<uint64_t>& count : rejected_) writer.putPacked(count.load(kOrder));
  writer.putPacked(saturated());
}

void FixedSums::getFlaws(ByteReader& reader) {
  const double largest = reader.get(0.0, std::numeric_limits<double>::max()) + 0.0;  // of -0, 0
  uint64_t bits;
  std::memcpy(&bits, &largest, sizeof bits);
  largestBits_.store(bits, kOrder);
  overflowed_.store(reader.get<uint8_t>(0, 1) != 0, kOrder);
  for (std::atomic<uint64_t>& count : rejected_) count.store(reader.getPacked(), kOrder);
  saturated_.store(reader.getPacked(), kOrder);
}

void FixedSums::putSum(ByteWriter& writer, const std::atomic<int64_t>& sum) {
  writer.putPacked(static_cast<uint64_t>(sum.load(kOrder)));
}

void FixedSums::getSum(ByteReader& reader, std::atomic<int64_t>& sum) const {
  const auto units = static_cast<int64_t>(reader.getPacked());
  if (units < 0 && !overflowed()) reader.damaged();
  sum.store(units, kOrder);
}

void SquareValues::put(ByteWriter& writer) const {
  putFlaws(writer);
  for (std::size_t i = 0; i < components_; ++i) putSum(writer, sums_[i]);
}

void SquareValues::get(ByteReader& reader) {
  getFlaws(reader);
  for (std::size_t i = 0; i < components_; ++i) getSum(reader, sums_[i]);
}

void SquareStatistics::put(ByteWriter& writer) const {
  putFlaws(writer);
  for (std::size_t i = 0; i < components_; ++i) {
    writer.putPacked(count(i));
    putSum(writer, cells_[i].sum);
  }
}

void SquareStatistics::get(ByteReader& reader) {
  getFlaws(reader);
  for (std::size_t i = 0; i < components_; ++i) {
    cells_[i].count.store(reader.getPacked(), kOrder);
    getSum(reader, cells_[i].sum);
  }
}

void SquareSums::put(ByteWriter& writer) const {
  putFlaws(writer);
  for (std::size_t i = 0; i < size(); ++i) putSum(writer, sums_[i]);
}

void SquareSums::get(ByteReader& reader) {
  getFlaws(reader);
  for (std::size_t i = 0; i < size(); ++i) getSum(reader, sums_[i]);
}

}  // namespace awd

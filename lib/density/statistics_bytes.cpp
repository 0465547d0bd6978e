// SPDX-License-Identifier: Apache-2.0
#include "density/statistics_bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace awd {

namespace {

/// No product of a few doubles has a bin beyond these, and no sum of them a topmost bin above that.
constexpr int32_t kFarthestBin = 1024;
constexpr int64_t kMostInTopBin = int64_t{1} << 60;

void put(ByteWriter& writer, const BinnedSum& sum) {
  for (int i = 0; i < BinnedSum::kBins; ++i) writer.put(sum.bins()[i]);
  writer.put(sum.top());
}

BinnedSum getSum(ByteReader& reader) {
  int64_t bins[BinnedSum::kBins];
  for (int64_t& bin : bins) bin = reader.get<int64_t>();
  const auto top = reader.get<int32_t>();
  const BinnedSum sum(bins, top);
  const bool empty = top == BinnedSum::kEmpty && sum.zero();
  if (bins[0] > kMostInTopBin || bins[0] < -kMostInTopBin ||
      (!empty && (top > kFarthestBin || top < -kFarthestBin))) {
    reader.damaged();
  }
  return sum;
}

}  // namespace

void put(ByteWriter& writer, long double number) {
  // Only what was forged to begin with has sums beyond this.
  constexpr long double kMost = std::numeric_limits<long double>::max();
  number = std::clamp(number, -kMost, kMost);
  int exponent;
  const long double mantissa = std::frexp(number, &exponent);
  const auto high = static_cast<double>(mantissa);
  writer.put(high);
  writer.put(static_cast<double>(mantissa - high));
  writer.put(static_cast<int32_t>(exponent));
}

long double getLong(ByteReader& reader) {
  const double high = reader.get(-1.0, 1.0);
  const double low = reader.get(-1.0, 1.0);
  const auto exponent = reader.get<int32_t>(-16500, 16500);
  const long double number = std::ldexp(static_cast<long double>(high) + low, exponent);
  if (!std::isfinite(number)) reader.damaged();
  return number;
}

void put(ByteWriter& writer, const DensityStatistics& statistics) {
  const PassSums& sums = statistics.sums;
  writer.put(sums.samples);
  writer.put(sums.rejected);
  put(writer, sums.mean);
  put(writer, sums.square);
  for (const BinnedSum& cross : sums.cross) put(writer, cross);
  for (const Tally& tally : statistics.tallies) {
    put(writer, tally.value);
    put(writer, tally.weight);
    writer.put(tally.alive);
  }
  for (const BoxTally& box : statistics.boxes) {
    put(writer, box.weight);
    put(writer, box.value);
    put(writer, box.square);
  }
  for (const BinnedSum& product : statistics.normal.products) put(writer, product);
  put(writer, statistics.normal.energy);
}

void get(ByteReader& reader, DensityStatistics& statistics) {
  PassSums& sums = statistics.sums;
  sums.samples = reader.get<uint64_t>(0, BinnedSum::kMostValues / 2);
  sums.rejected = reader.get<uint64_t>(0, sums.samples);
  sums.mean = getSum(reader);
  sums.square = getSum(reader);
  for (BinnedSum& cross : sums.cross) cross = getSum(reader);
  for (Tally& tally : statistics.tallies) {
    tally.value = getSum(reader);
    tally.weight = getSum(reader);
    tally.alive = reader.get<int64_t>(0, int64_t{1} << 61);
  }
  for (BoxTally& box : statistics.boxes) {
    box.weight = getSum(reader);
    box.value = getSum(reader);
    box.square = getSum(reader);
  }
  for (BinnedSum& product : statistics.normal.products) product = getSum(reader);
  statistics.normal.energy = getSum(reader);
}

}  // namespace awd

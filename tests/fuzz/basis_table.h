// SPDX-License-Identifier: Apache-2.0
// A basis plugin whose functions answer from a fuzzer's bytes: families that are true, or nearly,
// with answers replaced here and there by anything that the ABI lets a plugin say.
#pragma once

#include <vector>

#include "awd/basis.h"
#include "bytes.h"

namespace fuzz {

/// Functions on one level, made of any non-negative Bernstein coefficients that sum to 1.
struct Mosaic {
  uint32_t cells = 1, count = 1, order = 1;
  /// Coefficient k of row a on cell c: b[(c * alive + a) * order + k].
  uint32_t alive = 1;
  std::vector<uint32_t> first;  // function of a cell's first row
  std::vector<double> b;

  void read(Bytes& bytes);
  double value(uint32_t cell, uint32_t row, double t) const;
  /// Integral over a cell up to t, in cells.
  double mass(uint32_t cell, uint32_t row, double t) const;
};

/// An answer that is not what the family says.
struct Patch {
  enum Function { kCount, kCells, kSupport, kWeight, kEval, kSample, kTwoScale, kWavelet, kLast };
  enum Change { kReplace, kAdd, kScale, kChanges };
  static constexpr uint32_t kAny = 255;

  uint32_t function, level, index;  // index: of a function, or a sixteenth of [0,1]
  uint32_t slot;                    // which of the answers; the integer if beyond the numbers
  uint32_t change;
  uint32_t integer;
  double real;
};

class BasisTable {
 public:
  /// The only table at work until it is destroyed: a plugin has no state but this.
  explicit BasisTable(Bytes& bytes);
  ~BasisTable();
  BasisTable(const BasisTable&) = delete;
  BasisTable& operator=(const BasisTable&) = delete;

  const AWDBasisModule& module() const { return module_; }
  const AWDBasisFamily& family() const { return family_; }
  /// Nothing was changed: the family is true.
  bool honest() const { return honest_; }

 private:
  friend struct Answers;

  void choose(Bytes& bytes);

  AWDBasisFamily base_ = {}, family_ = {};
  const AWDBasisFamily* families_[1] = {&family_};
  AWDBasisModule module_ = {};
  Mosaic mosaic_;
  std::vector<Patch> patches_;
  std::vector<double> wavelets_;
  bool honest_ = true;
};

}  // namespace fuzz

// SPDX-License-Identifier: Apache-2.0
// A basis family compiled into flat tables, one per level, so that the hot path never calls a
// plugin. On each of `cells` equal cells a function is a polynomial, kept by its Bernstein
// coefficients: non-negative where the function is, exact at both ends of the cell.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <string>
#include <vector>

#include "awd/basis.h"

namespace awd {

/// One level of a family on [0,1].
struct BasisLevel {
  explicit BasisLevel(std::pmr::memory_resource* memory);

  uint32_t level = 0;
  uint32_t count = 0;  ///< n, functions
  uint32_t cells = 0;  ///< equal polynomial pieces
  uint32_t order = 0;  ///< degree + 1 = Bernstein coefficients of a piece
  uint32_t alive = 0;  ///< functions alive on a cell, at most; rows of a cell's tables

  /// Function of row a on cell c: functions[c * alive + a]; rows beyond those alive repeat the
  /// first function with zero coefficients.
  std::pmr::vector<uint32_t> functions;
  /// Its Bernstein coefficients on the cell: pieces[(c * alive + a) * order + k].
  std::pmr::vector<double> pieces;
  /// w_j = int N_j
  std::pmr::vector<double> weights;

  /// The pieces of function j: entries componentBegin[j] .. componentBegin[j + 1].
  struct Piece {
    uint32_t cell;
    uint32_t row;       ///< a
    double cumulative;  ///< int of p_j up to the end of this piece; exactly 1 at the last
  };
  std::pmr::vector<uint32_t> componentBegin;
  std::pmr::vector<Piece> componentPieces;

  /// N_j = sum_k twoScale[k].value N'_{twoScale[k].fine}, k from twoScaleBegin[j] to
  /// twoScaleBegin[j + 1]; empty at the family's last level.
  struct TwoScale {
    uint32_t fine;
    double value;
  };
  std::pmr::vector<uint32_t> twoScaleBegin;
  std::pmr::vector<TwoScale> twoScale;
};

/// A cell of a nested family and its two halves. In every row are 2 n coefficients, those of the
/// n functions of the left half and then of the right.
struct BasisSplit {
  explicit BasisSplit(std::pmr::memory_resource* memory) : functions(memory), wavelets(memory) {}

  uint32_t size = 0;                   ///< n, functions of a cell; rows of both tables
  std::pmr::vector<double> functions;  ///< of N_j on the whole cell, the two-scale relation
  std::pmr::vector<double> wavelets;   ///< of psi_k
  uint32_t vanishingMoments = 0;       ///< int x^i psi_k = 0 for i below it
};

/// Tables of the levels [minLevel, maxLevel] of a family.
class Family {
 public:
  /// maxLevel is clipped to what the family has. `table` is not used after the call.
  Family(std::pmr::memory_resource* memory, const AWDBasisFamily& table, uint32_t maxLevel);

  const std::pmr::string& name() const { return name_; }
  uint32_t order() const { return order_; }
  bool periodic() const { return (flags_ & AWD_BASIS_PERIODIC) != 0; }
  bool orthogonal() const { return (flags_ & AWD_BASIS_ORTHOGONAL) != 0; }
  /// Each support lies in one dyadic cell: level l is 2^l copies of level 0, and `split` says how
  /// a cell is halved.
  bool nested() const { return (flags_ & AWD_BASIS_NESTED) != 0; }
  uint32_t minLevel() const { return minLevel_; }
  uint32_t maxLevel() const { return minLevel_ + static_cast<uint32_t>(levels_.size()) - 1; }
  const BasisLevel& level(uint32_t level) const { return levels_[level - minLevel_]; }
  /// Empty unless the family is nested.
  const BasisSplit& split() const { return split_; }

 private:
  std::pmr::string name_;
  uint32_t flags_, order_, minLevel_;
  BasisSplit split_;
  std::pmr::vector<BasisLevel> levels_;
};

}  // namespace awd

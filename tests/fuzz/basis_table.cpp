// SPDX-License-Identifier: Apache-2.0
#include "basis_table.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "honest.h"

namespace fuzz {

namespace {

const BasisTable* current = nullptr;

/// What the library may ask of a plugin is as much of a promise as what the plugin answers.
void promised(bool kept, const char* what) {
  if (kept) return;
  std::fprintf(stderr, "the library asked a plugin for what there is not: %s\n", what);
  std::abort();
}

double binomial(uint32_t n, uint32_t k) {
  double result = 1.0;
  for (uint32_t i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

}  // namespace

/// The functions of the table; those of the base are called through current->base_.
struct Answers {
  // --- Bernstein polynomials of degree q = order - 1 on every one of 2^level cells: nested -----

  static uint32_t order() { return current->base_.order; }

  static uint32_t AWD_CALL cellCells(uint32_t level) { return 1u << level; }
  static uint32_t AWD_CALL cellCount(uint32_t level) { return order() << level; }
  static void AWD_CALL cellSupport(uint32_t level, uint32_t j, double ab[2]) {
    ab[0] = static_cast<double>(j / order()) / cellCells(level);
    ab[1] = (j / order() + 1.0) / cellCells(level);
  }
  static double AWD_CALL cellWeight(uint32_t level, uint32_t) {
    return 1.0 / order() / cellCells(level);
  }
  static uint32_t AWD_CALL cellEval(uint32_t level, double x, uint32_t* first, double* values) {
    const uint32_t q = order() - 1;
    const uint32_t cell = std::min(static_cast<uint32_t>(x * cellCells(level)), (1u << level) - 1);
    const double t = x * cellCells(level) - cell;
    *first = cell * order();
    values[0] = 1.0;
    for (uint32_t degree = 1; degree <= q; ++degree) {
      values[degree] = t * values[degree - 1];
      for (uint32_t i = degree - 1; i > 0; --i) {
        values[i] = (1.0 - t) * values[i] + t * values[i - 1];
      }
      values[0] *= 1.0 - t;
    }
    return order();
  }
  static double AWD_CALL cellSample(uint32_t level, uint32_t j, const double* u) {
    double sorted[AWD_BASIS_MAX_ORDER];  // B_i over its mass is the law of order statistic i
    std::copy(u, u + order(), sorted);
    std::sort(sorted, sorted + order());
    return (j / order() + sorted[j % order()]) / cellCells(level);
  }
  static uint32_t AWD_CALL cellTwoScale(uint32_t, uint32_t j, uint32_t* first, double* h) {
    const uint32_t q = order() - 1, i = j % order();
    *first = 2 * (j - i);
    for (uint32_t m = 0; m <= q; ++m) {  // de Casteljau at 1/2
      h[m] = m >= i ? binomial(m, i) * std::ldexp(1.0, -static_cast<int>(m)) : 0.0;
      h[order() + m] =
          i >= m ? binomial(q - m, i - m) * std::ldexp(1.0, static_cast<int>(m - q)) : 0.0;
    }
    return 2 * order();
  }

  // --- the mosaic
  // ---------------------------------------------------------------------------------

  static const Mosaic& mosaic() { return current->mosaic_; }
  /// Row of a function on a cell, or `alive` if there is none.
  static uint32_t row(uint32_t cell, uint32_t j) {
    const uint32_t from = mosaic().first[cell];
    return j >= from && j - from < mosaic().alive ? j - from : mosaic().alive;
  }
  static double massOn(uint32_t cell, uint32_t j, double t) {
    const uint32_t at = row(cell, j);
    return at < mosaic().alive ? mosaic().mass(cell, at, t) : 0.0;
  }

  static uint32_t AWD_CALL mosaicCells(uint32_t) { return mosaic().cells; }
  static uint32_t AWD_CALL mosaicCount(uint32_t) { return mosaic().count; }
  static void AWD_CALL mosaicSupport(uint32_t, uint32_t j, double ab[2]) {
    uint32_t begin = mosaic().cells, end = 0;
    for (uint32_t c = 0; c < mosaic().cells; ++c) {
      if (massOn(c, j, 1.0) <= 1e-15) continue;
      begin = std::min(begin, c);
      end = c + 1;
    }
    ab[0] = static_cast<double>(begin) / mosaic().cells;
    ab[1] = static_cast<double>(end) / mosaic().cells;
  }
  static double AWD_CALL mosaicWeight(uint32_t, uint32_t j) {
    double sum = 0.0;
    for (uint32_t c = 0; c < mosaic().cells; ++c) sum += massOn(c, j, 1.0);
    return sum / mosaic().cells;
  }
  static uint32_t AWD_CALL mosaicEval(uint32_t, double x, uint32_t* first, double* values) {
    const Mosaic& m = mosaic();
    const uint32_t cell = std::min(static_cast<uint32_t>(x * m.cells), m.cells - 1);
    const double t = std::min(std::max(x * m.cells - cell, 0.0), 1.0);
    *first = m.first[cell];
    for (uint32_t a = 0; a < m.alive; ++a) values[a] = m.value(cell, a, t);
    return m.alive;
  }
  static double AWD_CALL mosaicSample(uint32_t level, uint32_t j, const double* u) {
    const Mosaic& m = mosaic();
    double rest = u[0] * mosaicWeight(level, j) * m.cells;
    uint32_t cell = 0, last = 0;
    for (uint32_t c = 0; c < m.cells; ++c) {
      const double mass = massOn(c, j, 1.0);
      if (mass <= 0.0) continue;
      last = cell = c;
      if (rest < mass) break;
      rest -= mass;
    }
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 24; ++i) {
      const double t = 0.5 * (low + high);
      (massOn(cell, j, t) < rest ? low : high) = t;
    }
    return (last + low) / m.cells;
  }
  static uint32_t AWD_CALL noTwoScale(uint32_t, uint32_t, uint32_t* first, double* h) {
    *first = 0;
    h[0] = 1.0;
    return 1;
  }

  // --- what the library calls
  // ---------------------------------------------------------------------

  static void checkLevel(uint32_t level) {
    promised(level >= current->family_.minLevel && level <= current->family_.maxLevel, "a level");
  }
  static void checkFunction(uint32_t level, uint32_t j) {
    checkLevel(level);
    promised(j < count(level), "a function");
  }

  template <class Body>
  static void patches(uint32_t function, uint32_t level, uint32_t index, const Body& body) {
    for (const Patch& patch : current->patches_) {
      if (patch.function != function) continue;
      if (patch.level != Patch::kAny && patch.level != level) continue;
      if (patch.index != Patch::kAny && patch.index != index) continue;
      body(patch);
    }
  }
  static uint32_t changed(uint32_t value, const Patch& patch) {
    return patch.change == Patch::kReplace ? patch.integer
           : patch.change == Patch::kAdd   ? value + patch.integer
                                           : value * patch.integer;
  }
  static double changed(double value, const Patch& patch) {
    return patch.change == Patch::kReplace ? patch.real
           : patch.change == Patch::kAdd   ? value + patch.real
                                           : value * patch.real;
  }

  static uint32_t AWD_CALL count(uint32_t level) {
    checkLevel(level);
    uint32_t value = current->base_.count(level);
    patches(Patch::kCount, level, 0, [&](const Patch& patch) { value = changed(value, patch); });
    return value;
  }
  static uint32_t AWD_CALL cells(uint32_t level) {
    checkLevel(level);
    uint32_t value = current->base_.cells(level);
    patches(Patch::kCells, level, 0, [&](const Patch& patch) { value = changed(value, patch); });
    return value;
  }
  static void AWD_CALL support(uint32_t level, uint32_t j, double ab[2]) {
    checkFunction(level, j);
    current->base_.support(level, j, ab);
    patches(Patch::kSupport, level, j,
            [&](const Patch& patch) { ab[patch.slot % 2] = changed(ab[patch.slot % 2], patch); });
  }
  static double AWD_CALL weight(uint32_t level, uint32_t j) {
    checkFunction(level, j);
    double value = current->base_.weight(level, j);
    patches(Patch::kWeight, level, j, [&](const Patch& patch) { value = changed(value, patch); });
    return value;
  }
  static uint32_t AWD_CALL eval(uint32_t level, double x, uint32_t* first, double* values) {
    checkLevel(level);
    promised(x >= 0.0 && x <= 1.0, "a place");
    uint32_t size = current->base_.eval(level, x, first, values);
    patches(Patch::kEval, level, static_cast<uint32_t>(x * 16.0), [&](const Patch& patch) {
      const uint32_t slot = patch.slot % (AWD_BASIS_MAX_ORDER + 2);
      if (slot < AWD_BASIS_MAX_ORDER) {
        values[slot] = changed(values[slot], patch);
      } else {
        uint32_t& number = slot == AWD_BASIS_MAX_ORDER ? size : *first;
        number = changed(number, patch);
      }
    });
    return size;
  }
  static double AWD_CALL sample(uint32_t level, uint32_t j, const double* u) {
    checkFunction(level, j);
    for (uint32_t i = 0; i < current->family_.sampleDims; ++i) {
      promised(u[i] >= 0.0 && u[i] < 1.0, "a uniform");
    }
    double padded[AWD_BASIS_MAX_ORDER] = {0.0};
    std::copy(u, u + current->family_.sampleDims, padded);
    double value = current->base_.sample(level, j, padded);
    patches(Patch::kSample, level, j, [&](const Patch& patch) { value = changed(value, patch); });
    return value;
  }
  static uint32_t AWD_CALL twoScale(uint32_t level, uint32_t j, uint32_t* first, double* h) {
    checkFunction(level, j);
    promised(level < current->family_.maxLevel, "a level to refine to");
    uint32_t size = current->base_.twoScale(level, j, first, h);
    patches(Patch::kTwoScale, level, j, [&](const Patch& patch) {
      const uint32_t slot = patch.slot % (2 * AWD_BASIS_MAX_ORDER + 2);
      if (slot < 2 * AWD_BASIS_MAX_ORDER) {
        h[slot] = changed(h[slot], patch);
      } else {
        uint32_t& number = slot == 2 * AWD_BASIS_MAX_ORDER ? size : *first;
        number = changed(number, patch);
      }
    });
    return size;
  }
  static void AWD_CALL wavelet(uint32_t k, double* g) {
    const uint32_t size = count(1);
    promised(k < count(0), "a wavelet");
    promised(size <= 2 * AWD_BASIS_MAX_ORDER, "room for a wavelet");
    const std::vector<double>& given = current->wavelets_;
    for (uint32_t i = 0; i < size; ++i) {
      g[i] = given.empty() ? 0.0 : given[(k * size + i) % given.size()];
    }
    patches(Patch::kWavelet, 0, k, [&](const Patch& patch) {
      g[patch.slot % size] = changed(g[patch.slot % size], patch);
    });
  }
};

void BasisTable::choose(Bytes& bytes) {
  const uint32_t kind = bytes.below(6);
  if (kind < 3) {
    base_ = *honestModule()->families[kind];
    base_.maxLevel = kind == 2 ? 12 : base_.maxLevel;
  } else if (kind < 5) {
    base_ = {sizeof(AWDBasisFamily),
             nullptr,
             nullptr,
             AWD_BASIS_NESTED,
             1 + bytes.below(8),
             0,
             0,
             AWD_BASIS_MAX_LEVEL - 1,
             Answers::cellCount,
             Answers::cellCells,
             Answers::cellSupport,
             Answers::cellWeight,
             Answers::cellEval,
             Answers::cellSample,
             Answers::cellTwoScale,
             nullptr,
             0};
    base_.sampleDims = base_.order;
    if (base_.order == 1) {
      base_.flags |= AWD_BASIS_ORTHOGONAL;
      if (bytes.below(2)) {
        base_.wavelet = Answers::wavelet;
        base_.vanishingMoments = 1;
        wavelets_ = {1.0, -1.0};
      }
    }
  } else {
    mosaic_.read(bytes);
    base_ = {sizeof(AWDBasisFamily),
             nullptr,
             nullptr,
             0,
             mosaic_.order,
             1,
             0,
             0,
             Answers::mosaicCount,
             Answers::mosaicCells,
             Answers::mosaicSupport,
             Answers::mosaicWeight,
             Answers::mosaicEval,
             Answers::mosaicSample,
             Answers::noTwoScale,
             nullptr,
             0};
    honest_ = false;  // its functions may depend on each other
  }
  base_.name = "fuzzed";
  base_.summary = "Whatever came";
  // Few levels mostly: they are all alike, and take time.
  base_.maxLevel = std::min(base_.maxLevel, bytes.below(64) ? bytes.below(3) : 20);
  if ((base_.flags & AWD_BASIS_NESTED) && base_.maxLevel == 0) base_.maxLevel = 1;
}

BasisTable::BasisTable(Bytes& bytes) {
  current = this;
  choose(bytes);
  family_ = base_;
  family_.count = Answers::count;
  family_.cells = Answers::cells;
  family_.support = Answers::support;
  family_.weight = Answers::weight;
  family_.eval = Answers::eval;
  family_.sample = Answers::sample;
  family_.twoScale = Answers::twoScale;

  // Now and then the head of the table is another.
  const uint32_t head = bytes.byte();
  if (head >= 224) {
    honest_ = false;
    if (head & 1) family_.flags = bytes.below(16);
    if (head & 2) family_.order = bytes.below(10);
    if (head & 4) family_.sampleDims = bytes.below(10);
    if (head & 8) {
      family_.minLevel = bytes.below(23);
      family_.maxLevel = family_.minLevel + bytes.below(3);
    }
    if (head & 16 && bytes.below(2)) {
      family_.wavelet = Answers::wavelet;
      family_.vanishingMoments = bytes.below(10);
      for (uint32_t i = bytes.below(16); i > 0; --i) wavelets_.push_back(bytes.real());
    }
  }
  while (!bytes.empty() && patches_.size() < 16) {
    Patch patch = {};
    patch.function = bytes.below(Patch::kLast);
    const uint32_t where = bytes.byte();
    patch.level = where & 1 ? Patch::kAny : family_.minLevel + (where >> 1) % 4;
    patch.index = where & 8 ? Patch::kAny : bytes.below(16);
    patch.slot = bytes.byte();
    patch.change = bytes.below(Patch::kChanges);
    patch.integer = bytes.integer();
    patch.real = bytes.real();
    patches_.push_back(patch);
    honest_ = false;
  }
  module_ = {sizeof(AWDBasisModule), AWD_BASIS_ABI, 1, "1", "Apache-2.0", families_};
}

BasisTable::~BasisTable() { current = nullptr; }

}  // namespace fuzz

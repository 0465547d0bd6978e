// SPDX-License-Identifier: Apache-2.0
#include "basis/self_test.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <new>
#include <string>

#include "basis/checks.h"
#include "util/error.h"

namespace awd {

namespace {

constexpr uint32_t kMostCells = 1u << 21;
/// Levels above the lowest that are tested in full.
constexpr uint32_t kFullLevels = 5;
/// Cells and functions that are looked at on the two highest levels, and on those in between.
constexpr uint32_t kSpots = 64, kFewSpots = 16;
/// Levels above the lowest at which samples are counted, and the highest besides.
constexpr uint32_t kCountedLevels = 3;

uint32_t spotsOf(const AWDBasisFamily& family, const TableLevel& level, bool whole) {
  if (whole) return kWhole;
  return level.level + 1 >= family.maxLevel ? kSpots : kFewSpots;
}

bool isName(const char* name) {
  const std::size_t length = strnlen(name, 65);
  if (length < 1 || length > 64 || name[0] < 'a' || name[0] > 'z') return false;
  return std::all_of(name, name + length, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
  });
}

bool isLine(const char* text) {
  const std::size_t length = strnlen(text, 201);
  return length <= 200 && std::none_of(text, text + length,
                                       [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// What the table says of itself, without calling any of its functions.
void checkTable(const AWDBasisFamily& family, Check& check) {
  const auto require = [&](bool holds, const char* format, auto... values) {
    if (!holds && check.fails(1.0)) check.say(format, values...);
  };
  require(family.name && isName(family.name), "%s", "name does not match ^[a-z][a-z0-9_.-]{0,63}$");
  require(family.summary && isLine(family.summary), "%s",
          "summary is not a line of at most 200 characters");
  constexpr uint32_t known = AWD_BASIS_ORTHOGONAL | AWD_BASIS_PERIODIC | AWD_BASIS_NESTED;
  require((family.flags & ~known) == 0, "flags 0x%x: only 0x%x are known", family.flags, known);
  require(family.order >= 1 && family.order <= kMaxOrder, "order is %u: it must be 1 to %u",
          family.order, kMaxOrder);
  require(family.sampleDims >= 1 && family.sampleDims <= kMaxOrder,
          "sampleDims is %u: it must be 1 to %u", family.sampleDims, kMaxOrder);
  require(family.minLevel <= family.maxLevel && family.maxLevel <= AWD_BASIS_MAX_LEVEL,
          "levels %u to %u: they must be an ascending range up to %u", family.minLevel,
          family.maxLevel, AWD_BASIS_MAX_LEVEL);
  require(family.count && family.cells && family.support && family.weight && family.eval &&
              family.sample && family.twoScale,
          "%s", "a function of the table is NULL");
  require(!family.wavelet || (family.flags & AWD_BASIS_NESTED), "%s",
          "wavelets are given without the flag NESTED");
  require(family.wavelet || family.vanishingMoments == 0,
          "vanishingMoments is %u: it must be 0 without wavelets", family.vanishingMoments);
  require(!family.wavelet || (family.vanishingMoments >= 1 && family.vanishingMoments <= kMaxOrder),
          "vanishingMoments is %u: it must be 1 to %u with wavelets", family.vanishingMoments,
          kMaxOrder);
}

/// Numbers of cells and functions that no table of ours would choke on.
void checkSizes(const AWDBasisFamily& family, Check& check) {
  for (uint32_t l = family.minLevel; l <= family.maxLevel; ++l) {
    const TableLevel level(family, l);
    const uint32_t most = l == family.minLevel ? kWhole : kMostCells;
    if ((level.cells < 1 || level.cells > most) && check.fails(1.0)) {
      check.say("cells out of range: level %u: got %u, want 1 to %u", l, level.cells, most);
    }
    // More functions than this can't be independent.
    const uint64_t functions = uint64_t{level.cells} * family.order;
    if ((level.count < 1 || level.count > functions) && check.fails(1.0)) {
      check.say("count out of range: level %u: got %u, want 1 to %llu", l, level.count,
                static_cast<unsigned long long>(functions));
    }
  }
}

}  // namespace

std::vector<uint32_t> spread(uint32_t size, uint32_t limit) {
  std::vector<uint32_t> chosen;
  if (size <= limit) {
    for (uint32_t i = 0; i < size; ++i) chosen.push_back(i);
    return chosen;
  }
  const uint32_t end = limit / 4, middle = limit - 2 * end;
  for (uint32_t i = 0; i < end; ++i) chosen.push_back(i);
  for (uint32_t i = 0; i < middle; ++i) {
    chosen.push_back(end + static_cast<uint32_t>(uint64_t{size - 2 * end} * i / middle));
  }
  for (uint32_t i = size - end; i < size; ++i) chosen.push_back(i);
  return chosen;
}

TestedLevel::TestedLevel(const AWDBasisFamily& family, uint32_t l)
    : TableLevel(family, l),
      whole(l <= family.minLevel + kFullLevels && cells <= kWhole && count <= kWhole),
      someCells(spread(cells, spotsOf(family, *this, whole))),
      someFunctions(spread(count, spotsOf(family, *this, whole))) {}

std::vector<Check> selfTest(const AWDBasisFamily& family, bool toTheEnd) {
  std::vector<Check> checks;
  const auto run = [&](const char* name, double limit, const auto& body) {
    if (!toTheEnd && firstFailure(checks)) return false;
    Check& check = checks.emplace_back(name, limit);
    try {
      body(check);
    } catch (const Error& error) {
      check.broken(error.what());
    } catch (const std::bad_alloc&) {
      throw std::bad_alloc();  // not one of the module's own, which may be closed before it is
                               // caught
    } catch (const std::exception& error) {
      check.broken(std::string("a function of the table throws an exception: ") + error.what());
    } catch (...) {
      check.broken("a function of the table throws an exception");
    }
    return check.ok();
  };
  if (!run("table", 0.0, [&](Check& check) { checkTable(family, check); })) return checks;
  if (!run("sizes", 0.0, [&](Check& check) { checkSizes(family, check); })) return checks;

  std::vector<TestedLevel> levels;
  for (uint32_t l = family.minLevel; l <= family.maxLevel; ++l) levels.emplace_back(family, l);

  using LevelCheck = void (*)(const TestedLevel&, Check&);
  const auto everyLevel = [&](LevelCheck body) {
    return [&, body](Check& check) {
      for (const TestedLevel& level : levels) body(level, check);
    };
  };
  const auto wholeLevels = [&](LevelCheck body) {
    return [&, body](Check& check) {
      for (const TestedLevel& level : levels) {
        if (level.whole) body(level, check);
      }
    };
  };
  const auto lowestAndHighest = [&](LevelCheck body) {
    return [&, body](Check& check) {
      for (const TestedLevel& level : levels) {
        const bool lowest = level.level <= family.minLevel + kCountedLevels;
        if (lowest || level.level == family.maxLevel) body(level, check);
      }
    };
  };
  using FinerCheck = void (*)(const TestedLevel&, const TableLevel&, Check&);
  const auto everyStep = [&](FinerCheck body) {
    return [&, body](Check& check) {
      for (const TestedLevel& level : levels) {
        if (level.level < family.maxLevel) {
          body(level, TableLevel(family, level.level + 1), check);
        }
      }
    };
  };

  if (!run("values", 1e-15, everyLevel(checkValues))) return checks;
  run("partition of unity", 1e-12, everyLevel(checkUnity));
  run("polynomial", 1e-11, everyLevel(checkPolynomial));
  run("coefficients", 1e-12, everyLevel(checkCoefficients));
  run("support", 1e-12, everyLevel(checkSupport));
  run("weight", 1e-11, everyLevel(checkWeights));
  run("two-scale", 1e-11, everyStep(checkTwoScale));
  run("two-scale mass", 1e-11, everyStep(checkTwoScaleMass));
  run("samples", 1e-8, everyLevel(checkSamples));
  run("distribution", 1.0, lowestAndHighest(checkDistribution));
  run("gram", 1e8, wholeLevels(checkGram));
  if (family.flags & AWD_BASIS_ORTHOGONAL) {
    run("orthogonal", 1e-12, wholeLevels(checkOrthogonal));
  }
  if (family.flags & AWD_BASIS_PERIODIC) run("periodic", 1e-11, wholeLevels(checkPeriodic));
  if (family.flags & AWD_BASIS_NESTED) {
    if (!run("nested", 1e-9, everyLevel(checkNested))) return checks;
    const auto once = [&](void (*body)(const AWDBasisFamily&, Check&)) {
      return [&, body](Check& check) { body(family, check); };
    };
    if (!run("tree sizes", 0.0, once(checkTreeSizes))) return checks;
    if (!run("copies", 1e-11, everyLevel(checkCopies)) || !family.wavelet) return checks;
    if (!run("vanishing moments", 1e-12, once(checkVanishingMoments))) return checks;
    run("wavelets", 1e8, once(checkWavelets));
  }
  return checks;
}

const Check* firstFailure(const std::vector<Check>& checks) {
  for (const Check& check : checks) {
    if (!check.ok()) return &check;
  }
  return nullptr;
}

}  // namespace awd

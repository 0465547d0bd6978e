// SPDX-License-Identifier: Apache-2.0
// The families that we ship, once more: by Cox and de Boor's recursion, knot insertion and de
// Casteljau's algorithm, in exact fractions. Nothing here knows how the plugins do it.
#pragma once

#include <string>
#include <vector>

#include "density/rational.h"

namespace awd {

using RationalMatrix = std::vector<std::vector<Rational>>;

/// One level of a family: function j on cell c is the polynomial pieces[j][c] of t in [0,1].
struct ExactLevel {
  uint32_t count = 0, cells = 0;
  std::vector<std::vector<Polynomial>> pieces;

  ExactLevel(uint32_t functions, uint32_t cellCount)
      : count(functions), cells(cellCount), pieces(count, std::vector<Polynomial>(cells)) {}
  Rational weight(uint32_t j) const {
    Rational sum;
    for (const Polynomial& p : pieces[j]) sum = sum + integralTo(p, 1);
    return sum / Rational(cells);
  }
  Rational product(uint32_t j, uint32_t k) const {
    Rational sum;
    for (uint32_t c = 0; c < cells; ++c) sum = sum + integralTo(pieces[j][c] * pieces[k][c], 1);
    return sum / Rational(cells);
  }
  RationalMatrix gram() const {
    RationalMatrix matrix(count, std::vector<Rational>(count));
    for (uint32_t j = 0; j < count; ++j) {
      for (uint32_t k = 0; k < count; ++k) matrix[j][k] = product(j, k);
    }
    return matrix;
  }
};

/// B-spline i of degree q on the cell [c, c+1], by Cox and de Boor's recursion; knots in cells.
inline Polynomial coxDeBoor(const std::vector<Rational>& knots, std::size_t i, uint32_t q,
                            int64_t c) {
  const auto between = [&](std::size_t a, std::size_t b) { return knots[b] - knots[a]; };
  if (q == 0) {
    const bool here = knots[i].value() <= static_cast<double>(c) &&
                      static_cast<double>(c + 1) <= knots[i + 1].value();
    return here ? Polynomial{1} : Polynomial{};
  }
  Polynomial sum;
  if (const Rational width = between(i, i + q); !(width == Rational(0))) {
    const Polynomial rising = {(Rational(c) - knots[i]) / width, Rational(1) / width};
    sum = sum + rising * coxDeBoor(knots, i, q - 1, c);
  }
  if (const Rational width = between(i + 1, i + q + 1); !(width == Rational(0))) {
    const Polynomial falling = {(knots[i + q + 1] - Rational(c)) / width, Rational(-1) / width};
    sum = sum + falling * coxDeBoor(knots, i + 1, q - 1, c);
  }
  return sum;
}

/// Knots of a clamped axis in cells: both ends q + 1 times.
inline std::vector<Rational> clampedKnots(uint32_t q, uint32_t cells) {
  std::vector<Rational> knots(q, Rational(0));
  for (uint32_t i = 0; i <= cells; ++i) knots.emplace_back(i);
  knots.insert(knots.end(), q, Rational(cells));
  return knots;
}

/// Knots of a circle, unrolled: from `around` cells before it to as many behind.
inline std::vector<Rational> unrolledKnots(uint32_t around, uint32_t cells) {
  std::vector<Rational> knots;
  for (int64_t i = -int64_t{around}; i <= int64_t{cells} + around; ++i) knots.emplace_back(i);
  return knots;
}

/// Boehm: the coefficients after inserting a knot, of the function with these before.
inline std::vector<Rational> insertKnot(std::vector<Rational>& knots, uint32_t q, const Rational& x,
                                        const std::vector<Rational>& before) {
  std::size_t k = 0;
  while (!(knots[k].value() <= x.value() && x.value() < knots[k + 1].value())) ++k;
  std::vector<Rational> after;
  for (std::size_t i = 0; i <= before.size(); ++i) {
    if (i + q <= k) {
      after.push_back(before[i]);
    } else if (i > k) {
      after.push_back(before[i - 1]);
    } else {
      const Rational share = (x - knots[i]) / (knots[i + q] - knots[i]);
      const Rational here = i < before.size() ? before[i] : Rational(0);
      const Rational left = i > 0 ? before[i - 1] : Rational(0);
      after.push_back(share * here + (Rational(1) - share) * left);
    }
  }
  knots.insert(knots.begin() + static_cast<std::ptrdiff_t>(k) + 1, x);
  return after;
}

/// Function i as a combination of those with a knot in the middle of every cell.
inline std::vector<Rational> halvedCells(std::vector<Rational> knots, uint32_t q, std::size_t i) {
  std::vector<Rational> row(knots.size() - q - 1);
  row[i] = 1;
  const std::vector<Rational> old = knots;
  for (std::size_t k = 0; k + 1 < old.size(); ++k) {
    if (old[k] == old[k + 1]) continue;
    row = insertKnot(knots, q, (old[k] + old[k + 1]) / Rational(2), row);
  }
  return row;
}

/// What the family of a name is.
struct ExactFamily {
  uint32_t degree;  // of B-splines, or of the Bernstein polynomials of a cell
  bool spline, periodic;
  uint32_t boxes;  // cells at level 0

  explicit ExactFamily(const std::string& name)
      : degree(name[0] == 'l' || name == "m2"   ? 1
               : name[0] == 'q' || name == "m3" ? 2
                                                : 0),
        spline(name.find("bspline") != std::string::npos),
        periodic(name.find("periodic") != std::string::npos),
        boxes(name == "f2" ? 2 : 1) {}

  uint32_t cells(uint32_t level) const { return boxes << level; }

  ExactLevel level(uint32_t l) const {
    if (!spline) return bernstein(l);
    const uint32_t n = cells(l), q = degree;
    if (!periodic) {
      ExactLevel result(n + q, n);
      for (uint32_t j = 0; j < result.count; ++j) {
        for (uint32_t c = 0; c < n; ++c) {
          result.pieces[j][c] = coxDeBoor(clampedKnots(q, n), j, q, c);
        }
      }
      return result;
    }
    // Function j lives on the cells j - q to j; its copies all around add up.
    ExactLevel result(n, n);
    const uint32_t around = 2 * q + 2;
    const std::vector<Rational> knots = unrolledKnots(around, n);
    for (std::size_t i = 0; i + q + 1 < knots.size(); ++i) {
      const uint32_t j = (static_cast<uint32_t>(i) + q + 4 * n * around - around) % n;
      for (uint32_t c = 0; c < n; ++c) {
        result.pieces[j][c] = result.pieces[j][c] + coxDeBoor(knots, i, q, c);
      }
    }
    return result;
  }

  /// N_j = sum_k h[j][k] N'_k
  RationalMatrix twoScale(uint32_t l) const {
    const uint32_t n = cells(l), q = degree;
    if (!spline) return deCasteljau(l);
    RationalMatrix h;
    if (!periodic) {
      for (uint32_t j = 0; j < n + q; ++j) h.push_back(halvedCells(clampedKnots(q, n), q, j));
      return h;
    }
    const uint32_t around = 2 * q + 2;
    for (uint32_t j = 0; j < n; ++j) {
      // Spline i of the line begins at cell i - around; the first of the finer ones as well.
      const std::vector<Rational> row = halvedCells(unrolledKnots(around, n), q, j + around - q);
      std::vector<Rational> wrapped(2 * n);
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::size_t k = (i + q + 8 * std::size_t{n} * around - 2 * around) % (2 * n);
        wrapped[k] = wrapped[k] + row[i];
      }
      h.push_back(wrapped);
    }
    return h;
  }

 private:
  ExactLevel bernstein(uint32_t l) const {
    const uint32_t n = cells(l), k = degree + 1;
    ExactLevel result(k * n, n);
    for (uint32_t j = 0; j < result.count; ++j) {
      Polynomial p = {degree == 2 && j % k == 1 ? 2 : 1};
      for (uint32_t i = 0; i < degree; ++i)
        p = p * (i < j % k ? Polynomial{0, 1} : Polynomial{1, -1});
      result.pieces[j][j / k] = p;
    }
    return result;
  }

  RationalMatrix deCasteljau(uint32_t l) const {
    const uint32_t n = cells(l), k = degree + 1;
    RationalMatrix h(k * n, std::vector<Rational>(2 * k * n));
    for (uint32_t j = 0; j < k * n; ++j) {
      std::vector<Rational> row(k);
      row[j % k] = 1;
      const uint32_t first = 2 * k * (j / k), last = first + 2 * k - 1;
      for (uint32_t step = 0; step < k; ++step) {
        h[j][first + step] = row.front();
        h[j][last - step] = row.back();
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
          row[i] = (row[i] + row[i + 1]) / Rational(2);
        }
        row.pop_back();
      }
    }
    return h;
  }
};

}  // namespace awd
